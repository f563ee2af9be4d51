#include "bench/svg/outline_raster.hpp"

#include <cmath>
#include <cstdlib>

#include "libdepixel/raster/cpu_raster.hpp"

namespace depixel::bench {
namespace {

/// Cuts a curve to parts, so that long ones are flattened no less finely than short ones.
void append_parts(glm::ivec2 p0, const OutlinePiece& piece, int left, int right,
                  std::vector<Segment>& segments) {
  constexpr int kParts = 8;
  const glm::dvec2 c0(p0), c1(3 * (piece.p1 - p0)), c2(3 * (p0 - 2 * piece.p1 + piece.p2)),
      c3(piece.p3 - p0 + 3 * (piece.p1 - piece.p2));
  const auto round = [](glm::dvec2 p) {
    return glm::ivec2(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y)));
  };
  const auto at = [&](double t) { return ((c3 * t + c2) * t + c1) * t + c0; };
  const auto slope = [&](double t) { return (3.0 * c3 * t + 2.0 * c2) * t + c1; };
  glm::ivec2 from = p0;
  for (int i = 0; i < kParts; ++i) {
    const double t = double(i) / kParts, u = double(i + 1) / kParts, third = (u - t) / 3;
    const glm::ivec2 to = round(at(u));
    segments.push_back(
        {from, round(at(t) + slope(t) * third), round(at(u) - slope(u) * third), to, left, right});
    from = to;
  }
}

/// A pixel of each component.
std::vector<int> some_pixels(const Components& components) {
  std::vector<int> pixels(components.count);
  for (int i = 0; i < static_cast<int>(components.label.size()); ++i) {
    if (components.label[i] >= 0) pixels[components.label[i]] = i;
  }
  return pixels;
}

/// A channel times its alpha.
int premultiplied(int channel, int alpha) {
  return (channel * alpha + 127) / 255;
}

}  // namespace

/// Each outline is drawn as if nothing were outside. Where two meet, their changes of colour add up.
Picture draw_outlines(const PlanarMap& map, const Components& components, const Outlines& outlines) {
  constexpr int kOutside = 0;
  PlanarMap drawn{map.lattice, map.colours, {}, {}};
  const std::vector<int> pixels = some_pixels(components);
  for (const OutlineLoop& loop : outlines.loops) {
    glm::ivec2 from = outlines.pieces[loop.first + loop.count - 1].p3;
    for (int i = loop.first; i < loop.first + loop.count; ++i) {
      const OutlinePiece& piece = outlines.pieces[i];
      if (piece.segment != OutlinePiece::kBorder) {
        append_parts(from, piece, pixels[loop.component], kOutside, drawn.segments);
      }
      from = piece.p3;
    }
  }
  Picture picture(map.lattice.width() * kOutlineScale, map.lattice.height() * kOutlineScale);
  CpuRaster().draw(drawn, View::fit(map.lattice, picture.width(), picture.height()), false, 1,
                   picture.target());
  return picture;
}

double mean_difference(const Picture& a, const Picture& b) {
  std::int64_t sum = 0;
  bool is_opaque = true;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const Rgba p = a.at(x, y), q = b.at(x, y);
      is_opaque = is_opaque && p.a == 255 && q.a == 255;
      sum += std::abs(p.a - q.a);
      for (const auto channel : {&Rgba::r, &Rgba::g, &Rgba::b}) {
        sum += std::abs(premultiplied(p.*channel, p.a) - premultiplied(q.*channel, q.a));
      }
    }
  }
  const double channels = is_opaque ? 3 : 4;
  return static_cast<double>(sum) / (channels * a.width() * a.height());
}

}  // namespace depixel::bench
