#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/stages/arc_batch.hpp"
#include "libdepixel/stages/edge_curve.hpp"

namespace depixel {

/// The Bezier segments of a batch's splines, for eight steps at a time; keeps its buffers.
///
/// A segment of a uniform cubic B-spline has its inner points at a third and two thirds of the way from one
/// control point to the next. All points are whole subpixels, rounded so that a curve is the same from either
/// end.
class BatchCurves {
 public:
  /// \param batch      x, y hold control points, knot_x, knot_y the knots, ghosts of closed members included.
  /// \param retracted  by entry: 1 where both inner points go to the middle of the lattice edge, the point
  /// that is
  ///                   farthest from the pixel centres on its sides. So they do where the curve would not
  ///                   stay near its edge (see stays_near_edge()).
  void compute(const ArcBatch& batch, const std::vector<std::uint8_t>& retracted);

  /// The curve of the step that leaves an entry.
  EdgeCurve curve(int entry) const {
    const auto at = [&](int value) { return static_cast<std::int16_t>(points_[value][entry]); };
    return {{at(0), at(4)}, {at(1), at(5)}, {at(2), at(6)}, {at(3), at(7)}};
  }
  /// The tiles that it may touch (see touched_tiles()).
  TileMask tiles(int entry) const { return static_cast<TileMask>(tiles_[entry]); }

  std::size_t memory_bytes() const;

 private:
  std::array<std::vector<std::int32_t>, 8>
      points_;  ///< x of p0 .. p3, then y, subpixels from the edge's owner
  std::vector<std::int32_t> tiles_;
  std::vector<float> retracted_;
};

}  // namespace depixel
