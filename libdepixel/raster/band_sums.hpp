#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

#include "libdepixel/raster/colour_model.hpp"
#include "libdepixel/raster/line_slices.hpp"
#include "libdepixel/raster/touched_groups.hpp"

namespace depixel {

/// Sums of coverage times colour change for a band of output rows.
///
/// A line that goes down adds, to every pixel it crosses, its colour change times the area to its right
/// inside the pixel, and to the next pixel the rest of the height it covers; a running sum along the row then
/// gives the colours. All sums are integers. Source: font-rs.
template <typename Model>
class BandSums {
 public:
  using Sums = typename Model::Sums;
  using Change = typename Model::Change;

  /// The sum of all sums on the left of a row.
  using Start = Sums;

  static constexpr int kRows = kBandRows;

  static Change change(Rgba from, Rgba to) { return Model::change(from, to); }

  /// Sets the width of rows, in output pixels. Between bands only, when all rows have been resolved.
  void resize(int width) {
    width_ = width;
    slicer_.resize(width);
    if (width <= capacity_) return;
    capacity_ = width;
    sums_.assign(std::size_t{kRows} * stride(), Sums{});
    touched_.resize(kRows, width);
  }

  /// Starts a band: output rows first_row .. first_row + rows - 1.
  void start(int first_row, int rows) { slicer_.start(first_row, rows); }

  /// Adds a line, in output subpixels; parts outside the band are left out.
  /// \param change  from the colour on its right to the colour on its left, going from (x0, y0) to (x1, y1).
  void add_line(int x0, int y0, int x1, int y1, const Change& change) {
    slicer_.cut(x0, y0, x1, y1, [&](const LineSlicer::Slice& slice) { add_slice(slice, change); });
  }

  /// Turns the sums of a row of the band into pixels, and clears them.
  void resolve(int row, std::uint8_t* out) { resolve(row, out, Sums{}, 0, width_); }

  /// A row's start on the right of a colour, of whose pixels so many subpixels are covered by the frame.
  static Start start_from(Rgba colour, int covered) {
    return Model::times(Model::change(Rgba{}, colour), 2 * kRasterSubpixels * covered);
  }
  /// A row's start where such a colour is on its right.
  Start start_before(int row, Rgba colour, int covered) const {
    const Sums* sums = sums_.data() + row * stride();
    Start start = start_from(colour, covered);
    touched_.for_each(row, width_, [&](int first) {
      for (int x = first; x < first + kGroup; ++x) start -= sums[x];
    });
    return start;
  }

  /// The same, but only pixels from .. to - 1 are written.
  /// \param before  the sum of all sums left of the row.
  void resolve(int row, std::uint8_t* out, Sums before, int from, int to) {
    RowState state{sums_.data() + row * stride(), out, before, Model::decode(before), from, to};
    touched_.for_each_flags(row, width_, [&](int first, std::uint64_t flags) {
      // Where several are touched, all are taken, if that takes little: which they are cannot be foretold.
      constexpr int kAll = TouchedGroups::kAtOnce * kGroup;
      if (kDecodesFour<Model> && TouchedGroups::count(flags) > 1 && first >= from && first + kAll <= to) {
        fill(state, first);
        resolve_whole(state, first, TouchedGroups::kAtOnce);
        return;
      }
      TouchedGroups::for_each_group(first, flags, [&](int group) {
        if (group >= from && group + kGroup <= to) {
          fill(state, group);
          resolve_whole(state, group, 1);
        } else {
          resolve_part(state, group);
        }
      });
    });
    touched_.forget(row);
    fill(state, to);
  }

  std::size_t memory_bytes() const { return held_bytes(sums_) + touched_.memory_bytes(); }

 private:
  static constexpr int kGroup = TouchedGroups::kGroup;

  /// Whole groups, with room for what a line on the right side of the last column leaves to the next but one.
  std::size_t stride() const { return (static_cast<std::size_t>(capacity_ + 1) / kGroup + 1) * kGroup; }

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

  /// What a pixel leaves to the next is carried along. Inlined: there are several slices to a line.
  [[gnu::always_inline]] void add_slice(const LineSlicer::Slice& slice, const Change& change) {
    Sums* sums = sums_.data() + slice.row * stride();
    std::uint8_t* touched = touched_.row(slice.row);
    Sums carried{};
    int end = 0, left = 0;
    slice.for_each_pixel([&](int column, int height, int area) {
      sums[column] += carried + Model::times(change, 2 * kRasterSubpixels * height - area);
      carried = Model::times(change, area);
      TouchedGroups::touch(touched, column);
      end = column + 1;
      left = area;
    });
    sums[end] += carried;
    TouchedGroups::touch(touched, end - (left == 0 ? 1 : 0));
  }

  int width_ = 0;
  int capacity_ = -1;  ///< of the arrays, in pixels a row
  LineSlicer slicer_;
  std::vector<Sums> sums_;
  TouchedGroups touched_;
};

}  // namespace depixel
