#pragma once

#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>

#include "libdepixel/core/lattice.hpp"
#include "libdepixel/core/tolerances.hpp"

namespace depixel {

/// The curve of a visible lattice edge: a cubic Bezier segment from the edge's western or northern corner to
/// the other one; in subpixels from the former, the edge's owner. Equal shapes have equal curves wherever
/// they lie.
struct EdgeCurve {
  glm::i16vec2 p0{0}, p1{0}, p2{0}, p3{0};

  friend bool operator==(const EdgeCurve&, const EdgeCurve&) = default;
};
static_assert(sizeof(EdgeCurve) == 16);

/// Every lattice edge has a slot, two a corner: that of the edge to the east, then to the south.
constexpr int edge_slot(int owner, bool southwards) {
  return 2 * owner + (southwards ? 1 : 0);
}

/// An edge as seen from one of its corners.
struct EdgeEnd {
  int slot;
  bool is_owner;  ///< the corner is the edge's western or northern one
};
/// \param step  Lattice::step_offsets().
constexpr EdgeEnd edge_end(int corner, Direction d, const std::array<int, 4>& step) {
  const bool is_owner = d == kEast || d == kSouth;
  return {edge_slot(is_owner ? corner : corner + step[d], d == kNorth || d == kSouth), is_owner};
}

/// Tiles that a curve may touch, from the tile whose north-west corner is the edge's owner: bit
/// 3 * (row + 1) + column + 1, rows and columns -1, 0 and 1. No curve leaves them.
using TileMask = std::uint16_t;
TileMask touched_tiles(const EdgeCurve& curve);

/// Whether a curve stays where touched_tiles() can tell it: within less than a pixel of its lattice edge.
bool stays_near_edge(const EdgeCurve& curve, bool southwards);

}  // namespace depixel
