#pragma once

#include <glm/vec2.hpp>
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

inline std::vector<ReadCurve> read_curves(const Vectorizer& v) {
  const auto pixels = [](glm::ivec2 p) { return glm::dvec2(p) / 4096.0; };
  std::vector<ReadCurve> curves;
  const Segment* segment = v.map().segments.data();
  for (const Contour& contour : v.contours().list) {
    ReadCurve curve;
    curve.closed = contour.closed;
    for (int k = contour.first; k < contour.first + contour.count; ++k) {
      const int corner = v.contours().corner[k];
      const auto heading = static_cast<Direction>(v.contours().heading[k]);
      curve.nodes.push_back(glm::dvec2(v.cells().lattice.corner_position(corner)) +
                            glm::dvec2(v.cells().corners[corner].node_quarters(heading)) * 0.25);
    }
    for (int k = 0; k < contour.step_count(); ++k, ++segment) {
      curve.knots.push_back(pixels(segment->p0));
      curve.controls.push_back(2.0 * pixels(segment->p1) - pixels(segment->p2));
    }
    if (!contour.closed) {
      curve.knots.push_back(pixels(segment[-1].p3));
      curve.controls.push_back(2.0 * pixels(segment[-1].p2) - pixels(segment[-1].p1));
    }
    curves.push_back(curve);
  }
  return curves;
}

}  // namespace depixel::test
