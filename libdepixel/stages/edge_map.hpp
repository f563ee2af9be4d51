#pragma once

#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/stages/cell_graph.hpp"
#include "libdepixel/stages/spline_table.hpp"

namespace depixel {

/// The curves of a frame's planar map, by lattice edge: numbers in a SplineTable. What lies where can be
/// looked up, and where the table has equal numbers for equal curves, they tell what is equal; so this is the
/// form in which maps are changed and compared.
struct EdgeMap {
  Lattice lattice;
  std::vector<int> curve;  ///< by edge_slot(); 0 where the edge is invisible

  std::size_t memory_bytes() const { return held_bytes(curve); }
};

/// Calls visit(slot, number) for each step of an arc: the edge's slot and its curve's number.
/// The arc has its place in the table, and is fitted.
template <typename Visit>
void for_each_edge(const Arcs& arcs, const Arc& arc, const SplineTable& table, const std::array<int, 4>& step,
                   Visit visit) {
  const int* corner = arcs.corner.data() + arc.first;
  const ShapeWord* word = arcs.word.data() + arc.first;
  for (int k = 0, steps = arc.step_count(); k < steps; ++k) {
    visit(edge_end(corner[k], word[k].heading(), step).slot, table.number_at(arc.place + k));
  }
}

/// Calls visit(corner) for each end of an open contour at a T-junction, where it is to be joined.
template <typename Visit>
void for_each_joint(const Contours& contours, const CellGraph& cells, Visit visit) {
  for (const Contour& contour : contours.list) {
    if (contour.closed) continue;
    for (const int end : {contour.first, contour.first + contour.count - 1}) {
      const int corner = contours.corner[end];
      if (cells.is_t_junction(corner)) visit(corner);
    }
  }
}

/// An edge at whose end, or ends, another contour goes through, and the curve that ends on that contour's.
struct JoinedEdge {
  int slot, curve;
};

/// Joins the contour that ends at a T-junction to the one that goes through: it ends on that one's knot.
/// \param corner  a T-junction; the edges round it have their curves in the map, joined or not.
/// Source: Schapfel, section 4.6.4 (figure 49).
JoinedEdge join_at(int corner, const CellGraph& cells, const EdgeMap& map, SplineTable& table);

}  // namespace depixel
