#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/stages/arc_batch.hpp"

namespace depixel {

/// A maximal sequence of equal steps of an arc.
struct Run {
  int start;   ///< node of its first step, counted from the arc's first node
  int length;  ///< steps
  Direction heading;
  int turn_in, turn_out;  ///< at its ends: 1 to the right, -1 to the left, 0 at an open end

  /// Whether the contour turns twice to the same side.
  bool turns_back() const { return turn_in == turn_out && turn_in != 0; }
};

/// The runs of an arc, in order; of a closed one, all round it.
class Runs {
 public:
  void find(std::span<const ShapeWord> words, bool is_closed);

  int count() const { return static_cast<int>(list_.size()); }
  const Run& operator[](int run) const { return list_[run]; }
  std::vector<Run>::const_iterator begin() const { return list_.begin(); }
  std::vector<Run>::const_iterator end() const { return list_.end(); }
  /// The run `offset` runs on, or nullptr beyond the end of an open arc; and its index, or -1.
  const Run* neighbour(int run, int offset) const {
    const int other = index(run, offset);
    return other < 0 ? nullptr : &list_[other];
  }
  int index(int run, int offset) const {
    const int k = run + offset;
    if (is_closed_) return ArcBatch::wrapped(k, count());
    return k < count() ? std::max(k, -1) : -1;
  }

  std::size_t memory_bytes() const { return held_bytes(list_); }

 private:
  std::vector<Run> list_;
  bool is_closed_ = false;
};

}  // namespace depixel
