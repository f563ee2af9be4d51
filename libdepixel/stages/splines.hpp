#pragma once

#include <cstdint>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/core/options.hpp"
#include "libdepixel/core/tolerances.hpp"
#include "libdepixel/stages/corridor.hpp"
#include "libdepixel/stages/interpolation.hpp"
#include "libdepixel/stages/node_placement.hpp"
#include "libdepixel/stages/smoothing.hpp"

namespace depixel {

/// Uniform cubic B-splines along all contours; for each node of Contours, in subpixels from the node's
/// lattice corner.
struct Splines {
  std::vector<glm::ivec2> control;  ///< control point
  std::vector<glm::ivec2> knot;     ///< the curve's point at the node, where two Bezier segments meet
  /// 1 where the segment that leaves the node has both inner points in the middle of its lattice edge, the
  /// point that is farthest from the pixel centres on its sides.
  std::vector<std::uint8_t> is_retracted;

  std::size_t memory_bytes() const { return held_bytes(control, knot, is_retracted); }
};

/// Smooths the contours and fits splines to them (stage 5 of 6). Keeps its buffers from frame to frame.
///
/// The adaptive kind interpolates closed contours of fewer than 30 nodes and approximates the others. Where a
/// curve would come too near to a pixel centre, its control points go back towards the cell graph's nodes. A
/// contour that ends at a T-junction ends on the knot of the contour that goes through. Source: Schapfel,
/// sections 4.6 and 4.7; Kopf and Lischinski 2011, section 3.4.
class SplineFitter {
 public:
  void fit(const SimilarityGraph& graph, const CellGraph& cells, const Contours& contours, SplineKind kind,
           Smoothing smoothing, Splines& splines);

  std::size_t memory_bytes() const {
    return held_bytes(thin_, retracted_) + placer_.memory_bytes() + batch_.memory_bytes() +
           smoothing_.memory_bytes() + corridor_.memory_bytes() + interpolation_.memory_bytes();
  }

 private:
  void fit_batch(const CellGraph& cells, const Contours& contours, Smoothing smoothing, Splines& splines);
  void join_t_junctions(const CellGraph& cells, const Contours& contours, Splines& splines);

  std::vector<std::uint8_t> thin_;
  NodePlacer placer_;
  ContourBatch batch_;
  SmoothingScratch smoothing_;
  Corridor corridor_;
  InterpolationScratch interpolation_;
  std::vector<std::uint8_t> retracted_;
};

}  // namespace depixel
