#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/core/simd.hpp"
#include "libdepixel/stages/edge_map.hpp"
#include "libdepixel/stages/shading.hpp"

namespace depixel {

/// A cubic Bezier curve between two regions; points in subpixels (kSubpixels to a source pixel), origin top
/// left.
struct Segment {
  glm::ivec2 p0, p1, p2, p3;
  int left, right;  ///< padded index of a pixel on either side, seen along the curve

  friend bool operator==(const Segment&, const Segment&) = default;
};

/// A frame as a planar map: curve segments that divide the picture without gap or overlap.
///
/// All segments that meet in a point share it exactly. The picture's straight border is not among them:
/// outside lies transparency. Those of a frame go eastwards or southwards, each along one edge of the
/// lattice, and come in raster order of the corners that they leave.
struct PlanarMap {
  Lattice lattice;
  std::vector<Rgba> colours;  ///< padded, by pixel: the colour of the region that holds the pixel
  std::vector<Segment> segments;
  Shading shading;  ///< how colours run inside the regions

  Rgba left_colour(const Segment& s) const { return colours[s.left]; }
  Rgba right_colour(const Segment& s) const { return colours[s.right]; }

  friend bool operator==(const PlanarMap&, const PlanarMap&) = default;

  std::size_t memory_bytes() const { return held_bytes(colours, segments) + shading.memory_bytes(); }
};

/// True where no pixel of a frame lets anything through.
bool is_opaque(const Lattice& lattice, const std::vector<Rgba>& colours);

/// The pixels on both sides of the edge that leaves a corner eastwards or southwards, seen in that direction.
struct EdgeSides {
  int left, right;
};
constexpr EdgeSides sides_of(int corner, bool southwards, int stride) {
  return {corner + (southwards ? stride + 1 : 1), corner + (southwards ? stride : stride + 1)};
}

/// The segment along the visible edge that leaves a corner eastwards or southwards.
inline Segment segment_of(const EdgeCurve& curve, glm::ivec2 corner_position, int corner, bool southwards,
                          int stride) {
  const glm::ivec2 o = corner_position * kSubpixels;
  // All points at once: a list is long.
  const Int8 points = __builtin_convertvector(std::bit_cast<Short8>(curve), Int8) +
                      Int8{o.x, o.y, o.x, o.y, o.x, o.y, o.x, o.y};
  const EdgeSides sides = sides_of(corner, southwards, stride);
  Segment segment{{}, {}, {}, {}, sides.left, sides.right};
  static_assert(offsetof(Segment, left) == sizeof points);
  store_vector(&segment, points);
  return segment;
}

/// A frame's planar map as the stages make it: what a PlanarMap lists, without the list, of which a segment
/// takes more memory than all that is kept of an edge.
struct MapByEdge {
  const EdgeMap& edges;
  const SplineTable& table;
  const std::vector<Rgba>& colours;  ///< of the cells, padded
  const Shading& shading;
};

/// Calls visit(curve number, corner, x, southwards) for the visible edges that leave a row of corners, in
/// order; x is the corner's column. Which are visible cannot be foretold, so some are listed first, without
/// branches, and their curves are fetched meanwhile.
template <typename Visit>
void for_each_visible_edge(const MapByEdge& map, int y, Visit visit) {
  constexpr int kCornersAtOnce = 32;
  const Lattice& lattice = map.edges.lattice;
  std::array<int, 2 * kCornersAtOnce> visible;
  for (int first = 0; first <= lattice.width(); first += kCornersAtOnce) {
    const int corner = lattice.corner(first, y),
              slots = 2 * std::min(kCornersAtOnce, lattice.width() + 1 - first);
    const int* curve = map.edges.curve.data() + edge_slot(corner, false);
    int count = 0;
    for (int slot = 0; slot < slots; ++slot) {
      visible[count] = slot;
      count += curve[slot] != 0 ? 1 : 0;
      map.table.prefetch(curve[slot]);
    }
    for (int i = 0; i < count; ++i) {
      const int slot = visible[i], along = slot / 2;
      visit(curve[slot], corner + along, first + along, slot % 2 != 0);
    }
  }
}

/// Calls visit(segment) for them.
template <typename Visit>
void for_each_segment(const MapByEdge& map, int y, Visit visit) {
  for_each_visible_edge(map, y, [&](int number, int corner, int x, bool southwards) {
    visit(segment_of(map.table.curve(number), {x, y}, corner, southwards, map.edges.lattice.stride()));
  });
}

/// Writes a map out (stage 6 of 6), for readers that want a list.
/// Cost: linear in corners. Source: Schapfel, section 4.5.
void build_planar_map(const MapByEdge& from, PlanarMap& map);

}  // namespace depixel
