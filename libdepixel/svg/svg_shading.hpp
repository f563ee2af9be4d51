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
/// nothing is shaded. All is clipped to groups of components that blend with each other (soft_groups.hpp).
/// With ShadingKind::gradient, strips of linear gradients show the raster's mixtures (gradient_strips.hpp).
/// Else each pixel that is shaded, or beside one that is, is drawn once more in its group, and in those that
/// it blends with across soft contours: as a square, all of which are blurred; or, with ShadingKind::discs,
/// as a radial gradient three pixels wide. What is not opaque keeps its one colour. Limits: along the edges
/// of clips, which renderers smooth, some of the components' own colours shows; and discs, painted over each
/// other, do not add up to a mixture. Source: Schapfel, sections 4.8 (discs) and 7.1.2 (blur).
void append_svg_shading(const PlanarMap& map, const Components& components, const ComponentPath& append_path,
                        std::string& out);

}  // namespace depixel
