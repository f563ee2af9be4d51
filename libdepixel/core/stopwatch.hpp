#pragma once

#include <chrono>
#include <cstdint>

namespace depixel {

/// Adds the time of its own life to a sum of nanoseconds.
class Stopwatch {
 public:
  explicit Stopwatch(std::int64_t& sum_ns) : sum_ns_(sum_ns) {}
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;
  ~Stopwatch() {
    const auto time = std::chrono::steady_clock::now() - start_;
    sum_ns_ += std::chrono::duration_cast<std::chrono::nanoseconds>(time).count();
  }

 private:
  std::int64_t& sum_ns_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace depixel
