#pragma once

#include <glm/vec2.hpp>
#include <stdexcept>
#include <vector>

#include "libdepixel/pipeline/vectorizer.hpp"

namespace depixel::test {

/// A contour's curve read back from the planar map, in source pixels.
struct ReadCurve {
  bool closed = false;
  std::vector<glm::dvec2> nodes;  ///< of the cell graph: corners and quarter-pixel splits
  std::vector<glm::dvec2> knots;  ///< where segments meet
  std::vector<glm::dvec2>
      controls;  ///< spline control points, from the segment that leaves (at an open end: arrives)
};

/// A Bezier segment of a uniform B-spline has its inner points at a third and two thirds between two control
/// points, so these can be had back: to within 3/4096 pixel, for inner points are rounded.
constexpr double kReadBackTolerance = 4.0 / 4096;

/// The segment of a map along the edge that leaves a corner with a heading, seen in that direction.
inline Segment segment_along(const PlanarMap& map, int corner, Direction heading) {
  const std::array<int, 4> left = map.lattice.left_offsets();
  const int on_left = corner + left[heading], on_right = corner + left[turned(heading, 1)];
  for (const Segment& s : map.segments) {
    if (s.left == on_left && s.right == on_right) return s;
    if (s.left == on_right && s.right == on_left) return {s.p3, s.p2, s.p1, s.p0, on_left, on_right};
  }
  throw std::logic_error("no segment lies along this edge");
}

inline std::vector<ReadCurve> read_curves(const Vectorizer& v) {
  const auto pixels = [](glm::ivec2 p) { return glm::dvec2(p) / 4096.0; };
  std::vector<ReadCurve> curves;
  for (const Contour& contour : v.contours().list) {
    ReadCurve curve;
    curve.closed = contour.closed;
    for (int k = contour.first; k < contour.first + contour.count; ++k) {
      const int corner = v.contours().corner[k];
      const auto heading = static_cast<Direction>(v.contours().heading[k]);
      curve.nodes.push_back(glm::dvec2(v.cells().lattice.corner_position(corner)) +
                            glm::dvec2(v.cells().corners[corner].node_quarters(heading)) * 0.25);
    }
    Segment segment{};
    for (int k = contour.first; k < contour.first + contour.step_count(); ++k) {
      segment =
          segment_along(v.map(), v.contours().corner[k], static_cast<Direction>(v.contours().heading[k]));
      curve.knots.push_back(pixels(segment.p0));
      curve.controls.push_back(2.0 * pixels(segment.p1) - pixels(segment.p2));
    }
    if (!contour.closed) {
      curve.knots.push_back(pixels(segment.p3));
      curve.controls.push_back(2.0 * pixels(segment.p2) - pixels(segment.p1));
    }
    curves.push_back(curve);
  }
  return curves;
}

}  // namespace depixel::test
