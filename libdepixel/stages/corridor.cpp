#include "libdepixel/stages/corridor.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "libdepixel/core/simd.hpp"
#include "libdepixel/core/tolerances.hpp"

namespace depixel {
namespace {

/// Clearance in pixels, with room for the rounding to subpixels of points and thirds.
constexpr float kClearance = (kCentreClearance + 2.0f) / kSubpixels;
constexpr float kHalfWidth = 0.5f - kClearance;

/// Rounds of halving the way back to the cell graph, before going all the way.
constexpr int kHalvings = 3;

/// Whether points, in (along, left) coordinates, keep clear of the centre on the left; for the right, mirror
/// them.
bool clears_left(const std::array<glm::vec2, 4>& points) {
  constexpr float kDiagonal = 0.70710678f;
  float level = 1e9f, forward = 1e9f, backward = 1e9f;
  for (const glm::vec2 p : points) {
    const float along = p.x - 0.5f, right = 0.5f - p.y;
    level = std::min(level, right);
    forward = std::min(forward, kDiagonal * (right + along));
    backward = std::min(backward, kDiagonal * (right - along));
  }
  return std::max(level, std::max(forward, backward)) >= kClearance;
}

std::array<glm::vec2, 4> mirrored(std::array<glm::vec2, 4> points) {
  for (glm::vec2& p : points) p.y = -p.y;
  return points;
}

/// Both halves of a cubic, by de Casteljau's construction at the middle.
std::array<std::array<glm::vec2, 4>, 2> halves(const std::array<glm::vec2, 4>& p) {
  const glm::vec2 a = (p[0] + p[1]) * 0.5f, b = (p[1] + p[2]) * 0.5f, c = (p[2] + p[3]) * 0.5f;
  const glm::vec2 ab = (a + b) * 0.5f, bc = (b + c) * 0.5f, middle = (ab + bc) * 0.5f;
  return {{{p[0], a, ab, middle}, {middle, bc, c, p[3]}}};
}

bool clears_both_sides(const std::array<glm::vec2, 4>& points, int splits) {
  const std::array<glm::vec2, 4> mirror = mirrored(points);
  if (clears_left(points) && clears_left(mirror)) return true;
  if (splits == 0) return false;
  const auto half = halves(points);
  return clears_both_sides(half[0], splits - 1) && clears_both_sides(half[1], splits - 1);
}

/// Quick test for eight segments at once: are their control points and knots in the strip between the centres
/// on both sides? Writes 1 where they are not.
DEPIXEL_VECTOR_CLONES void find_strays(const std::array<const float*, 2>& control,
                                       const std::array<const float*, 2>& knot, const float* step_x, int from,
                                       int to, std::uint8_t* strays) {
  const auto across = [&](int axis, int i) __attribute__((always_inline)) {
    return max8(max8(abs8(load8(control[axis] + i)), abs8(load8(control[axis] + i + 1))),
                max8(abs8(load8(knot[axis] + i)), abs8(load8(knot[axis] + i + 1))));
  };
  for (int i = from; i < to; i += kFloatLanes) {
    const Float8 levels = load8(step_x + i) != 0 ? across(1, i) : across(0, i);
    const auto mask = levels > kHalfWidth;
    std::array<std::uint64_t, 4> parts;
    static_assert(sizeof parts == sizeof mask);
    std::memcpy(parts.data(), &mask, sizeof parts);
    std::memset(strays + i, 0, kFloatLanes);
    if ((parts[0] | parts[1] | parts[2] | parts[3]) == 0) continue;
    for (int lane = 0; lane < kFloatLanes; ++lane) strays[i + lane] = mask[lane] != 0;
  }
}

void fill_member_ghosts(const ArcBatch::Member& member, ArcBatch& batch) {
  for (auto* values : {&batch.x, &batch.y}) ArcBatch::fill_ghosts(member, *values, 0.0f);
}

void fill_knot_ghosts(const ArcBatch::Member& member, ArcBatch& batch) {
  for (auto* values : {&batch.knot_x, &batch.knot_y}) ArcBatch::fill_ghosts(member, *values, 0.0f);
}

}  // namespace

bool is_clear(const std::array<glm::vec2, 4>& points, Direction heading) {
  constexpr int kSplits = 2;
  const glm::vec2 along = kStep[heading], left = kStep[turned(heading, 3)];
  std::array<glm::vec2, 4> local;
  for (int j = 0; j < 4; ++j) {
    local[j] = {points[j].x * along.x + points[j].y * along.y, points[j].x * left.x + points[j].y * left.y};
  }
  const bool is_in_strip = std::fabs(local[0].y) <= kHalfWidth && std::fabs(local[1].y) <= kHalfWidth &&
                           std::fabs(local[2].y) <= kHalfWidth && std::fabs(local[3].y) <= kHalfWidth;
  if (is_in_strip) return true;
  return clears_both_sides(local, kSplits);
}

void Corridor::flag_suspects(const ArcBatch& batch) {
  find_strays({batch.x.data(), batch.y.data()}, {batch.knot_x.data(), batch.knot_y.data()},
              batch.step_x.data(), ArcBatch::kGhosts, batch.size - ArcBatch::kGhosts, suspect_.data());
}

bool Corridor::find_blocked(const ArcBatch& batch, const ArcBatch::Member& member) {
  blocked_.clear();
  for (int k = 0; k < member.step_count(); ++k) {
    const int i = member.first + k;
    if (!suspect_[i]) continue;
    const glm::vec2 step(batch.step_x[i], batch.step_y[i]);
    const glm::vec2 a(batch.x[i], batch.y[i]), b = glm::vec2(batch.x[i + 1], batch.y[i + 1]) + step;
    const glm::vec2 end = glm::vec2(batch.knot_x[i + 1], batch.knot_y[i + 1]) + step;
    const std::array<glm::vec2, 4> points{glm::vec2(batch.knot_x[i], batch.knot_y[i]), (2.0f * a + b) / 3.0f,
                                          (a + 2.0f * b) / 3.0f, end};
    if (!is_clear(points, batch.word[i].heading())) blocked_.push_back(k);
  }
  return !blocked_.empty();
}

/// Moves the four control points of every blocked segment a part of the way back to the cell graph.
void Corridor::retreat(const ArcBatch::Member& member, float part, ArcBatch& batch) {
  retreats_.assign(member.count, 0);
  for (const int k : blocked_) {
    for (int j = k - 1; j <= k + 2; ++j) {
      if (member.closed) retreats_[ArcBatch::wrapped(j, member.count)] = 1;
      if (!member.closed && j >= 0 && j < member.count) retreats_[j] = 1;
    }
  }
  for (int k = 0; k < member.count; ++k) {
    const int i = member.first + k;
    if (!retreats_[k] || batch.role[i] == NodeRole::held) continue;
    const ShapeWord word = batch.word[i];
    const glm::vec2 home = glm::vec2(word.code().node_quarters(word.heading())) * 0.25f;
    batch.x[i] += part * (home.x - batch.x[i]);
    batch.y[i] += part * (home.y - batch.y[i]);
  }
}

/// After a retreat, only segments with a moved control point need another look.
void Corridor::suspect_changed(const ArcBatch::Member& member) {
  const auto moved = [&](int k) {
    if (member.closed) return retreats_[ArcBatch::wrapped(k, member.count)] != 0;
    return k >= 0 && k < member.count && retreats_[k] != 0;
  };
  for (int k = 0; k < member.count; ++k) {
    suspect_[member.first + k] = moved(k - 1) || moved(k) || moved(k + 1) || moved(k + 2) ? 1 : 0;
  }
}

void Corridor::keep_clear(ArcBatch& batch, std::vector<std::uint8_t>& retracted) {
  if (suspect_.size() < batch.x.size()) suspect_.resize(batch.x.size());
  batch.close(batch.x, batch.y);
  batch.find_knots(ArcBatch::kGhosts, batch.size - ArcBatch::kGhosts);
  for (const ArcBatch::Member& member : batch.members) fill_knot_ghosts(member, batch);
  flag_suspects(batch);
  retracted.assign(batch.x.size(), 0);
  for (const ArcBatch::Member& member : batch.members) {
    bool is_blocked = find_blocked(batch, member);
    if (!is_blocked) continue;
    for (int round = 0; is_blocked && round <= kHalvings; ++round) {
      retreat(member, round < kHalvings ? 0.5f : 1.0f, batch);
      fill_member_ghosts(member, batch);
      batch.find_knots(member.first, member.last() + 1);
      fill_knot_ghosts(member, batch);
      suspect_changed(member);
      is_blocked = find_blocked(batch, member);
    }
    for (const int k : blocked_) retracted[member.first + k] = 1;
  }
}

}  // namespace depixel
