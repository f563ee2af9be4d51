#include "libdepixel/stages/digital_line.hpp"

namespace depixel {

bool DigitalLine::grow(Direction step) {
  if (steps() == 0) first_ = step;
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
