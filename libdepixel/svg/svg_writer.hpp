#pragma once

#include <string>

#include "libdepixel/stages/outlines.hpp"
#include "libdepixel/svg/svg_document.hpp"

namespace depixel {

/// Writes a planar map as an SVG document: one path a component, with holes by the even-odd rule; viewBox,
/// width and height in source pixels. Transparent components are left out. Where the map is
/// shaded, shadings are drawn on top (svg_shading.hpp). \param graph  the resolved
/// similarity graph that the map was made from. Guarantees: components that meet share their points to the
/// last digit; coordinates are within 1/2000 pixel. Cost: linear in pixels and segments. Source: Schapfel,
/// sections 4.5 and 4.10.
std::string write_svg(const PlanarMap& map, const SimilarityGraph& graph);

/// Appends the shapes of all components to a document.
void append_components(const PlanarMap& map, const SimilarityGraph& graph, SvgDocument& document);

}  // namespace depixel
