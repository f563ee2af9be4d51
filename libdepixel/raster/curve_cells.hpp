#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/raster/line_slices.hpp"
#include "libdepixel/raster/output_grid.hpp"
#include "libdepixel/stages/edge_curve.hpp"

namespace depixel {

/// What curves add to the sums of the output pixels that they cross, for grids with whole output pixels to a
/// source pixel: there it is the same wherever an edge lies, so each curve's lines are summed up once, with a
/// colour change of 1. Sums are integers: any other change times that is what its lines add.
class CurveCells {
 public:
  /// What a curve adds to a pixel. Places are counted in a picture of sums, from that of the output pixel
  /// whose top left corner is the edge's owner.
  struct Cell {
    std::int32_t place, factor;
  };

  static constexpr int kLargestScale = 16;

  static bool fits(const OutputGrid& grid) { return grid.has_whole_scales(kLargestScale); }
  /// True where seen_from() is good: a tile's centre has its colour and lies in the corner of an output
  /// pixel. (At two output pixels to a source pixel, lines may stray as far from their curves as those stay
  /// away from the centres.)
  static bool sees_from_centres(const OutputGrid& grid) {
    const auto is_good = [](int scale) { return scale >= 4 && scale % 2 == 0; };
    return fits(grid) && is_good(grid.x.whole_scale()) && is_good(grid.y.whole_scale());
  }

  /// Starts on a picture; forgets all curves if the scale, the pitch or the generation are others, or their
  /// cells have become many.
  /// \param pitch       places to a row of the picture of sums.
  /// \param generation  of the curves' numbers, see SplineTable::generation(). \param numbers  more than any.
  void start(const OutputGrid& grid, int pitch, std::uint64_t generation, std::size_t numbers);

  /// The cells of a curve in a row of tiles; -1, 0 or 1 from its owner. Valid until the next call.
  /// \param number  names the curve.
  std::span<const Cell> in_row(int number, const EdgeCurve& curve, int row) {
    const Entry& entry = entry_of(number, curve);
    return std::span(cells_).subspan(entry.first + entry.ends[row + 1],
                                     entry.ends[row + 2] - entry.ends[row + 1]);
  }
  /// The cells of a curve in a tile's row from the tile's middle on eastwards, where all pixels are taken to
  /// have the tile's colour but for what this and other curves change between its centre and them: then
  /// curves that touch neither the tile nor what lies east of it need not be looked at. Valid until the next
  /// call. \param tile  bit of a TileMask.
  std::span<const Cell> seen_from(int number, const EdgeCurve& curve, int tile) {
    Entry& entry = entry_of(number, curve);
    if (entry.views == 0) entry.views = add_views();
    Range& range = views_[entry.views][tile];
    if (range.first == 0) range = make_view(curve, entry, tile);
    return std::span(cells_).subspan(range.first, range.count);
  }

  std::size_t memory_bytes() const { return held_bytes(entries_, views_, cells_, points_, sums_); }

 private:
  struct Range {
    int first = 0, count = 0;  ///< in cells_; first is 0 where the cells have not been made yet
  };
  struct Entry {
    int first = 0;                        ///< in cells_; 0 where the cells have not been made yet
    int views = 0;                        ///< in views_; 0 where there are none yet
    std::array<std::uint16_t, 4> ends{};  ///< of the rows of tiles, from first on; preceded by 0
  };

  Entry& entry_of(int number, const EdgeCurve& curve) {
    Entry& entry = entries_[number];
    if (entry.first == 0) make_cells(curve, entry);
    return entry;
  }
  void make_cells(const EdgeCurve& curve, Entry& entry);
  void flatten_curve(const EdgeCurve& curve);
  void add_line(glm::ivec2 a, glm::ivec2 b);
  int sums_pitch() const { return 3 * whole_scale_.x + 2; }
  int add_views();
  Range make_view(const EdgeCurve& curve, const Entry& entry, int tile);
  void add_cell(int place, std::int32_t factor) {
    if (factor != 0) cells_.push_back({place, factor});
  }
  std::int32_t sum_beside(int top, glm::ivec2 centre) const;

  glm::dvec2 scale_{0};
  glm::ivec2 whole_scale_{0};
  int pitch_ = 0;
  std::uint64_t generation_ = 0;
  std::vector<Entry> entries_;               ///< by number
  std::vector<std::array<Range, 9>> views_;  ///< by bit of a TileMask
  std::vector<Cell> cells_;
  std::vector<glm::ivec2> points_;  ///< ends of the lines of the curve in hand
  LineSlicer slicer_;
  /// What the curve in hand adds to the output pixels of the nine tiles round its owner, by row; the two last
  /// columns are for what those before leave to the next. All 0 between curves.
  std::vector<std::int32_t> sums_;
};

}  // namespace depixel
