#pragma once

#include <string>
#include <vector>

#include "libdepixel/stages/components.hpp"
#include "libdepixel/stages/planar_map.hpp"

namespace depixel {

/// Appends what makes colours run inside regions, to be drawn on top of the components' shapes; nothing where
/// nothing is shaded. Each pixel that is shaded, or beside one that is, is drawn once more, clipped to the
/// component, and to those that it blends with across soft contours: as a disc three pixels wide that
/// fades out (ShadingKind::gradient), or as a square, all of which are blurred (else). What is not opaque
/// keeps its one colour. \param path_data  of each component; even-odd. Source: Schapfel, sections 4.8
/// and 7.1.2.
void append_svg_shading(const PlanarMap& map, const Components& components,
                        const std::vector<std::string>& path_data, std::string& out);

}  // namespace depixel
