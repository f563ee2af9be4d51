#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <utility>
#include <vector>

namespace depixel::bench {

/// The middle of some samples (of an even number, the upper one). At least one sample.
inline double median(std::vector<double> samples) {
  const auto middle = samples.begin() + std::ptrdiff_t(samples.size() / 2);
  std::nth_element(samples.begin(), middle, samples.end());
  return *middle;
}

/// The median of quotients of two contestants' times, each of the same round: a machine whose speed changes
/// from round to round changes both alike. At least one round.
inline double median_ratio(const std::vector<double>& of, const std::vector<double>& to) {
  std::vector<double> quotients(of.size());
  std::transform(of.begin(), of.end(), to.begin(), quotients.begin(), std::divides());
  return median(std::move(quotients));
}

/// Wall-clock milliseconds that a call takes.
template <typename Work>
double time_ms(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Calls round() at least min_rounds times and until the seconds have passed.
template <typename Round>
void repeat_for(double seconds, int min_rounds, Round&& round) {
  double spent_ms = 0;
  for (int done = 0; done < min_rounds || spent_ms < 1000 * seconds; ++done) spent_ms += time_ms(round);
}

}  // namespace depixel::bench
