#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "libdepixel/core/lattice.hpp"
#include "libdepixel/core/memory.hpp"

namespace depixel {

/// A part of a row: from .. to - 1; empty where both are equal.
struct Span {
  int from = 0, to = 0;

  bool is_empty() const { return from == to; }
  int length() const { return to - from; }
};

/// The shortest span that holds some spans.
inline Span united(const std::array<Span, 3>& spans) {
  Span whole;
  for (const Span span : spans) {
    if (span.is_empty()) continue;
    whole = whole.is_empty() ? span : Span{std::min(whole.from, span.from), std::max(whole.to, span.to)};
  }
  return whole;
}

/// Which part of each row of a picture changed.
class RowSpans {
 public:
  void reset(int rows) { spans_.assign(rows, Span{}); }
  void set(int row, Span span) { spans_[row] = span; }
  const Span& operator[](int row) const { return spans_[row]; }
  /// True also for rows outside the picture, which never change.
  bool is_empty(int row) const {
    return row < 0 || row >= static_cast<int>(spans_.size()) || spans_[row].is_empty();
  }
  bool any() const {
    return std::any_of(spans_.begin(), spans_.end(), [](Span span) { return !span.is_empty(); });
  }
  /// Those of a row and of its neighbours; rows outside the picture are empty.
  std::array<Span, 3> around(int row) const { return {at(row - 1), at(row), at(row + 1)}; }
  Span at(int row) const { return is_empty(row) ? Span{} : spans_[row]; }
  int rows() const { return static_cast<int>(spans_.size()); }
  std::size_t memory_bytes() const { return held_bytes(spans_); }

 private:
  std::vector<Span> spans_;
};

/// Where two rows of `count` values differ first and last.
template <typename Value>
Span differing_part(const Value* a, const Value* b, int count) {
  constexpr int kAtOnce = static_cast<int>(16 / sizeof(Value));
  int from = 0;
  while (from + kAtOnce <= count && std::equal(a + from, a + from + kAtOnce, b + from)) from += kAtOnce;
  while (from < count && a[from] == b[from]) ++from;
  if (from == count) return {};
  int to = count;
  while (to - kAtOnce >= from && std::equal(a + to - kAtOnce, a + to, b + to - kAtOnce)) to -= kAtOnce;
  while (a[to - 1] == b[to - 1]) --to;
  return {from, to};
}

}  // namespace depixel
