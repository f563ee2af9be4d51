#include "libdepixel/stages/corners.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace depixel {
namespace {

float env(const char* n, float d) { const char* s = std::getenv(n); return s ? std::atof(s) : d; }
const float kHeight = env("CH", 5.0f);
const int kLongestArm = env("CA", 20);
const int kCapNodes = 3;
const int kSuppress = env("CS", 3);
const float kStray = env("CP", 0.75f);
const float kFull = env("CF", 0.5f);

int cross(glm::ivec2 a, glm::ivec2 b) { return a.x * b.y - a.y * b.x; }
int dot(glm::ivec2 a, glm::ivec2 b) { return a.x * b.x + a.y * b.y; }

/// The square of how far the corner between two arms stands out.
float height2(const DigitalLine& a, const DigitalLine& b) {
  const glm::ivec2 u = a.direction(), v = b.direction(), p = a.end(), q = b.end();
  const float cosine = static_cast<float>(dot(u, v)) /
                       std::sqrt(static_cast<float>(dot(u, u)) * static_cast<float>(dot(v, v)));
  return static_cast<float>(std::min(dot(p, p), dot(q, q))) * (0.5f * (1.0f + cosine));
}

std::optional<glm::vec2> meeting_point(const DigitalLine& a, const DigitalLine& b) {
  const glm::ivec2 u = a.direction(), v = b.direction();
  const int area = cross(u, v);
  if (area == 0) return std::nullopt;
  const glm::ivec2 p = v * a.twice_offset() - u * b.twice_offset();
  const float twice_area = static_cast<float>(2 * area);
  return glm::vec2(static_cast<float>(p.x) / twice_area, static_cast<float>(p.y) / twice_area);
}

}  // namespace

void CornerPlacer::place(std::span<const ShapeWord> words, const Runs& runs, const ArcBatch::Member& member,
                         ArcBatch& batch) {
  words_ = words;
  batch_ = &batch;
  member_ = member;
  heights_.assign(member.count, 0.0f);
  candidates_.clear();
  find_candidates(runs);
  if (candidates_.empty()) return;
  for (const int node : candidates_) heights_[node] = height2(arm(node, -1), arm(node, 1));
  find_corners();
  if (!corners_.empty()) straighten_arms();
}

void CornerPlacer::add_candidate(int node) {
  node = wrapped(node);
  if (batch_->role[member_.first + node] != NodeRole::free || heights_[node] < 0) return;
  heights_[node] = -1;
  candidates_.push_back(node);
}

void CornerPlacer::find_candidates(const Runs& runs) {
  for (int k = 0; k < runs.count(); ++k) {
    const Run& run = runs[k];
    const Run* next = runs.neighbour(k, 1);
    if (run.turn_in == run.turn_out && run.turn_in != 0) {
      for (int j = 0; j <= run.length; ++j) {
        if (std::min(j, run.length - j) <= kCapNodes) add_candidate(run.start + j);
      }
    } else if (run.turn_out != 0 && run.length > 1 && next->length > 1) {
      add_candidate(next->start);
    }
  }
}

DigitalLine CornerPlacer::arm(int node, int direction) const {
  DigitalLine line;
  const int longest = member_.closed ? std::min(kLongestArm, member_.count / 2)
                                     : std::min(kLongestArm, direction > 0 ? member_.count - 1 - node : node);
  for (int k = 0; k < longest; ++k) {
    const Direction step = direction > 0 ? words_[wrapped(node + k)].heading()
                                         : opposite(words_[wrapped(node - k - 1)].heading());
    if (!line.grow(step)) break;
  }
  return line;
}

void CornerPlacer::find_corners() {
  corners_.clear();
  std::sort(candidates_.begin(), candidates_.end());
  for (const int node : candidates_) {
    const float height = heights_[node];
    if (height < kHeight * kHeight) continue;
    bool is_highest = true;
    for (int j = -kSuppress; j <= kSuppress; ++j) {
      const int other = member_.closed ? wrapped(node + j) : std::clamp(node + j, 0, member_.count - 1);
      is_highest &= heights_[other] <= height;
    }
    if (!is_highest) continue;
    const Corner corner{node, arm(node, -1), arm(node, 1)};
    const auto at = meeting_point(corner.before, corner.after);
    if (!at || std::max(std::fabs(at->x), std::fabs(at->y)) > kStray) continue;
    const int i = member_.first + node;
    batch_->set_role(i, NodeRole::sharp);
    batch_->x[i] = at->x;
    batch_->y[i] = at->y;
    corners_.push_back(corner);
  }
}

void CornerPlacer::straighten_arms() {
  pulls_.assign(member_.count, {});
  const int count = static_cast<int>(corners_.size());
  for (int k = 0; k < count; ++k) {
    const Corner& corner = corners_[k];
    const auto distance = [&](int from, int to) {  // nodes between two corners that follow each other
      if (from < to) return to - from;
      return member_.closed ? to - from + member_.count : member_.count;
    };
    straighten(corner, corner.before, -1, distance(corners_[k == 0 ? count - 1 : k - 1].node, corner.node));
    straighten(corner, corner.after, 1, distance(corner.node, corners_[k + 1 == count ? 0 : k + 1].node));
  }
  for (int node = 0; node < member_.count; ++node) {
    const Pull& pull = pulls_[node];
    const int i = member_.first + node;
    if (pull.weight == 0 || batch_->role[i] != NodeRole::free) continue;
    const float whole = std::max(1.0f, pull.weight), part = std::min(1.0f, pull.weight);
    // towards the lines from the node of the cell graph, and by the rest of it from where it is
    const float to_x = batch_->rest_x[i] + pull.move.x / pull.weight, to_y = batch_->rest_y[i] + pull.move.y / pull.weight;
    (void)whole;
    batch_->x[i] += part * (to_x - batch_->x[i]);
    batch_->y[i] += part * (to_y - batch_->y[i]);
    batch_->rest_x[i] += part * (to_x - batch_->rest_x[i]);
    batch_->rest_y[i] += part * (to_y - batch_->rest_y[i]);
  }
}

void CornerPlacer::straighten(const Corner& corner, const DigitalLine& line, int direction, int reach) {
  const glm::ivec2 along = line.direction();
  const float length2 = static_cast<float>(dot(along, along));
  const int last = std::min(line.steps(), reach - 1);
  glm::ivec2 offset{0};
  for (int k = 1; k <= last; ++k) {
    const Direction step = direction > 0 ? words_[wrapped(corner.node + k - 1)].heading()
                                         : opposite(words_[wrapped(corner.node - k)].heading());
    offset += kStep[step];
    const int node = wrapped(corner.node + direction * k), i = member_.first + node;
    const float dx = batch_->rest_x[i], dy = batch_->rest_y[i];
    const float off = 0.5f * static_cast<float>(2 * cross(along, offset) - line.twice_offset()) +
                      (static_cast<float>(along.x) * dy - static_cast<float>(along.y) * dx);
    const float share = off / length2;
    const float t = static_cast<float>(k) / static_cast<float>(line.steps());
    const float weight = t <= kFull ? 1.0f : (1.0f - t) / (1.0f - kFull);
    Pull& pull = pulls_[node];
    pull.move.x += weight * (share * static_cast<float>(along.y));
    pull.move.y -= weight * (share * static_cast<float>(along.x));
    pull.weight += weight;
  }
}

}  // namespace depixel
