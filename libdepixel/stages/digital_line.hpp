#pragma once

#include <glm/vec2.hpp>

#include "libdepixel/core/lattice.hpp"

namespace depixel {

/// A digital straight segment: a chain of lattice steps that a straight line may have left, grown step by
/// step from its first node, the origin. All of its nodes p have cross(direction, p) within a range as wide
/// as the direction's steps, |x| + |y|. Cost: constant a step, integers only. Source: Debled-Rennesson and
/// Reveilles, "A linear algorithm for segmentation of digital curves" (1995).
class DigitalLine {
 public:
  /// A number of equal steps.
  DigitalLine(Direction step, int count) : first_(step), at_(count, 0), last_low_(at_), last_high_(at_) {}

  /// Adds a step at the end. \return whether all is still straight; if not, nothing has changed.
  bool grow(Direction step);

  int steps() const { return at_.x + at_.y; }
  /// The last node.
  glm::ivec2 end() const { return in_picture(at_); }
  /// Of the line in the middle of those that the chain may stem from: in least whole numbers, away from the
  /// origin.
  glm::ivec2 direction() const { return in_picture(slope_); }
  /// Twice the cross product x_d * y_p - y_d * x_p of its direction with the points of that line.
  int twice_offset() const { return -side_ * (2 * lowest_ + slope_.x + slope_.y - 1); }

 private:
  // Points and slopes are counted in steps of the first kind (x) and of the second (y). The remainder of a
  // point is slope_.y * x - slope_.x * y; those of all nodes are lowest_ .. lowest_ + slope_.x + slope_.y -
  // 1, and nodes that have the least or the greatest one lean on the bounds.
  int remainder(glm::ivec2 p) const { return slope_.y * p.x - slope_.x * p.y; }
  glm::ivec2 in_picture(glm::ivec2 p) const { return p.x * kStep[first_] + p.y * kStep[second_]; }

  Direction first_, second_ = kEast;
  int side_ = 0;  ///< of the second kind of step: 1 to the right of the first, -1 to the left, 0: none yet
  glm::ivec2 at_, slope_{1, 0};
  int lowest_ = 0;
  glm::ivec2 first_low_{0}, last_low_, first_high_{0}, last_high_;  ///< nodes that lean on the bounds
};

inline bool DigitalLine::grow(Direction step) {
  const bool is_first = step == first_;
  if (!is_first && side_ == 0 && step != opposite(first_)) {
    second_ = step;
    side_ = step == turned(first_, 1) ? 1 : -1;
  }
  if (!is_first && (side_ == 0 || step != second_)) return false;
  const glm::ivec2 next = at_ + (is_first ? glm::ivec2(1, 0) : glm::ivec2(0, 1));
  const int over = remainder(next) - lowest_, width = slope_.x + slope_.y;
  if (over < -1 || over > width) return false;
  at_ = next;
  if (over == -1) {  // just below: the line turns about the first node that leans on the lower bound
    last_low_ = next;
    first_high_ = last_high_;
    slope_ = next - first_low_;
    lowest_ = remainder(next);
  } else if (over == width) {
    last_high_ = next;
    first_low_ = last_low_;
    slope_ = next - first_high_;
    lowest_ = remainder(next) - (slope_.x + slope_.y - 1);
  } else {
    if (over == 0) last_low_ = next;
    if (over == width - 1) last_high_ = next;
  }
  return true;
}

}  // namespace depixel
