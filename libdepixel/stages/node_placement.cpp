#include "libdepixel/stages/node_placement.hpp"

#include <algorithm>

#include "libdepixel/core/simd.hpp"

namespace depixel {
namespace {

/// Arms of a corner that the thesis's averaging leaves alone: the step at the corner and one more (figure
/// 57).
constexpr int kAveragedCornerArm = 2;
/// Longer stretches between steps are level but for half this length, in steps, at their ends.
constexpr float kLongestSlope = 8.0f;
/// A bulge's height above the middle of the steps at its ends, in pixels, and its bounds: a top lies about on
/// the lattice.
constexpr float kLowestBulge = 0.5f, kHighestBulge = 0.8f;
/// Nodes round a dot of two by three pixels; longer rectangles are no dots.
constexpr int kLongestDot = 10;
/// Bits of a step's thin sides.
constexpr int kLeftSide = 1, kRightSide = 2;
/// By how much each side of a one-pixel-wide line moves out so that the line is one pixel wide, by the length
/// of the line's runs n: (sqrt(1 + 1/n^2) - 1) / 2; for n = 1 along both axes, half of it each.
constexpr std::array<float, 7> kWidening{0.0f, 0.10355f, 0.05902f, 0.02705f, 0.01539f, 0.0099f, 0.00690f};

struct Vector {
  float x, y;
};
constexpr Vector unit(Direction d) {
  return {static_cast<float>(kStep[d].x), static_cast<float>(kStep[d].y)};
}

/// Where the cell graph has the node that an edge leaves from, by corner code and heading.
constexpr auto kRest = [] {
  std::array<std::array<Vector, 4>, 128> rest{};
  for (int bits = 0; bits < 128; ++bits) {
    const CornerCode code(static_cast<std::uint8_t>(bits));
    if (code.pairing() > CornerCode::kNorthWest) continue;
    for (const Direction d : kDirections) {
      const glm::ivec2 quarters = code.node_quarters(d);
      rest[bits][d] = {0.25f * static_cast<float>(quarters.x), 0.25f * static_cast<float>(quarters.y)};
    }
  }
  return rest;
}();

}  // namespace

void NodePlacer::add(std::span<const ShapeWord> words, ArcKind kind, const Options& options, int source,
                     ArcBatch& batch) {
  batch_ = &batch;
  member_ = batch.add(words, kind, source);
  place_at_rest(words);
  if (options.smoothing == Smoothing::none) return;
  runs_.find(words, kind.closed);
  if (options.smoothing == Smoothing::average) {
    hold_corners();
    return;
  }
  hold_text(words);
  const bool has_thin_sides =
      std::any_of(words.begin(), words.end(), [](ShapeWord w) { return w.thin_sides() != 0; });
  if (has_thin_sides) hold_square_ends();
  hold_square_tips();
  straighten_stairs();
  if (options.corners == Corners::sharp) corners_.place(words, runs_, member_, *batch_);
  if (has_thin_sides) widen_thin_lines();
}

/// Open arcs must stay where they end; all else may move.
void NodePlacer::place_at_rest(std::span<const ShapeWord> words) {
  const int count = member_.count;
  float *x = batch_->x.data() + member_.first, *y = batch_->y.data() + member_.first;
  for (int k = 0; k < count; ++k) {
    const Vector rest = kRest[words[k].code().bits()][words[k].heading()];
    x[k] = rest.x;
    y[k] = rest.y;
    batch_->set_role(member_.first + k, NodeRole::free);
  }
  std::copy_n(x, count, batch_->rest_x.data() + member_.first);
  std::copy_n(y, count, batch_->rest_y.data() + member_.first);
  if (!member_.closed) {
    batch_->set_role(member_.first, NodeRole::sharp);
    batch_->set_role(member_.last(), NodeRole::sharp);
  }
}

void NodePlacer::hold_corners() {
  for (int k = 0; k < runs_.count(); ++k) {
    const Run& run = runs_[k];
    const Run* next = runs_.neighbour(k, 1);
    if (run.turn_out == 0 || run.length < kAveragedCornerArm || next->length < kAveragedCornerArm) continue;
    batch_->set_role(entry(next->start), NodeRole::held);
  }
}

void NodePlacer::hold_square_ends() {
  // The approximating spline stays inside its control points; one that goes through the nodes needs them
  // there.
  const float part = member_.interpolated ? 2.0f / 3.0f : 0.0f;
  for (const Run& run : runs_) {
    if (run.length != 1 || !run.turns_back()) continue;
    const int inner_side = run.turn_in > 0 ? kRightSide : kLeftSide;
    if (!(thin_sides(run) & inner_side)) continue;
    for (const int i : {entry(run.start), entry(run.start + 1)}) {
      const bool is_cut = batch_->rest_x[i] != 0.0f;
      if (batch_->role[i] != NodeRole::free || !is_cut) continue;
      batch_->set_role(i, NodeRole::held);
      batch_->x[i] = batch_->rest_x[i] *= part;
      batch_->y[i] = batch_->rest_y[i] *= part;
    }
  }
}

/// Where a shape two pixels wide ends square, the middle of its end stays where it is: a spline that shrinks
/// would halve the area of a dot. Rectangles that are longer than a dot become round, as the holes of letters
/// are.
void NodePlacer::hold_square_tips() {
  const bool is_rectangle = member_.closed && runs_.count() == 4;
  if (is_rectangle && member_.count > kLongestDot) return;
  for (int k = 0; k < runs_.count(); ++k) {
    const Run& run = runs_[k];
    if (run.length != 2 || !run.turns_back()) continue;
    if (runs_.neighbour(k, -1)->length < 2 || runs_.neighbour(k, 1)->length < 2) continue;
    const int i = entry(run.start + 1);
    if (batch_->role[i] == NodeRole::free) batch_->set_role(i, NodeRole::held);
  }
}

void NodePlacer::straighten_stairs() {
  for (int k = 0; k < runs_.count(); ++k) {
    if (runs_[k].length >= 2) straighten_stair(k);
  }
}

/// Where a run of two or more steps is joined to the next of its kind by a single step, the line wanted goes
/// through the middle of that step, half a pixel off the run: to the left (positive) or right of it.
void NodePlacer::straighten_stair(int index) {
  const Run& run = runs_[index];
  const auto level_beyond = [&](int direction) -> const Run* {
    const Run* step = runs_.neighbour(index, direction);
    const Run* beyond = runs_.neighbour(index, 2 * direction);
    const bool joined = step != nullptr && step->length == 1 && step->heading != run.heading &&
                        beyond != nullptr && beyond->heading == run.heading;
    return joined ? beyond : nullptr;
  };
  const Run *before = level_beyond(-1), *after = level_beyond(1);
  if (before == nullptr && after == nullptr) return;

  const auto length = static_cast<float>(run.length);
  const float offset_in = run.turn_in > 0 ? -0.5f : 0.5f, offset_out = run.turn_out > 0 ? -0.5f : 0.5f;
  const auto offset_at = [&](float s) {
    if (before != nullptr && after != nullptr && offset_in == offset_out) {
      const auto a = static_cast<float>(std::min(before->length, after->length));
      const float bulge =
          std::clamp(length * length / (4 * (length * a + a * a)), kLowestBulge, kHighestBulge);
      const float reach = std::min(length, kLongestSlope);
      const float m = std::min(std::min(s, length - s), reach / 2);
      return offset_in + (offset_in < 0 ? bulge : -bulge) * (4 * m * (reach - m) / (reach * reach));
    }
    const auto fading = [&](const Run* level, float offset, float distance) {
      if (level == nullptr) return 0.0f;
      const float half = std::min(std::min(length, kLongestSlope), static_cast<float>(level->length)) / 2;
      return distance < half ? offset * (1 - distance / half) : 0.0f;
    };
    return fading(before, offset_in, s) + fading(after, offset_out, length - s);
  };

  const Vector along = unit(run.heading), left = unit(turned(run.heading, 3));
  const int from = before != nullptr ? 0 : 1, to = after != nullptr ? run.length : run.length - 1;
  for (int j = from; j <= to; ++j) {
    const int i = entry(run.start + j);
    if (batch_->role[i] != NodeRole::free) continue;
    float &x = batch_->x[i], &y = batch_->y[i];
    const float s = static_cast<float>(j) + (batch_->rest_x[i] * along.x + batch_->rest_y[i] * along.y);
    const float move = offset_at(std::clamp(s, 0.0f, length)) - (x * left.x + y * left.y);
    x += left.x * move;
    y += left.y * move;
  }
}

/// The sides on which the steps of a run have a pixel of a thin line; 0 where they are not of one kind.
int NodePlacer::thin_sides(const Run& run) const {
  const auto sides_at = [&](int node) { return batch_->word[entry(node)].thin_sides(); };
  const int sides = sides_at(run.start);
  for (int j = 1; j < run.length; ++j) {
    if (sides_at(run.start + j) != sides) return 0;
  }
  return sides;
}

void NodePlacer::widen_thin_lines() {
  for (int k = 0; k < runs_.count(); ++k) {
    const Run& run = runs_[k];
    if (run.length >= static_cast<int>(kWidening.size())) continue;
    const int sides = thin_sides(run);
    for (const int side : {kLeftSide, kRightSide}) {
      if (sides != side) continue;
      // A single step belongs to the longer runs that it joins, if there are such.
      const auto is_longer = [](const Run* other) { return other != nullptr && other->length > 1; };
      const int from = run.length == 1 && is_longer(runs_.neighbour(k, -1)) ? 1 : 0;
      const int to = run.length == 1 && is_longer(runs_.neighbour(k, 1)) ? 0 : run.length;
      const Vector away = unit(turned(run.heading, side == kLeftSide ? 1 : 3));
      const float by = kWidening[run.length];
      for (int j = from; j <= to; ++j) {
        const int i = entry(run.start + j);
        if (batch_->role[i] != NodeRole::free) continue;
        batch_->x[i] += away.x * by;
        batch_->y[i] += away.y * by;
        batch_->rest_x[i] += away.x * by;
        batch_->rest_y[i] += away.y * by;
      }
    }
  }
}

/// A node is text's where the step to it or from it runs along such; or, in a contour most of which does,
/// anywhere: letters and dots are held as a whole.
void NodePlacer::hold_text(std::span<const ShapeWord> words) {
  const auto along_text = std::count_if(words.begin(), words.end(), [](ShapeWord w) { return w.is_text(); });
  if (along_text == 0) return;
  const bool is_all = member_.closed && 2 * along_text >= member_.count;
  bool is_before = is_all || (member_.closed && words.back().is_text());
  for (int k = 0; k < member_.count; ++k) {
    const bool is_after = is_all || words[k].is_text();
    const int i = member_.first + k;
    if ((is_before || is_after) && batch_->role[i] == NodeRole::free) batch_->set_role(i, NodeRole::held);
    is_before = is_after;
  }
}

}  // namespace depixel
