#pragma once

#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/stages/arc_batch.hpp"

namespace depixel {

/// Buffers for interpolation; kept from frame to frame.
struct InterpolationScratch {
  std::vector<float> node_x, node_y, is_interpolated;

  std::size_t memory_bytes() const { return held_bytes(node_x, node_y, is_interpolated); }
};

/// Replaces the nodes of a batch's interpolated members by the control points of the uniform cubic B-splines
/// that go through them: the solutions of cyclic (closed) or relaxed open 1-4-1 systems; sharp nodes are ends
/// of open systems.
///
/// Solved by simultaneous corrections at Chebyshev rates; after a fixed number of them the error is below
/// half a subpixel. So the cost is linear, and the bits are the same from any start and in either direction.
/// Source: Schapfel, section 4.6.5.
void interpolate_nodes(ArcBatch& batch, InterpolationScratch& scratch);

}  // namespace depixel
