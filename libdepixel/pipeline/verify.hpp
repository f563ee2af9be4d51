#pragma once

#include <limits>

#include "libdepixel/stages/planar_map.hpp"
#include "libdepixel/stages/similarity_graph.hpp"

namespace depixel {

/// What became of the promise that a map shows every pixel's own colour at the pixel's centre.
struct CentreReport {
  int pixels = 0;                            ///< looked at: all of the frame
  int lost = 0;                              ///< pixels whose centre has another colour in the map, shaded
  int first_lost_x = -1, first_lost_y = -1;  ///< the first of them in raster order
  /// Smallest distance, in source pixels, from any curve to any centre; infinite in a map without curves.
  double nearest = std::numeric_limits<double>::infinity();
};

/// Checks a map against the pixels that it was made from, without drawing it: along the line through the
/// centres of each row, every crossing of a curve changes the colour from the one on its right to the one on
/// its left or back. A centre exactly on a curve counts as lying east of it. Where the map is shaded, what
/// counts is the shade at the centre; but with ShadingKind::blur, which keeps no pixel's colour, the regions'
/// colours do. With exact similarity and no connected lines, nothing is lost and nearest is at least
/// kCentreClearance. Merging without gradients repaints pixels on purpose; here they just count as lost.
/// Dithers that are blended were so before: the colour between is theirs.
/// \param map    of the same size as the graph. \param graph  holds the frame's pixels; its links are not
/// read. Cost: linear in pixels and segments; `nearest` is exact to 1/kSubpixels/64 of a pixel.
CentreReport verify_centres(const PlanarMap& map, const SimilarityGraph& graph);

}  // namespace depixel
