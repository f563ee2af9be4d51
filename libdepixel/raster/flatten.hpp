#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <glm/vec2.hpp>

#include "libdepixel/core/simd.hpp"
#include "libdepixel/core/tolerances.hpp"

namespace depixel {

/// How many lines of equal steps in the parameter stay within kFlatteningTolerance of a cubic Bezier curve.
/// Depends on where the curve lies in no way, so that all rasterisers cut it alike.
/// \param p0..p3  in subpixels of the source. \param scale  output pixels to a source pixel, by axis.
inline int flattening_pieces(glm::ivec2 p0, glm::ivec2 p1, glm::ivec2 p2, glm::ivec2 p3, glm::dvec2 scale) {
  const glm::ivec2 bend0 = p0 - 2 * p1 + p2, bend1 = p1 - 2 * p2 + p3;
  const double bend = std::max(std::max(std::abs(bend0.x), std::abs(bend1.x)) * scale.x,
                               std::max(std::abs(bend0.y), std::abs(bend1.y)) * scale.y);
  // A cubic strays from its chord by 6 bend / 8 at most, along either axis; n pieces divide that by n
  // squared.
  constexpr double kSquareOfOnePiece = kFlatteningTolerance * kSubpixels * 8 / 6;
  int pieces = 1;
  while (bend > kSquareOfOnePiece * pieces * pieces) ++pieces;
  return pieces;
}

/// Cuts a cubic Bezier curve into lines, in whatever whole units its points are given.
/// \param line  called with both ends of each line, in order; the last ends in p3 exactly.
template <typename Line>
void flatten(glm::ivec2 p0, glm::ivec2 p1, glm::ivec2 p2, glm::ivec2 p3, int pieces, Line line) {
  if (pieces == 1) {
    line(p0, p3);
    return;
  }
  const auto both_axes = [](glm::ivec2 v) { return Double2{double(v.x), double(v.y)}; };
  const Double2 c1 = both_axes(3 * (p1 - p0)), c2 = both_axes(3 * (p0 - 2 * p1 + p2)),
                c3 = both_axes(p3 - p0 + 3 * (p1 - p2));
  glm::ivec2 from = p0;
  const double piece = 1.0 / pieces;
  for (int i = 1; i < pieces; ++i) {
    const double t = i * piece;
    const std::array<std::int32_t, 2> way = nearest_integers(((c3 * t + c2) * t + c1) * t);
    const glm::ivec2 to = p0 + glm::ivec2(way[0], way[1]);
    line(from, to);
    from = to;
  }
  line(from, p3);
}

}  // namespace depixel
