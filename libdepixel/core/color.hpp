#pragma once

#include <cstdint>
#include <cstdlib>

namespace depixel {

/// One pixel: red, green, blue and straight (not premultiplied) alpha, 0..255 each, in memory order.
struct Rgba {
  std::uint8_t r = 0, g = 0, b = 0, a = 0;
  friend constexpr bool operator==(Rgba, Rgba) = default;
};
static_assert(sizeof(Rgba) == 4);

/// All colours of alpha 0 are one colour: the transparent one.
constexpr Rgba normalized(Rgba c) {
  return c.a == 0 ? Rgba{} : c;
}

/// Numeric order of colours, r most significant; used to break ties between colours.
constexpr std::uint32_t rgba_order(Rgba c) {
  return std::uint32_t{c.r} << 24 | std::uint32_t{c.g} << 16 | std::uint32_t{c.b} << 8 | c.a;
}

/// Difference of two colours in full-range BT.601 YUV, in 1/1000 of a level (0..255), exact integers.
struct YuvDifference {
  std::int32_t y, u, v;
};

constexpr YuvDifference yuv_difference(Rgba p, Rgba q) {
  const int r = p.r - q.r, g = p.g - q.g, b = p.b - q.b;
  return {299 * r + 587 * g + 114 * b, -169 * r - 331 * g + 500 * b, 500 * r - 419 * g - 81 * b};
}

/// The criterion for merging: at most so many 1/1000 of a level apart in Y, 7 levels in U and 6 in V; alpha
/// must be equal. With 48 levels of Y it is that of hqx.
constexpr bool similar_yuv(Rgba p, Rgba q, int max_y) {
  constexpr int kMaxU = 7'000, kMaxV = 6'000;
  const auto magnitude = [](int v) { return v < 0 ? -v : v; };
  const YuvDifference d = yuv_difference(p, q);
  return p.a == q.a && magnitude(d.y) <= max_y && magnitude(d.u) <= kMaxU && magnitude(d.v) <= kMaxV;
}

/// Whether the Euclidean YUV distance of two colours is at most so many 1/1000 of a level.
/// Colours of unequal alpha are never near.
constexpr bool is_within_yuv(Rgba p, Rgba q, std::int64_t distance) {
  const YuvDifference d = yuv_difference(p, q);
  const auto square = [](std::int64_t v) { return v * v; };
  return p.a == q.a && square(d.y) + square(d.u) + square(d.v) <= square(distance);
}

/// A distance of at most 100 levels: the bound of shading contours and of connect-lines.
/// Source: Kopf and Lischinski 2011, section 3.3.
constexpr bool near_yuv(Rgba p, Rgba q) {
  return is_within_yuv(p, q, 100'000);
}

}  // namespace depixel
