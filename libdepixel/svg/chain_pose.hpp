#pragma once

#include <array>
#include <span>
#include <vector>

#include "libdepixel/svg/curve_fit.hpp"

namespace depixel {

/// A chain of curves, each of which starts where the one before ends, and what is round it.
struct Chain {
  std::vector<Cubic> curves;
  bool is_closed = false;
  std::array<bool, 2> is_free{};  ///< whether curves need not keep the tangent at its start, and at its end
  int weight = 1;                 ///< of how far curves stray (chain_simplifier.hpp)
};

/// One of the ways to look at a chain: flipped, turned, moved by whole pixels, from its other end, and, if it
/// is closed, from another start.
struct ChainPose {
  bool swaps = false;
  glm::ivec2 sign{1, 1};
  bool is_reversed = false;
  int start = 0;
  glm::ivec2 shift{0, 0};

  glm::ivec2 apply(glm::ivec2 point) const { return turned(point * sign) - shift; }
  glm::ivec2 undo(glm::ivec2 point) const { return turned(point + shift) * sign; }

 private:
  glm::ivec2 turned(glm::ivec2 point) const { return swaps ? glm::ivec2(point.y, point.x) : point; }
};

/// The pose in which a chain is the same as all those that it could be flipped, turned or moved to are in
/// theirs. \param starts  of a closed chain: the nodes it may start at. Cost: a few dozen steps for each.
ChainPose find_pose(const Chain& chain, std::span<const int> starts);

/// A chain in a pose, and the curves that stand for it put back from there.
void apply_pose(const ChainPose& pose, const Chain& chain, Chain& posed);
void undo_pose(const ChainPose& pose, std::span<const Cubic> posed, std::vector<Cubic>& out);

}  // namespace depixel
