#include "libdepixel/stages/edge_curve.hpp"

#include <algorithm>

namespace depixel {
namespace {

struct Box {
  glm::ivec2 low, high;

  explicit Box(const EdgeCurve& c)
      : low(std::min({c.p0.x, c.p1.x, c.p2.x, c.p3.x}), std::min({c.p0.y, c.p1.y, c.p2.y, c.p3.y})),
        high(std::max({c.p0.x, c.p1.x, c.p2.x, c.p3.x}), std::max({c.p0.y, c.p1.y, c.p2.y, c.p3.y})) {}
};

}  // namespace

TileMask touched_tiles(const EdgeCurve& curve) {
  constexpr int kShift = 12;
  static_assert(kSubpixels == 1 << kShift);
  const Box box(curve);
  TileMask mask = 0;
  // A curve along the side of two tiles touches both.
  for (int y = (box.low.y - 1) >> kShift; y <= box.high.y >> kShift; ++y) {
    for (int x = (box.low.x - 1) >> kShift; x <= box.high.x >> kShift; ++x) {
      mask |= static_cast<TileMask>(1 << (3 * (y + 1) + x + 1));
    }
  }
  return mask;
}

bool stays_near_edge(const EdgeCurve& curve, bool southwards) {
  const Box box(curve);
  const glm::ivec2 length(southwards ? 0 : kSubpixels, southwards ? kSubpixels : 0);
  return box.low.x > -kSubpixels && box.low.y > -kSubpixels && box.high.x < length.x + kSubpixels &&
         box.high.y < length.y + kSubpixels;
}

}  // namespace depixel
