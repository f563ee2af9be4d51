#pragma once

#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/stages/contours.hpp"
#include "libdepixel/stages/splines.hpp"

namespace depixel {

/// A cubic Bezier curve between two regions; points in subpixels (kSubpixels to a source pixel), origin top
/// left.
struct Segment {
  glm::ivec2 p0, p1, p2, p3;
  int left, right;  ///< padded index of a pixel on either side, seen along the curve
};

/// A frame as a planar map: curve segments that divide the picture without gap or overlap.
///
/// Segments come contour by contour, each contour's in order; consecutive ones share their end point exactly,
/// and so do all that meet in a junction. The picture's straight border is not among them: outside lies
/// transparency.
struct PlanarMap {
  Lattice lattice;
  std::vector<Rgba> colours;  ///< padded, by pixel: the colour of the region that holds the pixel
  std::vector<Segment> segments;

  Rgba left_colour(const Segment& s) const { return colours[s.left]; }
  Rgba right_colour(const Segment& s) const { return colours[s.right]; }

  std::size_t memory_bytes() const { return held_bytes(colours, segments); }
};

/// Builds the map (stage 6 of 6) from contours and the splines fitted to them.
/// Cost: linear in steps. Source: Schapfel, sections 4.5 and 4.6.4.
void build_planar_map(const CellGraph& cells, const Contours& contours, const Splines& splines,
                      PlanarMap& map);

}  // namespace depixel
