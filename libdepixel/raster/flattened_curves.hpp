#pragma once

#include <glm/gtc/type_precision.hpp>
#include <span>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/raster/output_grid.hpp"
#include "libdepixel/stages/spline_table.hpp"

namespace depixel {

/// The lines that curves of a table are drawn as, for a grid with whole output pixels to a source pixel:
/// there they are the same wherever an edge lies, and each curve is flattened once.
class FlattenedCurves {
 public:
  /// True for grids that this is for; others must be flattened edge by edge.
  static bool fits(const OutputGrid& grid) { return grid.has_whole_scales(kLargestScale); }

  /// Starts on a picture; forgets all lines if the scale or the table's curves are others.
  void start(const SplineTable& table, const OutputGrid& grid);

  /// The ends of a curve's lines, in order, in output subpixels from the edge's owner. Valid until the next
  /// call.
  std::span<const glm::i16vec2> points(int number) {
    const Entry& entry = entries_[number];
    if (entry.count == 0) flatten_curve(number);
    return std::span(points_).subspan(entries_[number].first, entries_[number].count);
  }

  std::size_t memory_bytes() const { return held_bytes(entries_, points_); }

 private:
  /// Curves stay within two pixels of their owner.
  static constexpr int kLargestScale = 32767 / (2 * kRasterSubpixels) - 1;

  struct Entry {
    int first = 0, count = 0;  ///< points; none where the curve has not been flattened yet
  };
  void flatten_curve(int number);

  const SplineTable* table_ = nullptr;
  std::uint64_t generation_ = 0;
  glm::dvec2 scale_{0};
  std::vector<Entry> entries_;  ///< by curve
  std::vector<glm::i16vec2> points_;
};

}  // namespace depixel
