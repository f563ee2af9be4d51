#include "libdepixel/stages/planar_map.hpp"

namespace depixel {
namespace {

/// The integer nearest to v / 3; thirds never lie half-way.
constexpr int third(int v) {
  return (v + (v >= 0 ? 1 : -1)) / 3;
}

/// The point a third of the way from a to b.
glm::ivec2 thirds(glm::ivec2 a, glm::ivec2 b) {
  return {third(2 * a.x + b.x), third(2 * a.y + b.y)};
}

}  // namespace

void build_planar_map(const CellGraph& cells, const Contours& contours, const Splines& splines,
                      PlanarMap& map) {
  map.lattice = cells.lattice;
  map.colours = cells.colours;
  int steps = 0;
  for (const Contour& contour : contours.list) steps += contour.step_count();
  map.segments.resize(steps);
  Segment* segment = map.segments.data();
  const std::array<int, 4> left = cells.lattice.left_offsets();
  for (const Contour& contour : contours.list) {
    const int last = contour.first + contour.count - 1;
    glm::ivec2 origin = cells.lattice.corner_position(contours.corner[contour.first]) * kSubpixels;
    for (int k = 0; k < contour.step_count(); ++k) {
      const int from = contour.first + k, to = from == last ? contour.first : from + 1;
      const int corner = contours.corner[from];
      const auto heading = static_cast<Direction>(contours.heading[from]);
      const glm::ivec2 step = kStep[heading] * kSubpixels;
      const bool is_retracted = splines.is_retracted[from];
      const glm::ivec2 a = is_retracted ? step / 2 : splines.control[from];
      const glm::ivec2 b = is_retracted ? step / 2 : step + splines.control[to];
      const glm::ivec2 next = origin + step;
      *segment++ = {origin + splines.knot[from], origin + thirds(a, b),  origin + thirds(b, a),
                    next + splines.knot[to],     corner + left[heading], corner + left[turned(heading, 1)]};
      origin = next;
    }
  }
}

}  // namespace depixel
