#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/stages/arc_batch.hpp"

namespace depixel {

/// True when a cubic stays clear of the two pixel centres on its sides, and between them.
/// \param points   control points, in pixels, from the lattice corner that the step leaves.
/// \param heading  of the step.
/// The test is sufficient, not necessary: the control points of the curve, or of its halves, lie on one side
/// of a line that keeps the clearance from the centre and is level or slanted by 45 degrees.
bool is_clear(const std::array<glm::vec2, 4>& points, Direction heading);

/// Keeps splines clear of pixel centres (1/16 pixel, see tolerances.hpp): the promise that every pixel keeps
/// its own colour at its centre.
class Corridor {
 public:
  /// Computes the knots of a batch's splines, and moves control points of segments that are not clear back
  /// towards the cell graph until all are; a segment that is not clear even then is retracted to its lattice
  /// edge. \param batch     x, y hold control points; writes knot_x, knot_y, and x, y where needed. \param
  /// retracted  by entry: set to 1 for retracted segments, else 0.
  void keep_clear(ArcBatch& batch, std::vector<std::uint8_t>& retracted);

  std::size_t memory_bytes() const { return held_bytes(suspect_, blocked_, retreats_); }

 private:
  void flag_suspects(const ArcBatch& batch);
  bool find_blocked(const ArcBatch& batch, const ArcBatch::Member& member);
  void retreat(const ArcBatch::Member& member, float part, ArcBatch& batch);

  void suspect_changed(const ArcBatch::Member& member);

  std::vector<std::uint8_t> suspect_;  ///< by entry: the segment that leaves it may not be clear
  std::vector<int> blocked_;           ///< nodes of a member whose segments are not clear
  std::vector<std::uint8_t> retreats_;
};

}  // namespace depixel
