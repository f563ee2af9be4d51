#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <glm/vec2.hpp>

#include "libdepixel/core/tolerances.hpp"

namespace depixel {

/// Cuts a cubic Bezier curve, in output subpixels, into lines that stay within kFlatteningTolerance of it.
/// \param line  called with both ends of each line, in order; the last ends in p3 exactly.
template <typename Line>
void flatten(glm::ivec2 p0, glm::ivec2 p1, glm::ivec2 p2, glm::ivec2 p3, Line line) {
  const glm::ivec2 bend0 = p0 - 2 * p1 + p2, bend1 = p1 - 2 * p2 + p3;
  const int bend = std::max(std::max(std::abs(bend0.x), std::abs(bend0.y)),
                            std::max(std::abs(bend1.x), std::abs(bend1.y)));
  // A cubic strays from its chord by 6 bend / 8 at most, along either axis; n pieces divide that by n
  // squared.
  std::int64_t pieces = 1;
  while (3 * std::int64_t{bend} > 4 * std::int64_t{kFlatteningTolerance} * pieces * pieces) ++pieces;
  if (pieces == 1) {
    line(p0, p3);
    return;
  }
  const glm::dvec2 c1(3 * (p1 - p0)), c2(3 * bend0), c3(p3 - p0 + 3 * (p1 - p2));
  glm::ivec2 from = p0;
  const double piece = 1.0 / static_cast<double>(pieces);
  for (int i = 1; i < pieces; ++i) {
    const double t = i * piece;
    const glm::dvec2 way = ((c3 * t + c2) * t + c1) * t;
    const glm::ivec2 to = p0 + glm::ivec2(std::lrint(way.x), std::lrint(way.y));
    line(from, to);
    from = to;
  }
  line(from, p3);
}

}  // namespace depixel
