#include "libdepixel/svg/chain_pose.hpp"

#include <algorithm>
#include <compare>

namespace depixel {
namespace {

Cubic applied(const ChainPose& pose, const Cubic& c) {
  return {pose.apply(c.p0), pose.apply(c.p1), pose.apply(c.p2), pose.apply(c.p3)};
}

/// A curve of a chain, counted from the pose's start in its direction.
Cubic posed_curve(const ChainPose& pose, const Chain& chain, int index) {
  const auto size = static_cast<int>(chain.curves.size());
  if (!pose.is_reversed) return applied(pose, chain.curves[(pose.start + index) % size]);
  return applied(pose, chain.curves[(pose.start - 1 - index + 2 * size) % size].reversed());
}

std::array<bool, 2> posed_ends(const ChainPose& pose, const Chain& chain) {
  if (!pose.is_reversed) return chain.is_free;
  return {chain.is_free[1], chain.is_free[0]};
}

std::array<int, 8> numbers(const Cubic& c) {
  return {c.p0.x, c.p0.y, c.p1.x, c.p1.y, c.p2.x, c.p2.y, c.p3.x, c.p3.y};
}

bool is_before(const ChainPose& a, const ChainPose& b, const Chain& chain) {
  if (const auto order = posed_ends(a, chain) <=> posed_ends(b, chain); order != 0) return order < 0;
  for (int i = 0; i < static_cast<int>(chain.curves.size()); ++i) {
    const auto order = numbers(posed_curve(a, chain, i)) <=> numbers(posed_curve(b, chain, i));
    if (order != 0) return order < 0;
  }
  return false;
}

/// Moves a pose by whole pixels, so that the chain starts in the pixel at the origin.
void move_to_origin(ChainPose& pose, const Chain& chain) {
  pose.shift = {0, 0};
  const glm::ivec2 start = posed_curve(pose, chain, 0).p0;
  static_assert((kSubpixels & (kSubpixels - 1)) == 0);
  pose.shift = {start.x & -kSubpixels, start.y & -kSubpixels};
}

}  // namespace

ChainPose find_pose(const Chain& chain, std::span<const int> starts) {
  constexpr int kPoses = 16;
  ChainPose best;
  bool is_first = true;
  for (const int start : starts) {
    for (int i = 0; i < kPoses; ++i) {
      ChainPose pose{(i & 1) != 0, {(i & 2) != 0 ? -1 : 1, (i & 4) != 0 ? -1 : 1}, (i & 8) != 0, start, {}};
      move_to_origin(pose, chain);
      if (is_first || is_before(pose, best, chain)) best = pose;
      is_first = false;
    }
  }
  return best;
}

void apply_pose(const ChainPose& pose, const Chain& chain, Chain& posed) {
  posed.curves.clear();
  for (int i = 0; i < static_cast<int>(chain.curves.size()); ++i) {
    posed.curves.push_back(posed_curve(pose, chain, i));
  }
  posed.is_closed = chain.is_closed;
  posed.is_free = posed_ends(pose, chain);
  posed.weight = chain.weight;
}

void undo_pose(const ChainPose& pose, std::span<const Cubic> posed, std::vector<Cubic>& out) {
  const std::size_t first = out.size();
  for (const Cubic& c : posed) {
    const Cubic curve{pose.undo(c.p0), pose.undo(c.p1), pose.undo(c.p2), pose.undo(c.p3)};
    out.push_back(pose.is_reversed ? curve.reversed() : curve);
  }
  if (pose.is_reversed) std::reverse(out.begin() + static_cast<std::ptrdiff_t>(first), out.end());
}

}  // namespace depixel
