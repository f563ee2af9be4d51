#pragma once

#include "libdepixel/core/memory.hpp"
#include "libdepixel/stages/arc_batch.hpp"

namespace depixel {

/// Buffers for smoothing; kept from frame to frame.
struct SmoothingScratch {
  std::vector<float> bend_x, bend_y;

  std::size_t memory_bytes() const { return held_bytes(bend_x, bend_y); }
};

/// Moves the nodes of a batch towards least energy: over all nodes, the squared bending |a - 2b + c|^2 of the
/// node and its neighbours plus the distance from rest to the fourth power, times a weight. Simultaneous
/// (Jacobi) sweeps, so the result does not depend on where a contour starts or which way it runs; coarse
/// ones, between neighbours two steps away, come first and carry long waves, fine ones follow. \post  |x|,
/// |y| <= 7/16. Cost: linear in nodes. Source: Kopf and Lischinski 2011, section 3.4; Schapfel, section 4.7.
void minimize_energy(ArcBatch& batch, SmoothingScratch& scratch);

/// Averages the control points of a batch with their neighbours, (1 2 1)/4, in as many rounds
/// as each member has; nodes that are not free stay put. Source: Schapfel, section 4.7.
void average_control_points(ArcBatch& batch, SmoothingScratch& scratch);

}  // namespace depixel
