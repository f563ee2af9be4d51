#pragma once

#include <cstdint>
#include <vector>

#include "libdepixel/stages/components.hpp"
#include "libdepixel/stages/planar_map.hpp"

namespace depixel {

/// A piece of an outline: a cubic Bezier curve from the end of the piece before it; points in subpixels.
struct OutlinePiece {
  static constexpr int kBorder = -1;
  glm::ivec2 p1, p2, p3;
  int segment =
      kBorder;  ///< the map's segment that it runs along; kBorder: a straight line along the picture's border
};

/// A closed path. It starts where its last piece ends: at its first lattice corner in raster order.
struct OutlineLoop {
  int component = 0;
  int first = 0, count = 0;  ///< pieces first .. first + count - 1 of Outlines
};

/// The components of a planar map as closed paths, for the even-odd rule: a loop round each component and one
/// round each of its holes. Loops have their component on their left, so holes turn the other way.
struct Outlines {
  std::vector<OutlinePiece> pieces;
  std::vector<OutlineLoop> loops;  ///< by component, then in raster order of their starts
  std::vector<int> first_loop;     ///< of each component, and one past the last

  std::vector<int> edge_segment;     ///< scratch: the segment of every lattice edge
  std::vector<std::uint8_t> traced;  ///< scratch; padded by corner, mask of the directions left in
  std::vector<OutlineLoop> unsorted;
};

/// Chains the map's segments, and the straight border between them, into the outlines of components. Segments
/// are joined by the lattice corner they meet in; a component that touches itself there goes round each of
/// its corners. \param graph       resolved; says which corners are cut. \param components  of that graph.
/// \param outlines    overwritten; its buffers are reused.
/// Cost: linear in lattice corners and segments. Source: Schapfel, section 4.5.
void trace_outlines(const PlanarMap& map, const SimilarityGraph& graph, const Components& components,
                    Outlines& outlines);

}  // namespace depixel
