#include "libdepixel/stages/spline_table.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace depixel {
namespace {

constexpr std::uint64_t kMultiplier = 0x9e3779b97f4a7c15;

std::uint32_t hash_of(std::span<const ShapeWord> words, ArcKind kind) {
  std::uint64_t hash = words.size() << 16 | std::uint64_t{kind.rounds} << 2 | (kind.closed ? 2U : 0U) |
                       (kind.interpolated ? 1U : 0U);
  constexpr std::size_t kAtOnce = sizeof(std::uint64_t) / sizeof(ShapeWord);
  std::size_t k = 0;
  for (; k + kAtOnce <= words.size(); k += kAtOnce) {
    std::uint64_t four;
    std::memcpy(&four, words.data() + k, sizeof four);
    hash = std::rotl((hash ^ four) * kMultiplier, 29);
  }
  if (k < words.size()) {
    std::uint64_t rest = 0;
    std::memcpy(&rest, words.data() + k, (words.size() - k) * sizeof(ShapeWord));
    hash = std::rotl((hash ^ rest) * kMultiplier, 29);
  }
  return static_cast<std::uint32_t>((hash * kMultiplier) >> 32);
}

/// Shapes are handed to threads in parts of about this many.
constexpr int kShapesAtOnce = 64;

}  // namespace

void SplineTable::Index::clear() {
  constexpr std::size_t kFewest = 1024;
  entries_.assign(std::max(kFewest, entries_.size()), {0, -1});
  used_ = 0;
}

void SplineTable::Index::grow() {
  std::vector<Entry> old(2 * entries_.size(), {0, -1});
  old.swap(entries_);
  const std::size_t mask = entries_.size() - 1;
  for (const Entry& entry : old) {
    if (entry.number < 0) continue;
    std::size_t at = entry.hash & mask;
    while (entries_[at].number >= 0) at = (at + 1) & mask;
    entries_[at] = entry;
  }
}

template <typename IsSame>
int SplineTable::Index::find_or_add(std::uint32_t hash, int number, IsSame is_same) {
  const std::size_t mask = entries_.size() - 1;
  std::size_t at = hash & mask;
  for (; entries_[at].number >= 0; at = (at + 1) & mask) {
    if (entries_[at].hash == hash && is_same(entries_[at].number)) return entries_[at].number;
  }
  entries_[at] = {hash, number};
  if (2 * ++used_ > entries_.size()) grow();
  return number;
}

void SplineTable::clear() {
  words_.clear();
  shapes_.clear();
  fitted_shapes_ = 0;
  shape_index_.clear();
  joined_index_.clear();
  curves_.assign(1, {});
  tiles_.assign(1, 0);
  fitted_.assign(1, 0);
}

int SplineTable::add_curves(int count) {
  const int first = static_cast<int>(curves_.size());
  curves_.resize(curves_.size() + count);
  tiles_.resize(curves_.size());
  fitted_.resize(curves_.size());
  return first;
}

int SplineTable::curves_of(std::span<const ShapeWord> words, ArcKind kind) {
  const auto next = static_cast<int>(shapes_.size());
  const int shape = shape_index_.find_or_add(hash_of(words, kind), next, [&](int number) {
    const Shape& known = shapes_[number];
    return known.count == static_cast<int>(words.size()) && known.kind == kind &&
           std::memcmp(words_.data() + known.first_word, words.data(), words.size_bytes()) == 0;
  });
  if (shape == next) {
    Shape added{static_cast<int>(words_.size()), static_cast<int>(words.size()), kind, 0};
    added.first_curve = add_curves(added.step_count());
    words_.insert(words_.end(), words.begin(), words.end());
    shapes_.push_back(added);
  }
  return shapes_[shape].first_curve;
}

int SplineTable::fit_added(Smoothing smoothing, Workers& workers) {
  added_.clear();
  for (std::size_t i = fitted_shapes_; i < shapes_.size(); ++i) {
    const Shape& shape = shapes_[i];
    added_.push_back({std::span(words_).subspan(shape.first_word, shape.count), shape.kind,
                      curves_.data() + shape.first_curve});
  }
  const auto count = static_cast<int>(added_.size());
  if (count == 0) return 0;
  fitters_.resize(std::max<std::size_t>(fitters_.size(), workers.threads()));
  const int parts = (count + kShapesAtOnce - 1) / kShapesAtOnce;
  // One thread takes all in one go: batches are fuller.
  if (workers.threads() == 1) {
    fitters_[0].fit(added_, smoothing);
  } else {
    workers.run(parts, [&](int part, int thread) {
      const int first = part * kShapesAtOnce;
      fitters_[thread].fit(std::span(added_).subspan(first, std::min(kShapesAtOnce, count - first)),
                           smoothing);
    });
  }
  for (std::size_t i = fitted_shapes_; i < shapes_.size(); ++i) {
    const int first = shapes_[i].first_curve;
    for (int number = first; number < first + shapes_[i].step_count(); ++number) {
      tiles_[number] = touched_tiles(curves_[number]);
      fitted_[number] = number;
    }
  }
  fitted_shapes_ = shapes_.size();
  return count;
}

int SplineTable::joined(int fitted, bool southwards, glm::i16vec2 p0, glm::i16vec2 p3) {
  const EdgeCurve base = curves_[fitted];
  if (base.p0 == p0 && base.p3 == p3) return fitted;
  const std::array<std::int16_t, 4> ends{p0.x, p0.y, p3.x, p3.y};
  std::uint64_t hash;
  static_assert(sizeof hash == sizeof ends);
  std::memcpy(&hash, ends.data(), sizeof hash);
  hash = (std::rotl(hash * kMultiplier, 29) ^ static_cast<std::uint64_t>(fitted)) * kMultiplier;
  const auto next = static_cast<int>(curves_.size());
  // An edge's curve is fitted for its direction, so that the direction need not be compared.
  const int number = joined_index_.find_or_add(static_cast<std::uint32_t>(hash >> 32), next, [&](int known) {
    return fitted_[known] == fitted && curves_[known].p0 == p0 && curves_[known].p3 == p3;
  });
  if (number == next) {
    curves_.push_back(join(base, southwards, p0, p3));
    tiles_.push_back(touched_tiles(curves_.back()));
    fitted_.push_back(fitted);
  }
  return number;
}

std::size_t SplineTable::memory_bytes() const {
  std::size_t bytes = held_bytes(words_, shapes_, curves_, tiles_, fitted_, added_, fitters_);
  for (const SplineFitter& fitter : fitters_) bytes += fitter.memory_bytes();
  return bytes + shape_index_.memory_bytes() + joined_index_.memory_bytes();
}

}  // namespace depixel
