#include "libdepixel/stages/border.hpp"

#include <algorithm>
#include <cstring>

namespace depixel {
namespace {

/// The pixel of a row or column that stands where `at` is, which may lie beyond either end.
int source_of(int at, int count, BorderKind kind) {
  if (kind == BorderKind::repeat) return std::clamp(at, 0, count - 1);
  const int period = 2 * count;  // there and back again
  const int place = (at % period + period) % period;
  return place < count ? place : period - 1 - place;
}

}  // namespace

FrameView Border::continued(const FrameView& frame, BorderKind kind) {
  if (kind == BorderKind::fixed) return frame;
  const int width = frame.width + 2 * kMargin, height = frame.height + 2 * kMargin;
  pixels_.resize(std::size_t(width) * height);
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* from = frame.pixels + source_of(y - kMargin, frame.height, kind) * frame.pitch;
    Rgba* to = pixels_.data() + std::size_t(y) * width;
    std::memcpy(to + kMargin, from, sizeof(Rgba) * frame.width);
    for (int x = 0; x < kMargin; ++x) {
      const int east = frame.width + kMargin + x;
      to[x] = to[kMargin + source_of(x - kMargin, frame.width, kind)];
      to[east] = to[kMargin + source_of(east - kMargin, frame.width, kind)];
    }
  }
  return {reinterpret_cast<const std::uint8_t*>(pixels_.data()), width, height,
          static_cast<std::ptrdiff_t>(sizeof(Rgba)) * width, kMargin};
}

}  // namespace depixel
