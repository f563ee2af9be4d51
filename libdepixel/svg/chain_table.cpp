#include "libdepixel/svg/chain_table.hpp"

#include <numeric>

namespace depixel {

void ChainTable::simplify(const Chain& chain, std::vector<Cubic>& out) {
  find_starts(chain);
  const ChainPose pose = find_pose(chain, starts_);
  apply_pose(pose, chain, posed_);
  write_key();
  auto found = known_.find(std::string_view(key_));
  if (found == known_.end()) {
    const std::size_t first = curves_.size();
    simplifier_.simplify(posed_, curves_);
    found = known_.emplace(key_, Range{first, curves_.size() - first}).first;
  }
  undo_pose(pose, std::span(curves_).subspan(found->second.first, found->second.count), out);
}

/// A closed chain starts at a corner, if it has one.
void ChainTable::find_starts(const Chain& chain) {
  starts_.assign(1, 0);
  if (!chain.is_closed) return;
  starts_.clear();
  const auto size = static_cast<int>(chain.curves.size());
  for (int i = 0; i < size; ++i) {
    if (is_corner(chain.curves[(i + size - 1) % size], chain.curves[i])) starts_.push_back(i);
  }
  if (!starts_.empty()) return;
  starts_.resize(size);
  std::iota(starts_.begin(), starts_.end(), 0);
}

/// All that a simplified chain depends on.
void ChainTable::write_key() {
  key_.clear();
  key_ += static_cast<char>((posed_.is_closed ? 1 : 0) + (posed_.is_free[0] ? 2 : 0) +
                            (posed_.is_free[1] ? 4 : 0));
  key_ += static_cast<char>(posed_.weight);
  const auto add = [this](glm::ivec2 point) {
    for (const int value : {point.x, point.y}) {
      for (int shift = 0; shift < 32; shift += 8) key_ += static_cast<char>(value >> shift & 255);
    }
  };
  add(posed_.curves.front().p0);
  for (const Cubic& c : posed_.curves) {
    add(c.p1);
    add(c.p2);
    add(c.p3);
  }
}

}  // namespace depixel
