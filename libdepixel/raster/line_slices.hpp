#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>

#include "libdepixel/core/tolerances.hpp"

namespace depixel {

/// Pictures are drawn in bands of so many output rows.
constexpr int kBandRows = 16;

/// Cuts lines to the rows and pixels of a band of output rows, in integers. Where a line meets the boundary
/// of a row depends on the line alone, so a line that crosses bands comes to the same as in one band. Source:
/// FreeType's smooth rasteriser.
class LineSlicer {
  static constexpr int kSub = kRasterSubpixels;
  static constexpr int kSubBits = std::countr_zero(static_cast<unsigned>(kSub));
  class Ratio;

 public:
  /// Sets the width of rows, in output pixels.
  void resize(int width) { right_ = width * kSub; }

  /// Starts a band: output rows first_row .. first_row + rows - 1.
  void start(int first_row, int rows) {
    top_ = first_row * kSub;
    bottom_ = top_ + rows * kSub;
  }
  int first_row() const { return top_ / kSub; }

  struct Slice;

  /// Calls visit(slice) for each row of the band that a line crosses, in output subpixels. What lies left of
  /// the rows is taken for upright on their left side; what lies right of them is left out.
  template <typename Visit>
  void cut(int x0, int y0, int x1, int y1, Visit visit) const;

 private:
  /// A ratio of two integers in fixed point, to be multiplied by another integer and rounded. Lines are
  /// short, so most denominators are found in a table of reciprocals.
  class Ratio {
   public:
    Ratio(int numerator, int denominator)
        : value_(denominator < kTabled ? std::int64_t{numerator} * kReciprocals[denominator]
                                       : std::int64_t{numerator} * kOne / denominator) {}
    int times(int factor) const { return static_cast<int>((value_ * factor + kOne / 2) >> kBits); }

   private:
    static constexpr int kBits = 28;
    static constexpr std::int64_t kOne = std::int64_t{1} << kBits;
    static constexpr int kTabled = 4 * kSub;
    static constexpr auto kReciprocals = [] {
      std::array<std::int32_t, kTabled> reciprocals{};
      for (int i = 1; i < kTabled; ++i) reciprocals[i] = static_cast<std::int32_t>((kOne + i / 2) / i);
      return reciprocals;
    }();
    std::int64_t value_;
  };

 public:
  /// A piece of a line inside one row. Whether it falls or rises to the right makes no difference to its
  /// areas.
  struct Slice {
    Ratio height_by_width;
    int sign;  ///< 1 where the line goes down, -1 where up
    int row;   ///< of the band
    int left, right, height;

    /// Calls visit(column, height, area) for each pixel that the slice crosses, from left to right: how high
    /// it is there, and twice the area on its left in the pixel, both with the line's sign.
    template <typename Visit>
    void for_each_pixel(Visit visit) const {
      const int first = left >> kSubBits, last = right >> kSubBits;
      int x = left - first * kSub, done = 0;
      for (int column = first; column < last; ++column) {
        const int total = std::min(height, height_by_width.times((column + 1) * kSub - left));
        const int part = sign * (total - done);
        visit(column, part, (x + kSub) * part);
        x = 0;
        done = total;
      }
      const int rest = sign * (height - done);
      visit(last, rest, (x + right - last * kSub) * rest);
    }
  };

 private:
  template <typename Visit>
  [[gnu::noinline]] void clip(Slice& slice, Visit& visit) const;

  int right_ = 0;
  int top_ = 0, bottom_ = 0;
};

template <typename Visit>
void LineSlicer::cut(int x0, int y0, int x1, int y1, Visit visit) const {
  // Selections, not branches: directions cannot be foretold.
  const bool is_upwards = y0 > y1;
  const int top_x = is_upwards ? x1 : x0, top_y = is_upwards ? y1 : y0;
  const int bottom_x = is_upwards ? x0 : x1, bottom_y = is_upwards ? y0 : y1;
  const int from = std::max(top_y, top_), to = std::min(bottom_y, bottom_);
  if (from >= to) return;
  const int width = bottom_x - top_x, height = bottom_y - top_y;
  const Ratio slope(width, height);
  const bool stays_inside = std::min(x0, x1) >= 0 && std::max(x0, x1) < right_;
  Slice slice{Ratio(height, width == 0 ? 1 : std::abs(width)), is_upwards ? -1 : 1, 0, 0, 0, 0};
  int x = top_x + slope.times(from - top_y);
  for (int y = from; y < to;) {
    const int next_y = std::min(to, (y | (kSub - 1)) + 1);
    const int next_x = next_y == bottom_y ? bottom_x : top_x + slope.times(next_y - top_y);
    slice.row = (y - top_) >> kSubBits;
    slice.left = std::min(x, next_x);
    slice.right = std::max(x, next_x);
    slice.height = next_y - y;
    if (!stays_inside) clip(slice, visit);
    visit(slice);
    x = next_x;
    y = next_y;
  }
}

/// Cuts off what leaves the rows.
template <typename Visit>
void LineSlicer::clip(Slice& slice, Visit& visit) const {
  if (slice.left < 0) {
    Slice outside = slice;
    outside.height =
        slice.right <= 0 ? slice.height : std::min(slice.height, slice.height_by_width.times(-slice.left));
    outside.left = outside.right = 0;
    visit(outside);
    slice.height -= outside.height;
    slice.left = 0;
    slice.right = std::max(slice.right, 0);
  }
  if (slice.right > right_) {
    const int beyond = slice.right - std::max(slice.left, right_);
    const int height =
        slice.left >= right_ ? slice.height : std::min(slice.height, slice.height_by_width.times(beyond));
    slice.height -= height;
    slice.right = right_;
    slice.left = std::min(slice.left, right_);
  }
}

}  // namespace depixel
