#include "libdepixel/stages/arc_batch.hpp"

#include <algorithm>

#include "libdepixel/core/simd.hpp"

namespace depixel {
namespace {

DEPIXEL_VECTOR_CLONES void knots_of(const float* control, const float* step, const float* smoothness,
                                    int from, int to, float* knot) {
  for (int i = from; i < to; i += kFloatLanes) {
    const Float8 turn = load8(step + i) - load8(step + i - 1), at = load8(control + i);
    const Float8 bend = turn + ((load8(control + i - 1) + load8(control + i + 1)) - 2 * at);
    store8(knot + i, at + load8(smoothness + i) * bend);
  }
}

struct Roles {
  const float *mobility, *held;
};
struct Bends {
  float *fine, *coarse;
};
struct Positions {
  float *x, *y;
};

DEPIXEL_VECTOR_CLONES void find_bends(const Roles& roles, int size, const Bends& bends,
                                      const Positions& nodes) {
  constexpr float kReach = ArcBatch::kReach;
  for (int i = ArcBatch::kGhosts; i < size - ArcBatch::kGhosts; i += kFloatLanes) {
    const Float8 free = load8(roles.mobility + i);
    const Float8 between_held = (1 - load8(roles.held + i - 1)) * (1 - load8(roles.held + i + 1));
    store8(bends.fine + i, free * between_held);
    store8(bends.coarse + i, free * (load8(roles.mobility + i - 1) * load8(roles.mobility + i + 1)));
    store8(nodes.x + i, clamp8(load8(nodes.x + i), -kReach, kReach));
    store8(nodes.y + i, clamp8(load8(nodes.y + i), -kReach, kReach));
  }
}

}  // namespace

ArcBatch::Member& ArcBatch::add(std::span<const ShapeWord> words, ArcKind kind, int source) {
  const int first = size + kGhosts, count = static_cast<int>(words.size());
  size = first + count + kGhosts;
  if (static_cast<int>(x.size()) < size + 2 * kFloatLanes) {
    const std::size_t room = static_cast<std::size_t>(size) + size / 2 + 2 * kFloatLanes;
    for (auto* values : {&x, &y, &rest_x, &rest_y, &step_x, &step_y, &mobility, &held, &bends1, &bends2,
                         &knot_x, &knot_y, &smoothness}) {
      values->resize(room);
    }
    role.resize(room);
    word.resize(room);
  }
  members.push_back({first, count, kind.closed, kind.interpolated, kind.rounds, source});
  std::copy(words.begin(), words.end(), word.begin() + first);
  for (int k = 0; k < count; ++k) {
    const glm::ivec2 step = kStep[words[k].heading()];
    step_x[first + k] = static_cast<float>(step.x);
    step_y[first + k] = static_cast<float>(step.y);
  }
  Member& member = members.back();
  fill_ghosts(member, step_x, 0.0f);
  fill_ghosts(member, step_y, 0.0f);
  return member;
}

void ArcBatch::settle() {
  for (const Member& member : members) {
    fill_ghosts(member, mobility, 0.0f);
    fill_ghosts(member, held, 0.0f);
  }
  find_bends({mobility.data(), held.data()}, size, {bends1.data(), bends2.data()}, {x.data(), y.data()});
  for (const Member& member : members) {
    if (member.closed &&
        member.count == 2 * kGhosts) {  // a node's neighbours two steps away would be one and the same
      std::fill_n(bends2.begin() + member.first, member.count, 0.0f);
    }
    fill_ghosts(member, bends1, 0.0f);
    fill_ghosts(member, bends2, 0.0f);
  }
}

void ArcBatch::close(std::vector<float>& values_x, std::vector<float>& values_y) const {
  for (const Member& member : members) {
    if (!member.closed) continue;
    close_ghosts(member, values_x);
    close_ghosts(member, values_y);
  }
}

void ArcBatch::find_knots(int from, int to) {
  knots_of(x.data(), step_x.data(), smoothness.data(), from, to, knot_x.data());
  knots_of(y.data(), step_y.data(), smoothness.data(), from, to, knot_y.data());
}

}  // namespace depixel
