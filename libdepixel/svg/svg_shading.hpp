#pragma once

#include <functional>
#include <string>

#include "libdepixel/stages/components.hpp"
#include "libdepixel/stages/planar_map.hpp"
#include "libdepixel/svg/svg_document.hpp"

namespace depixel {

/// Writes the outlines of a component, on a grid.
struct ComponentPath {
  SvgGrid grid;
  std::function<void(int component, SvgPathData& path)> append;
};

/// Appends what makes colours run inside regions, to be drawn on top of the components' shapes; nothing where
/// nothing is shaded. Each pixel that is shaded, or beside one that is, is drawn once more, clipped to its
/// group of components that blend with each other (soft_groups.hpp), and to those that it blends with across
/// soft contours: as a disc three pixels wide that fades out (ShadingKind::gradient), or as a square, all of
/// which are blurred (else). What is not opaque keeps its one colour. Source: Schapfel, sections 4.8
/// and 7.1.2.
void append_svg_shading(const PlanarMap& map, const Components& components, const ComponentPath& append_path,
                        std::string& out);

}  // namespace depixel
