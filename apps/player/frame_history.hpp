#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace depixel {

/// The times of the frames shown last, for the statistics.
class FrameHistory {
 public:
  static constexpr std::size_t kLength = 180;

  /// \param work_ms  what the frame took, without waiting. \param interval_ms  since the frame before.
  void add(double work_ms, double interval_ms);

  /// Times of work, oldest first; as ImGui plots them.
  std::span<const float> plot() const { return plot_; }
  double median_work_ms() const { return median(all_work_ms_); }
  double frames_a_second() const;
  std::size_t frames() const { return all_work_ms_.size(); }

 private:
  static double median(std::vector<double> values);

  std::vector<float> plot_;
  std::vector<double> all_work_ms_;  ///< of at most kKept frames
  std::vector<double> recent_intervals_;
};

}  // namespace depixel
