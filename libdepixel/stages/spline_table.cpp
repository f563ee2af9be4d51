#include "libdepixel/stages/spline_table.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstring>
#include <limits>
#include <numeric>

#include "libdepixel/core/simd.hpp"

namespace depixel {
namespace {

constexpr std::uint64_t kMultiplier = 0x9e3779b97f4a7c15, kIsHash = std::uint64_t{1} << 63;

/// What a shape is looked up by. Of up to four nodes, all of it; else a hash, with the uppermost bit set.
std::uint64_t key_of(std::span<const ShapeWord> words, ArcKind kind) {
  static_assert(ShapeWord::kBits == 12);
  const std::uint64_t kind_bits =
      std::uint64_t{kind.rounds} << 2 | (kind.closed ? 2U : 0U) | (kind.interpolated ? 1U : 0U);
  constexpr std::size_t kAtOnce = sizeof(std::uint64_t) / sizeof(ShapeWord);
  if (words.size() <= kAtOnce) {
    std::uint64_t key = words.size() << 6 | kind_bits;
    for (const ShapeWord word : words) key = key << ShapeWord::kBits | word.bits();
    return key;
  }
  std::uint64_t hash = words.size() << 16 | kind_bits;
  std::size_t k = 0;
  for (; k + kAtOnce <= words.size(); k += kAtOnce) {
    hash = std::rotl((hash ^ load_vector<std::uint64_t>(words.data() + k)) * kMultiplier, 29);
  }
  if (k < words.size()) {  // the last four once more: some of them are new
    hash = std::rotl((hash ^ load_vector<std::uint64_t>(words.data() + words.size() - kAtOnce)) * kMultiplier,
                     29);
  }
  return hash | kIsHash;
}

std::uint64_t key_of(const EdgeCurve& curve) {
  const auto halves = std::bit_cast<std::array<std::uint64_t, 2>>(curve);
  return std::rotl(halves[0] * kMultiplier, 29) ^ halves[1];
}

/// Curves whose entries are fetched before they are looked up.
constexpr std::size_t kAhead = 8;

/// Shapes are handed to threads in parts of about this many.
constexpr int kShapesAtOnce = 64;

}  // namespace

template <typename Key>
void SplineTable::Index<Key>::clear() {
  constexpr std::size_t kFewest = 1024;
  entries_.assign(std::max(kFewest, entries_.size()), {{}, -1});
  shift_ = 64 - std::countr_zero(entries_.size());
  used_ = 0;
}

template <typename Key>
std::size_t SplineTable::Index<Key>::place_of(Key key) const {
  return key * kMultiplier >> shift_;
}

template <typename Key>
void SplineTable::Index<Key>::prefetch(Key key) const {
  __builtin_prefetch(entries_.data() + place_of(key));
}

template <typename Key>
void SplineTable::Index<Key>::grow() {
  std::vector<Entry> old(2 * entries_.size(), {{}, -1});
  old.swap(entries_);
  --shift_;
  const std::size_t mask = entries_.size() - 1;
  for (const Entry& entry : old) {
    if (entry.number < 0) continue;
    std::size_t at = place_of(std::bit_cast<Key>(entry.key));
    while (entries_[at].number >= 0) at = (at + 1) & mask;
    entries_[at] = entry;
  }
}

template <typename Key>
template <typename IsSame>
int SplineTable::Index<Key>::find_or_add(Key key, int number, IsSame is_same) {
  const std::size_t mask = entries_.size() - 1;
  std::size_t at = place_of(key);
  for (; entries_[at].number >= 0; at = (at + 1) & mask) {
    // As one number: arrays would be compared by a call.
    if (std::bit_cast<Key>(entries_[at].key) == key && is_same(entries_[at].number))
      return entries_[at].number;
  }
  using Halves = decltype(Entry::key);
  entries_[at] = {std::bit_cast<Halves>(key), number};
  if (3 * ++used_ > 2 * entries_.size()) grow();
  return number;
}

void SplineTable::clear() {
  static std::atomic<std::uint64_t> generations = 0;
  generation_ = ++generations;
  words_.clear();
  shapes_.clear();
  numbers_.clear();
  fitted_shapes_ = 0;
  shape_index_.clear();
  curve_index_.clear();
  joined_index_.clear();
  first_joined_ = std::numeric_limits<int>::max();
  curves_.assign(1, {});
  tiles_.assign(1, 0);
  fitted_.assign(1, 0);
}

void SplineTable::reserve(std::size_t steps) {
  words_.reserve(steps);
  numbers_.reserve(steps);
}

int SplineTable::place_of(std::span<const ShapeWord> words, ArcKind kind) {
  const auto next = static_cast<int>(shapes_.size());
  const std::uint64_t key = key_of(words, kind);
  const int shape = shape_index_.find_or_add(key, next, [&](int number) {
    if ((key & kIsHash) == 0) return true;
    const Shape& known = shapes_[number];
    return known.count == static_cast<int>(words.size()) && known.kind == kind &&
           std::memcmp(words_.data() + known.first_word, words.data(), words.size_bytes()) == 0;
  });
  if (shape == next) {
    const Shape added{static_cast<int>(words_.size()), static_cast<int>(words.size()), kind,
                      static_cast<int>(numbers_.size())};
    numbers_.resize(numbers_.size() + added.step_count());
    words_.insert(words_.end(), words.begin(), words.end());
    shapes_.push_back(added);
  }
  return shapes_[shape].first_place;
}

int SplineTable::fit_added(const Options& options, Workers& workers) {
  const auto count = static_cast<int>(shapes_.size() - fitted_shapes_);
  if (count == 0) return 0;
  const auto first_place = static_cast<std::size_t>(shapes_[fitted_shapes_].first_place);
  const std::size_t steps = numbers_.size() - first_place;
  const std::size_t first_number = curves_.size();
  curves_.resize(first_number + steps);
  tiles_.resize(curves_.size());
  added_.clear();
  for (std::size_t i = fitted_shapes_; i < shapes_.size(); ++i) {
    const Shape& shape = shapes_[i];
    const std::size_t first = first_number + shape.first_place - first_place;
    added_.push_back({std::span(words_).subspan(shape.first_word, shape.count), shape.kind,
                      curves_.data() + first, tiles_.data() + first});
  }
  fitters_.resize(std::max<std::size_t>(fitters_.size(), workers.threads()));
  const int parts = (count + kShapesAtOnce - 1) / kShapesAtOnce;
  // One thread takes all in one go: batches are fuller.
  if (workers.threads() == 1) {
    fitters_[0].fit(added_, options);
  } else {
    workers.run(parts, [&](int part, int thread) {
      const int first = part * kShapesAtOnce;
      fitters_[thread].fit(std::span(added_).subspan(first, std::min(kShapesAtOnce, count - first)), options);
    });
  }
  if (has_equal_numbers_) {
    number_equally(first_place, first_number);
  } else {
    std::iota(numbers_.begin() + static_cast<std::ptrdiff_t>(first_place), numbers_.end(),
              static_cast<int>(first_number));
  }
  for (std::size_t number = first_number; number < curves_.size(); ++number)
    fitted_.push_back(static_cast<int>(number));
  fitted_shapes_ = shapes_.size();
  return count;
}

/// Gives fitted curves, one a place from a first one on, their numbers; of those that are known, the known
/// ones, and the others close up.
void SplineTable::number_equally(std::size_t first_place, std::size_t first_number) {
  std::size_t next = first_number;
  for (std::size_t k = first_number; k < curves_.size(); ++k) {
    if (k + kAhead < curves_.size()) curve_index_.prefetch(key_of(curves_[k + kAhead]));
    const EdgeCurve curve = curves_[k];
    const int number = curve_index_.find_or_add(key_of(curve), static_cast<int>(next),
                                                [&](int known) { return curves_[known] == curve; });
    numbers_[first_place + k - first_number] = number;
    if (number != static_cast<int>(next)) continue;
    curves_[next] = curve;
    tiles_[next++] = tiles_[k];
  }
  curves_.resize(next);
  tiles_.resize(next);
}

int SplineTable::joined(int fitted, bool southwards, glm::i16vec2 p0, glm::i16vec2 p3) {
  const EdgeCurve base = curves_[fitted];
  if (base.p0 == p0 && base.p3 == p3) return fitted;
  const std::array<std::int16_t, 4> ends{p0.x, p0.y, p3.x, p3.y};
  const auto key = static_cast<std::uint32_t>(
      (load_vector<std::uint64_t>(ends.data()) * kMultiplier + static_cast<std::uint64_t>(fitted)) *
          kMultiplier >>
      32);
  const auto next = static_cast<int>(curves_.size());
  // An edge's curve is fitted for its direction, so that the direction need not be compared.
  const int number = joined_index_.find_or_add(key, next, [&](int known) {
    return fitted_[known] == fitted && curves_[known].p0 == p0 && curves_[known].p3 == p3;
  });
  if (number == next) {
    first_joined_ = std::min(first_joined_, number);
    curves_.push_back(join(base, southwards, p0, p3));
    tiles_.push_back(touched_tiles(curves_.back()));
    fitted_.push_back(fitted);
  }
  return number;
}

std::size_t SplineTable::memory_bytes() const {
  std::size_t bytes = held_bytes(words_, shapes_, numbers_, curves_, tiles_, fitted_, added_, fitters_);
  for (const SplineFitter& fitter : fitters_) bytes += fitter.memory_bytes();
  return bytes + shape_index_.memory_bytes() + curve_index_.memory_bytes() + joined_index_.memory_bytes();
}

}  // namespace depixel
