#pragma once

#include <vector>

#include "libdepixel/stages/planar_map.hpp"

namespace depixel {

enum class CellShape {
  accurate,   ///< the generalised Voronoi diagram (thesis, figure 33)
  simplified  ///< the same without its nodes of valence 2 (figure 34): the cell graph of the later stages
};

/// The cell of a pixel as a polygon, clockwise, in subpixels.
///
/// Accurate cells hold the points that are nearest to a pixel's node and half-links. Their parabolic arcs are
/// drawn as chains of two lines that meet in the middle of a lattice edge; nodes are quantised to sixteenths
/// of a pixel, because a lone horizontal link puts a junction at 1/8. So a cell holds every point that lies
/// nearer to its site than to all others by more than 1/8 pixel. \param graph    resolved: no two links
/// cross. \param polygon  overwritten; 4 to 12 points. Source: Schapfel, section 4.3; spec, "Cells (figure
/// 32)".
void find_cell_polygon(const SimilarityGraph& graph, CellShape shape, int pixel,
                       std::vector<glm::ivec2>& polygon);

/// All cells as a planar map of straight segments, one or, where it bends, two for each lattice edge inside
/// the frame and one for each diagonal link, also between cells of one colour. Its colours are the pixels'
/// own. Cost: linear in pixels.
void build_cell_map(const SimilarityGraph& graph, CellShape shape, PlanarMap& map);

}  // namespace depixel
