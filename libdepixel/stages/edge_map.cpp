#include "libdepixel/stages/edge_map.hpp"

#include <algorithm>

namespace depixel {
namespace {

/// Where the contour that goes through a T-junction passes, in subpixels from the corner.
glm::ivec2 through_knot(int corner, Direction ending, const CornerCode code, const EdgeMap& map,
                        const SplineTable& table) {
  Direction through = turned(ending, 1);
  if (!code.is_visible(through)) through = turned(ending, 2);
  const EdgeEnd end = edge_end(corner, through, map.lattice.step_offsets());
  const EdgeCurve& curve = table.curve(map.curve[end.slot]);
  return end.is_owner ? glm::ivec2(curve.p0) : glm::ivec2(curve.p3) + kStep[through] * kSubpixels;
}

}  // namespace

JoinedEdge join_at(int corner, const CellGraph& cells, const EdgeMap& map, SplineTable& table) {
  const std::array<int, 4> step = map.lattice.step_offsets();
  const CornerCode code = cells.corners[corner];
  const Direction ending =
      *std::find_if(kDirections.begin(), kDirections.end(), [&](Direction d) { return code.ends(d); });
  const EdgeEnd here = edge_end(corner, ending, step);
  const int fitted = table.fitted(map.curve[here.slot]);
  EdgeCurve ends = table.curve(fitted);
  const auto move_end = [&](int at, Direction d) {
    const glm::ivec2 knot = through_knot(at, d, cells.corners[at], map, table);
    if (edge_end(at, d, step).is_owner) {
      ends.p0 = knot;
    } else {
      ends.p3 = knot - kStep[d] * kSubpixels;
    }
  };
  move_end(corner, ending);
  const int other = corner + step[ending];
  const Direction back = opposite(ending);
  if (cells.is_t_junction(other) && cells.corners[other].ends(back)) move_end(other, back);
  const bool southwards = ending == kNorth || ending == kSouth;
  return {here.slot, table.joined(fitted, southwards, ends.p0, ends.p3)};
}

}  // namespace depixel
