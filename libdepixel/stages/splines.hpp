#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/core/options.hpp"
#include "libdepixel/stages/arcs.hpp"
#include "libdepixel/stages/batch_curves.hpp"
#include "libdepixel/stages/corridor.hpp"
#include "libdepixel/stages/edge_curve.hpp"
#include "libdepixel/stages/interpolation.hpp"
#include "libdepixel/stages/node_placement.hpp"
#include "libdepixel/stages/smoothing.hpp"

namespace depixel {

/// An arc's shape, to which a spline is to be fitted.
struct ArcShape {
  std::span<const ShapeWord> words;
  ArcKind kind;
  EdgeCurve* curves;  ///< one for each step: set by fitting
  TileMask* tiles;    ///< that the curves may touch: set by fitting
};

/// Smooths arcs and fits uniform cubic B-splines to them (stage 5 of 6). Keeps its buffers.
///
/// Where a curve would come too near to a pixel centre, its control points go back towards the cell graph's
/// nodes. What is made of an arc depends on its words and kind, and on nothing else: not on where it lies,
/// nor on what is fitted with it. Source: Schapfel, sections 4.6 and 4.7; Kopf and Lischinski 2011,
/// section 3.4.
class SplineFitter {
 public:
  void fit(std::span<const ArcShape> shapes, const Options& options);

  std::size_t memory_bytes() const {
    return held_bytes(retracted_) + placer_.memory_bytes() + batch_.memory_bytes() +
           smoothing_.memory_bytes() + corridor_.memory_bytes() + interpolation_.memory_bytes() +
           curves_.memory_bytes();
  }

 private:
  void fit_batch(std::span<const ArcShape> shapes, const Options& options);

  NodePlacer placer_;
  ArcBatch batch_;
  SmoothingScratch smoothing_;
  Corridor corridor_;
  InterpolationScratch interpolation_;
  BatchCurves curves_;
  std::vector<std::uint8_t> retracted_;
};

/// A curve with its ends moved to where other contours go through, at T-junctions. Only the end points move:
/// tangents at the other end of the curve stay; where it would come too near to a pixel centre, both inner
/// points go to the middle of the lattice edge, the point that is farthest from the centres on its sides.
EdgeCurve join(const EdgeCurve& curve, bool southwards, glm::i16vec2 p0, glm::i16vec2 p3);

}  // namespace depixel
