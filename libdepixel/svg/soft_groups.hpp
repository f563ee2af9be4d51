#pragma once

#include <vector>

#include "libdepixel/stages/components.hpp"
#include "libdepixel/stages/planar_map.hpp"

namespace depixel {

/// Groups components that blend with each other wherever they meet, so that one clipping path will do for
/// all of a group: no two components of a group meet at a sharp contour. Which of two groups a component
/// comes to where it could be in either depends on raster order.
/// \return  the group of each component; 0 .. groups - 1. Components that are not opaque are groups of their
/// own. Cost: that of sorting the pairs of components that meet.
std::vector<int> find_soft_groups(const PlanarMap& map, const Components& components);

}  // namespace depixel
