#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "libdepixel/raster/colour_model.hpp"

namespace depixel {

/// Sums of coverage times colour change for a band of output rows.
///
/// A line that goes down adds, to every pixel it crosses, its colour change times the area to its right
/// inside the pixel, and to the next pixel the rest of the height it covers; a running sum along the row then
/// gives the colours. All sums are integers. Source: FreeType's smooth rasteriser; font-rs.
template <typename Model, int kRowCount = 32>
class BandSums {
 public:
  using Sums = typename Model::Sums;
  using Change = typename Model::Change;

  static constexpr int kRows = kRowCount;

  /// Sets the width of rows, in output pixels. Between bands only, when all rows have been resolved.
  void resize(int width) {
    width_ = width;
    right_ = width * kRasterSubpixels;
    if (width <= capacity_) return;
    capacity_ = width;
    // With room for what a line in the last column leaves to the next.
    const std::size_t groups = static_cast<std::size_t>(width) / kGroup + 1;
    stride_ = groups * kGroup;
    flag_capacity_ = (groups + kFlags - 1) / kFlags * kFlags;
    sums_.assign(kRows * stride_, Sums{});
    touched_.assign(kRows * flag_capacity_, 0);
  }

  /// Starts a band: output rows first_row .. first_row + rows - 1.
  void start(int first_row, int rows) {
    top_ = first_row * kRasterSubpixels;
    bottom_ = top_ + rows * kRasterSubpixels;
  }

  /// Adds a line, in output subpixels; parts outside the band are left out. Where a line meets the boundary
  /// of a row depends on the line alone, so a line that crosses bands adds up to the same as in one band.
  /// \param change  from the colour on its right to the colour on its left, going from (x0, y0) to (x1, y1).
  void add_line(int x0, int y0, int x1, int y1, const Change& change) {
    // Upside down, a line changes colours the other way. Selections, not branches: directions cannot be
    // foretold.
    const bool is_upwards = y0 > y1;
    const int top_x = is_upwards ? x1 : x0, top_y = is_upwards ? y1 : y0;
    const int bottom_x = is_upwards ? x0 : x1, bottom_y = is_upwards ? y0 : y1;
    const int from = std::max(top_y, top_), to = std::min(bottom_y, bottom_);
    if (from >= to) return;
    const int width = bottom_x - top_x, height = bottom_y - top_y;
    const Ratio slope(width, height);
    const bool stays_inside = std::min(x0, x1) >= 0 && std::max(x0, x1) < right_;
    Slice slice{
        change, Ratio(height, width == 0 ? 1 : std::abs(width)), is_upwards ? -1 : 1, nullptr, nullptr, 0, 0,
        0};
    int x = top_x + slope.times(from - top_y);
    for (int y = from; y < to;) {
      const int next_y = std::min(to, (y | (kSub - 1)) + 1);
      const int next_x = next_y == bottom_y ? bottom_x : top_x + slope.times(next_y - top_y);
      const std::size_t row = static_cast<unsigned>(y - top_) / kSub;
      slice.sums = sums_.data() + row * stride_;
      slice.touched = touched_.data() + row * flag_capacity_;
      slice.left = std::min(x, next_x);
      slice.right = std::max(x, next_x);
      slice.height = next_y - y;
      if (!stays_inside) clip(slice);
      add_slice(slice);
      x = next_x;
      y = next_y;
    }
  }

  /// Turns the sums of a row of the band into pixels, and clears them.
  void resolve(int row, std::uint8_t* out) { resolve(row, out, Sums{}, 0, width_); }

  /// The sum of all sums of a row.
  Sums total(int row) const {
    const Sums* sums = sums_.data() + row * stride_;
    Sums total{};
    for_each_touched(row, [&](int first) {
      for (int x = first; x < first + kGroup; ++x) total += sums[x];
    });
    return total;
  }

  /// Calls visit(column, sum) for the pixels of a row that were touched, and maybe for others, from left to
  /// right, and clears them.
  template <typename Visit>
  void take(int row, Visit visit) {
    Sums* sums = sums_.data() + row * stride_;
    for_each_touched(row, [&](int first) {
      for (int x = first; x < first + kGroup; ++x) {
        visit(x, sums[x]);
        sums[x] = Sums{};
      }
    });
    forget_touched(row);
  }

  /// The same for a part of the row: only pixels from .. to - 1 are written.
  /// \param before  the sum of all sums left of the row.
  void resolve(int row, std::uint8_t* out, Sums before, int from, int to) {
    RowState state{sums_.data() + row * stride_, out, before, Model::decode(before), from, to};
    for_each_flags(row, [&](int first, std::uint64_t flags) {
      // Where several are touched, all are taken, if that takes little: which they are cannot be foretold.
      if (kDecodesFour<Model> && count_flags(flags) > 1 && first >= from && first + kFlags * kGroup <= to) {
        fill(state, first);
        resolve_whole(state, first, kFlags);
        return;
      }
      for_each_group(first, flags, [&](int group) {
        if (group >= from && group + kGroup <= to) {
          fill(state, group);
          resolve_whole(state, group, 1);
        } else {
          resolve_part(state, group);
        }
      });
    });
    forget_touched(row);
    fill(state, to);
  }

 private:
  /// Pixels that share a flag, and flags that are looked at together.
  static constexpr int kGroup = kWordLanes, kFlags = sizeof(std::uint64_t);
  static constexpr int kSub = kRasterSubpixels;
  static constexpr int kSubBits = std::countr_zero(static_cast<unsigned>(kSub));

  /// Calls visit(first column, flags) for the flags of a row, those that are looked at together; none if all
  /// are 0.
  template <typename Visit>
  void for_each_flags(int row, Visit visit) const {
    const std::uint8_t* flags = touched_.data() + row * flag_capacity_;
    for (int flag = 0; flag <= width_ / kGroup; flag += kFlags) {
      if (const std::uint64_t together = load_bytes(flags + flag); together != 0)
        visit(flag * kGroup, together);
    }
  }
  /// Calls visit(first column) for each group that was touched, from left to right.
  template <typename Visit>
  static void for_each_group(int first, std::uint64_t flags, Visit visit) {
    for (; flags != 0; flags &= flags - 1) visit(first + std::countr_zero(flags) / 8 * kGroup);
  }
  template <typename Visit>
  void for_each_touched(int row, Visit visit) const {
    for_each_flags(row, [&](int first, std::uint64_t flags) { for_each_group(first, flags, visit); });
  }
  /// Flags are 0 or 1.
  static int count_flags(std::uint64_t flags) {
    return static_cast<int>(flags * 0x01'01'01'01'01'01'01'01 >> 56);
  }
  void forget_touched(int row) {
    std::fill_n(touched_.data() + row * flag_capacity_, flag_capacity_, std::uint8_t{0});
  }

  /// How far a row has been resolved: pixels before `done` are written, or are not to be, and so are those
  /// from `end` on; `running` is the sum of the sums so far.
  struct RowState {
    Sums* sums;
    std::uint8_t* out;
    Sums running;
    Rgba colour;
    int done, end;
  };

  /// Writes pixels up to `to` in the colour of the last. What lies right of them in the row is written later,
  /// so whole vectors may spill over.
  void fill(RowState& state, int to) const {
    if (state.done >= to) return;
    const Word4 four = Word4{} + std::bit_cast<std::uint32_t>(state.colour);
    int x = state.done;
    for (; x < to && x + kWordLanes <= state.end; x += kWordLanes)
      store_vector(state.out + 4 * std::size_t(x), four);
    for (; x < to; ++x) std::memcpy(state.out + 4 * std::size_t(x), &state.colour, sizeof state.colour);
    state.done = to;
  }

  /// Takes a group at an end of what is written. Beyond it, sums are forgotten.
  void resolve_part(RowState& state, int first) const {
    for (int x = first; x < first + kGroup; ++x) {
      fill(state, std::min(x, state.end));
      state.running += state.sums[x];
      state.sums[x] = Sums{};
      state.colour = Model::decode(state.running);
    }
    fill(state, std::min(first + kGroup, state.end));
  }

  /// Takes some groups that follow each other.
  void resolve_whole(RowState& state, int first, int groups) const {
    static_assert(kGroup == 4);
    Sums running = state.running;
    Byte16 four{};
    for (int x = first; x < first + groups * kGroup; x += kGroup) {
      Sums* sums = state.sums + x;
      const Sums a = running + sums[0], b = a + sums[1], c = b + sums[2], d = c + sums[3];
      four = decode_four<Model>(a, b, c, d);
      store_vector(state.out + 4 * std::size_t(x), four);
      std::fill_n(sums, kGroup, Sums{});
      running = d;
    }
    state.running = running;
    state.colour = std::bit_cast<std::array<Rgba, kGroup>>(four).back();
    state.done = first + groups * kGroup;
  }

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

  /// A piece of a line inside one row. Whether it falls or rises to the right makes no difference to its
  /// areas.
  struct Slice {
    const Change& change;
    Ratio height_by_width;
    int sign;               ///< of the change
    Sums* sums;             ///< of the row
    std::uint8_t* touched;  ///< flags of the row
    int left, right, height;
  };

  /// Cuts off what leaves the rows. What lies left of them changes whole rows from the first pixel on; what
  /// lies right of them changes nothing.
  void clip(Slice& slice) {
    if (slice.left < 0) {
      const int height =
          slice.right <= 0 ? slice.height : std::min(slice.height, slice.height_by_width.times(-slice.left));
      slice.sums[0] += Model::times(slice.change, slice.sign * 2 * kSub * height);
      touch(slice, 0);
      slice.height -= height;
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

  /// Adds a slice column by column; what a column leaves to the next is carried along.
  void add_slice(const Slice& slice) {
    const int first = slice.left >> kSubBits, last = slice.right >> kSubBits;
    Sums* sums = slice.sums;
    Sums carried{};
    int x = slice.left - first * kSub, done = 0;
    for (int column = first; column < last; ++column) {
      const int total = std::min(slice.height, slice.height_by_width.times((column + 1) * kSub - slice.left));
      const int height = slice.sign * (total - done), area = (x + kSub) * height;
      sums[column] += carried + Model::times(slice.change, 2 * kSub * height - area);
      carried = Model::times(slice.change, area);
      touch(slice, column);
      x = 0;
      done = total;
    }
    const int height = slice.sign * (slice.height - done), area = (x + slice.right - last * kSub) * height;
    sums[last] += carried + Model::times(slice.change, 2 * kSub * height - area);
    sums[last + 1] += Model::times(slice.change, area);
    touch(slice, last);
    touch(slice, last + (area != 0 ? 1 : 0));
  }

  static void touch(const Slice& slice, int column) {
    slice.touched[static_cast<unsigned>(column) / kGroup] = 1;
  }

  int width_ = 0, right_ = 0;
  int capacity_ = -1;                           ///< width that the arrays have room for
  std::size_t stride_ = 0, flag_capacity_ = 0;  ///< sums and flags a row
  int top_ = 0, bottom_ = 0;
  std::vector<Sums> sums_;
  std::vector<std::uint8_t> touched_;  ///< by group of pixels: 1 where one was touched, else 0
};

}  // namespace depixel
