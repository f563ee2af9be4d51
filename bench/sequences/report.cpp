#include "bench/sequences/report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "bench/sequences/samples.hpp"

namespace depixel::bench {
namespace {

/// What the table and the JSON object say of a sequence.
struct Summary {
  explicit Summary(const SequenceTiming& timing)
      : to_xbr(ratios(timing.incremental_ms, timing.xbr4_ms)),
        to_scratch(ratios(timing.incremental_ms, timing.scratch_ms)),
        scratch_to_xbr(ratios(timing.scratch_ms, timing.xbr4_ms)) {}

  std::vector<double> to_xbr, to_scratch, scratch_to_xbr;
};

void print_softfilters(const SequenceTiming& timing) {
  for (const SoftFilterTiming& filter : timing.softfilters) {
    fmt::print("  {:<27} to {:>4} x {:<4} {:>7.3f} ms, incremental {:.2f} times that\n", filter.name,
               filter.out_width, filter.out_height, median(filter.ms),
               median(ratios(timing.incremental_ms, filter.ms)));
  }
}

void print_repeats(const SequenceTiming& timing) {
  std::vector<double> incremental_ms, compare_ms;
  for (std::size_t i = 0; i < timing.is_repeat.size(); ++i) {
    if (!timing.is_repeat[i]) continue;
    incremental_ms.push_back(timing.incremental_ms[i]);
    compare_ms.push_back(timing.compare_ms[i]);
  }
  if (incremental_ms.empty()) return;
  fmt::print("  frames like the one before: {}, incremental {:.4f} ms, {:.1f} times a memcmp of {:.4f} ms\n",
             incremental_ms.size(), median(incremental_ms), median(ratios(incremental_ms, compare_ms)),
             median(compare_ms));
}

}  // namespace

void print_header() {
  fmt::print("{:<26} {:>6} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n",
             "sequence, ms at 4x", "frames", "increm.", "scratch", "xbr", "hqx", "inc/xbr", "inc/scr", "p99",
             "p99/xbr", "max i/s", "max s/x", "B/pixel");
}

void print_timing(const SequenceTiming& timing) {
  const Summary summary(timing);
  fmt::print(
      "{:<26} {:>6} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.2f} {:>8.2f} {:>8.3f} {:>8.2f} {:>8.2f} "
      "{:>8.2f} {:>8.1f}\n",
      timing.name, timing.incremental_ms.size(), median(timing.incremental_ms), median(timing.scratch_ms),
      median(timing.xbr4_ms), median(timing.hqx4_ms), median(summary.to_xbr), median(summary.to_scratch),
      percentile_99(timing.incremental_ms), percentile_99(summary.to_xbr), worst(summary.to_scratch),
      worst(summary.scratch_to_xbr), timing.bytes_per_pixel);
  print_softfilters(timing);
  print_repeats(timing);
  std::fflush(stdout);
}

void print_threads(const ThreadTiming& timing) {
  fmt::print("  {} threads from scratch: drawing {:.2f}, vectorizing and drawing {:.2f} times as fast as 1\n",
             timing.threads, timing.draw_speed_up, timing.both_speed_up);
  std::fflush(stdout);
}

void print_verdicts(std::span<const Verdict> verdicts) {
  fmt::print("\n");
  for (const Verdict& verdict : verdicts) {
    fmt::print("{}: {} {:.2f}, wanted at {} {}: {}\n", verdict.sequence, verdict.what, verdict.value,
               verdict.wants_more ? "least" : "most", verdict.wanted,
               verdict.is_reached() ? "reached" : "missed");
  }
  const auto reached = std::count_if(verdicts.begin(), verdicts.end(),
                                     [](const Verdict& verdict) { return verdict.is_reached(); });
  fmt::print("{} of {} reached\n", reached, verdicts.size());
}

void print_json(std::span<const SequenceTiming> timings) {
  using Json = nlohmann::ordered_json;
  Json sequences = Json::array();
  for (const SequenceTiming& timing : timings) {
    const Summary summary(timing);
    Json softfilters = Json::object();
    for (const SoftFilterTiming& filter : timing.softfilters) softfilters[filter.name] = median(filter.ms);
    sequences.push_back({{"name", timing.name},
                         {"xbr4_ms", median(timing.xbr4_ms)},
                         {"hqx4_ms", median(timing.hqx4_ms)},
                         {"scratch_ms", median(timing.scratch_ms)},
                         {"median_ms", median(timing.incremental_ms)},
                         {"p99_ms", percentile_99(timing.incremental_ms)},
                         {"median_ratio_to_xbr4", median(summary.to_xbr)},
                         {"median_ratio_to_scratch", median(summary.to_scratch)},
                         {"worst_ratio_to_scratch", worst(summary.to_scratch)},
                         {"scratch_ratio_to_xbr4_worst", worst(summary.scratch_to_xbr)},
                         {"bytes_per_pixel", timing.bytes_per_pixel},
                         {"softfilters", std::move(softfilters)}});
  }
  fmt::print("{}\n", Json{{"sequences", std::move(sequences)}}.dump());
}

}  // namespace depixel::bench
