#pragma once

#include <string>

#include "libdepixel/core/tolerances.hpp"
#include "libdepixel/stages/outlines.hpp"
#include "libdepixel/svg/svg_document.hpp"

namespace depixel {

/// Writes a planar map as an SVG document: one path a colour, with holes by the nonzero rule; viewBox, width
/// and height in source pixels. Transparent components are left out. Where the map is
/// shaded, shadings are drawn on top (svg_shading.hpp).
/// \param graph  the resolved similarity graph that the map was made from.
/// \param tolerance_px  how far contours may stray from the map's so that they take fewer and shorter curves,
/// rounding included; at 0 all curves are written, and coordinates are within 1/2000 pixel.
/// Guarantees: components that meet share their contours to the last digit.
/// Cost: linear in pixels and segments. Source: Schapfel, sections 4.5, 4.10 and 7.1.8.
std::string write_svg(const PlanarMap& map, const SimilarityGraph& graph,
                      double tolerance_px = kSvgTolerance);

/// Appends the shapes of all components to a document.
void append_components(const PlanarMap& map, const SimilarityGraph& graph, double tolerance_px,
                       SvgDocument& document);

}  // namespace depixel
