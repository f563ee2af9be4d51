#pragma once

#include <chrono>

namespace depixel {

/// A progress bar on standard error, shown only on a terminal and only once the work takes longer than a
/// moment.
class ProgressBar {
 public:
  /// \param wanted  false shows nothing at all.
  explicit ProgressBar(bool wanted);
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  /// Takes the bar off the terminal again.
  ~ProgressBar();

  /// \param part  of the work that is done, 0..1.
  void show(double part);

 private:
  using Clock = std::chrono::steady_clock;

  bool wanted_;
  bool shown_ = false;
  Clock::time_point next_;
};

}  // namespace depixel
