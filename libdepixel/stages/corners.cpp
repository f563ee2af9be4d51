#include "libdepixel/stages/corners.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace depixel {
namespace {

/// How far a corner stands out, at least, in pixels: more than the 4 of circles, for those of a few pixels
/// and the tips of ellipses reach 5.2, and other round things of games 6.1.
constexpr float kHeight = 6.4f;
/// So many steps its arms have at least.
constexpr int kShortestArm = 6;
/// How far from a node's lattice corner its arms may meet, along each axis, in pixels, unless they form a
/// narrow tip. A node cannot go as far (ArcBatch::kReach): the tip is cut off there.
constexpr float kStray = 0.9f;
/// Narrower tips than this are not looked for: the square of the cotangent of half their angle, 35 degrees.
constexpr float kNarrowest = 10.0f;
/// Where the contour turns twice to the same side, a corner is at most so many steps from a turn.
constexpr int kFromTurn = 3;
/// Nodes this near to each other, in steps, are of the same corner.
constexpr int kSameCorner = 3;
/// Arms are laid on their lines up to the middle; from there on less and less.
constexpr float kStraightPart = 0.5f;
/// Steps of the short side at the end of a bar; and of its long ones, at least: where it ends a larger shape,
/// and where it is all there is. Shorter ones are as often the holes of round letters.
constexpr int kBarWidth = 2, kBarLength = 4, kLoneBarLength = 8;

constexpr float kFar = 1e9f;

int cross(glm::ivec2 a, glm::ivec2 b) {
  return a.x * b.y - a.y * b.x;
}
int dot(glm::ivec2 a, glm::ivec2 b) {
  return a.x * b.x + a.y * b.y;
}
int squared_length(const DigitalLine& arm) {
  return dot(arm.end(), arm.end());
}

/// The cosine of the angle between two arms.
float cosine_between(const DigitalLine& a, const DigitalLine& b) {
  const glm::ivec2 u = a.direction(), v = b.direction();
  const float lengths = std::sqrt(static_cast<float>(dot(u, u)) * static_cast<float>(dot(v, v)));
  return static_cast<float>(dot(u, v)) / lengths;
}

/// Whether a corner with these arms stands out.
bool stands_out(const DigitalLine& a, const DigitalLine& b, float cosine) {
  const auto shorter = static_cast<float>(std::min(squared_length(a), squared_length(b)));
  return shorter * (0.5f * (1.0f + cosine)) >= kHeight * kHeight;
}

/// How far from their node two arms of a corner may meet, along an axis, squared: a tip that is narrower than
/// a right angle goes on beyond its last pixel, by the cotangent of half its angle.
float squared_stray(float cosine) {
  return kStray * kStray * std::clamp((1.0f + cosine) / (1.0f - cosine), 1.0f, kNarrowest);
}

/// Where the lines of two arms of a node meet.
std::optional<glm::vec2> meeting_point(const DigitalLine& a, const DigitalLine& b) {
  const glm::ivec2 u = a.direction(), v = b.direction();
  const int area = cross(u, v);
  if (area == 0) return std::nullopt;
  const glm::ivec2 p = v * a.twice_offset() - u * b.twice_offset();
  const auto twice_area = static_cast<float>(2 * area);
  return glm::vec2(static_cast<float>(p.x) / twice_area, static_cast<float>(p.y) / twice_area);
}

}  // namespace

void CornerPlacer::place(std::span<const ShapeWord> words, const Runs& runs, const ArcBatch::Member& member,
                         ArcBatch& batch) {
  words_ = words;
  runs_ = &runs;
  batch_ = &batch;
  member_ = member;
  hold_bar_ends();
  if (static_cast<float>(member.step_count()) < 2 * kHeight) return;
  find_candidates();
  find_corners();
  if (corners_.empty()) return;
  straighten_arms();
}

void CornerPlacer::hold_bar_ends() {
  const Runs& runs = *runs_;
  const bool is_rectangle = member_.closed && runs.count() == 4;
  const int length = is_rectangle ? kLoneBarLength : kBarLength;
  for (int k = 0; k < runs.count(); ++k) {
    const Run& end = runs[k];
    if (end.length != kBarWidth || !end.turns_back()) continue;
    if (runs.neighbour(k, -1)->length < length || runs.neighbour(k, 1)->length < length) continue;
    for (int node = end.start; node <= end.start + kBarWidth; ++node) {
      const int i = member_.first + wrapped(node);
      if (batch_->role[i] != NodeRole::free) continue;
      batch_->set_role(i, NodeRole::sharp);
      batch_->x[i] = batch_->y[i] = 0;
    }
  }
}

/// No digital straight segment goes on where the contour turns twice to the same side, or turns between two
/// runs of two steps or more; and two that meet at more than 45 degrees have such a place between them.
void CornerPlacer::find_candidates() {
  candidates_.clear();
  for (int k = 0; k < runs_->count(); ++k) {
    const Run& run = (*runs_)[k];
    if (run.turns_back()) {
      add_candidates_between_turns(k);
    } else if (run.turn_out != 0 && run.length > 1) {
      const Run& next = *runs_->neighbour(k, 1);
      if (next.length > 1 && next.turn_out != run.turn_out) add_candidate(k, run.length);
    }
  }
  std::sort(candidates_.begin(), candidates_.end(),
            [](const Candidate& a, const Candidate& b) { return a.node < b.node; });
  candidates_.erase(std::unique(candidates_.begin(), candidates_.end(),
                                [](const Candidate& a, const Candidate& b) { return a.node == b.node; }),
                    candidates_.end());
}

/// Nodes near one of the turns.
void CornerPlacer::add_candidates_between_turns(int run) {
  const int length = (*runs_)[run].length;
  for (int j = 0; j <= length; ++j) {
    if (std::min(j, length - j) <= kFromTurn) add_candidate(run, j);
  }
}

void CornerPlacer::add_candidate(int run, int offset) {
  const int node = wrapped((*runs_)[run].start + offset);
  if (batch_->role[member_.first + node] == NodeRole::sharp) return;
  if (words_[node].is_text() || words_[wrapped(node - 1)].is_text()) return;
  if (!has_room(run, offset, -1) || !has_room(run, (*runs_)[run].length - offset, 1)) return;
  candidates_.push_back({node, run, offset});
}

/// Whether an arm with some steps in a run may have kShortestArm of them in all: before the arc turns twice
/// to the same side, or ends.
bool CornerPlacer::has_room(int run, int steps, int direction) const {
  const Run* at = &(*runs_)[run];
  int turn = 0;
  while (steps < kShortestArm) {
    const int next_turn = direction > 0 ? at->turn_out : at->turn_in;
    if (next_turn == 0 || (steps > 0 && next_turn == turn)) return false;
    turn = steps > 0 ? next_turn : 0;
    run = runs_->index(run, direction);
    at = &(*runs_)[run];
    steps += at->length;
  }
  return true;
}

/// The step that leaves a node in the arc's direction (1) or against it (-1).
Direction CornerPlacer::step_from(int node, int direction) const {
  return direction > 0 ? words_[node].heading() : opposite(words_[wrapped(node - 1)].heading());
}

/// The longest digital straight segment from a node on. One that has been level so far is the side of a bar,
/// and does not go round its end.
DigitalLine CornerPlacer::arm(const Candidate& candidate, int direction) const {
  const int longest = member_.closed ? std::min(kLongestArm, member_.count / 2) : kLongestArm;
  int run = candidate.run;
  int steps = direction > 0 ? (*runs_)[run].length - candidate.offset : candidate.offset;
  if (steps == 0) {
    run = runs_->index(run, direction);
    steps = (*runs_)[run].length;
  }
  const auto heading = [&] {
    return direction > 0 ? (*runs_)[run].heading : opposite((*runs_)[run].heading);
  };
  DigitalLine line(heading(), std::min(steps, longest));
  while (line.steps() < longest) {
    const bool is_level = line.steps() == steps;
    run = runs_->index(run, direction);
    if (run < 0 || (is_level && (*runs_)[run].turns_back())) break;
    for (int k = std::min((*runs_)[run].length, longest - line.steps()); k > 0; --k) {
      if (!line.grow(heading())) return line;
    }
  }
  return line;
}

void CornerPlacer::find_corners() {
  corners_.clear();
  for (const Candidate& candidate : candidates_) {
    const DigitalLine before = arm(candidate, -1);
    if (static_cast<float>(squared_length(before)) < kHeight * kHeight) continue;
    const DigitalLine after = arm(candidate, 1);
    const float cosine = cosine_between(before, after);
    if (!stands_out(before, after, cosine)) continue;
    const std::optional<glm::vec2> meeting = meeting_point(before, after);
    if (!meeting || std::max(meeting->x * meeting->x, meeting->y * meeting->y) > squared_stray(cosine))
      continue;
    corners_.push_back({candidate.node, before, after, *meeting});
  }
  if (corners_.empty()) return;
  distances_.assign(member_.count, kFar);
  for (const Corner& c : corners_) {
    distances_[c.node] = c.meeting.x * c.meeting.x + c.meeting.y * c.meeting.y;
  }
  std::erase_if(corners_, [&](const Corner& c) { return !is_tip(c.node); });
}

float CornerPlacer::distance(int node) const {
  if (member_.closed) return distances_[wrapped(node)];
  return node < 0 || node >= member_.count ? kFar : distances_[node];
}

/// Whether a node lies between two that are equally near to where their arms meet: the contour is symmetric.
bool CornerPlacer::is_middle(int node) const {
  return distance(node) != kFar && distance(node - 1) != kFar && distance(node - 1) == distance(node + 1);
}

/// Whether a node is that of its corner: in the middle, or the nearest to where its arms meet. A tip one step
/// wide has two.
bool CornerPlacer::is_tip(int node) const {
  if (is_middle(node)) return true;
  for (int j = 1; j <= kSameCorner; ++j) {
    for (const int other : {node - j, node + j}) {
      const bool is_nearer = distance(other) < distance(node) || (j > 1 && distance(other) == distance(node));
      if (is_nearer || is_middle(other)) return false;
    }
  }
  return true;
}

void CornerPlacer::straighten_arms() {
  pulls_.assign(member_.count, {});
  const int count = static_cast<int>(corners_.size());
  const auto steps_between = [&](int from, int to) {
    if (from < to) return to - from;
    return member_.closed ? to - from + member_.count : member_.count;
  };
  for (int k = 0; k < count; ++k) {
    const Corner& corner = corners_[k];
    const int previous = corners_[k == 0 ? count - 1 : k - 1].node;
    const int next = corners_[k + 1 == count ? 0 : k + 1].node;
    pull_to(corner.before, corner.node, -1, steps_between(previous, corner.node) - 1);
    pull_to(corner.after, corner.node, 1, steps_between(corner.node, next) - 1);
    const int i = member_.first + corner.node;
    batch_->set_role(i, NodeRole::sharp);
    batch_->x[i] = corner.meeting.x;
    batch_->y[i] = corner.meeting.y;
  }
  apply_pulls();
}

/// Pulls the nodes of a corner's arm, up to `last` steps away, towards the arm's line. So no more than two
/// lines pull at a node: their sum does not depend on their order.
void CornerPlacer::pull_to(const DigitalLine& line, int node, int direction, int last) {
  const glm::ivec2 along = line.direction();
  const auto x = static_cast<float>(along.x), y = static_cast<float>(along.y);
  const auto length2 = static_cast<float>(dot(along, along));
  const auto steps = static_cast<float>(line.steps());
  glm::ivec2 offset{0};
  for (int k = 1; k <= std::min(line.steps(), last); ++k) {
    offset += kStep[step_from(node, direction)];
    node = wrapped(node + direction);
    const int i = member_.first + node;
    const float corner_off = 0.5f * static_cast<float>(2 * cross(along, offset) - line.twice_offset());
    const float off = (corner_off + (x * batch_->rest_y[i] - y * batch_->rest_x[i])) / length2;
    const float weight = std::min(1.0f, (1.0f - static_cast<float>(k) / steps) / (1.0f - kStraightPart));
    Pull& pull = pulls_[node];
    pull.move_x += weight * (off * y);
    pull.move_y -= weight * (off * x);
    pull.weight += weight;
  }
}

void CornerPlacer::apply_pulls() {
  for (int node = 0; node < member_.count; ++node) {
    const Pull& pull = pulls_[node];
    const int i = member_.first + node;
    if (pull.weight == 0 || batch_->role[i] != NodeRole::free) continue;
    const float to_x = batch_->rest_x[i] + pull.move_x / pull.weight;
    const float to_y = batch_->rest_y[i] + pull.move_y / pull.weight;
    const float part = std::min(1.0f, pull.weight);
    batch_->x[i] += part * (to_x - batch_->x[i]);
    batch_->y[i] += part * (to_y - batch_->y[i]);
    batch_->rest_x[i] += part * (to_x - batch_->rest_x[i]);
    batch_->rest_y[i] += part * (to_y - batch_->rest_y[i]);
  }
}

}  // namespace depixel
