#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/stages/cell_graph.hpp"

namespace depixel {

/// A chain of nodes of the cell graph; its nodes are entries first .. first + count - 1 of Contours.
struct Contour {
  int first = 0;
  int count = 0;  ///< nodes; a closed contour's first node is not repeated
  bool closed = false;

  int step_count() const { return closed ? count : count - 1; }
};

/// All contours of a frame in flat arrays. Step k of a contour leads from its node k to node k + 1.
struct Contours {
  std::vector<int> corner;  ///< of each node
  std::vector<std::uint8_t>
      heading;                ///< Direction of the step that leaves the node (at an open end: that arrives)
  std::vector<Contour> list;  ///< open contours first; each kind in raster order of their first corners
  std::vector<std::uint8_t> traced;  ///< scratch; padded, the east and south edges that were traced

  std::size_t memory_bytes() const { return held_bytes(corner, heading, list, traced); }
};

/// Groups visible edges into contours (stage 4 of 6): maximal chains through paired edges. Open contours
/// start at the end that comes first in raster order, closed ones at their topmost, then leftmost corner,
/// eastwards; so start and direction depend on the picture alone. Cost: linear in corners and steps. Source:
/// Schapfel, section 4.4.
void trace_contours(const CellGraph& cells, Contours& contours);

/// Groups just the visible edges of those contours that pass through some corners, each as trace_contours()
/// does; in any order. Corners may be named more than once.
/// Cost: linear in the steps of these contours, and that of clearing a byte a corner.
void trace_contours_through(const CellGraph& cells, std::span<const int> corners, Contours& contours);

}  // namespace depixel
