#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "libdepixel/raster/cpu_raster.hpp"

namespace depixel::test {

/// What a view of a map should look like: for each output pixel the mean of red, green, blue (times alpha)
/// and alpha, 0..255 each. Walks many lines along each row of pixels and integrates exactly along them; the
/// colour changes only where a curve crosses the line. Slow and simple; shares no code with the rasteriser.
/// \param linear_light  means of linear light instead of sRGB values, 255 being white.
std::vector<glm::dvec4> sampled(const PlanarMap& map, const View& view, bool linear_light, int width,
                                int height);

/// A drawn pixel in the same terms.
glm::dvec4 sample_of(Rgba c, bool linear_light);

}  // namespace depixel::test
