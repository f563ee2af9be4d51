#include "libdepixel/pipeline/verify.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "libdepixel/core/tolerances.hpp"

namespace depixel {
namespace {

constexpr double kHalf = kSubpixels / 2.0;

/// A cubic Bezier curve in subpixels.
struct Cubic {
  glm::dvec2 p0, p1, p2, p3;

  explicit Cubic(const Segment& s) : p0(s.p0), p1(s.p1), p2(s.p2), p3(s.p3) {}
  Cubic(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) : p0(a), p1(b), p2(c), p3(d) {}

  glm::dvec2 low() const { return glm::min(glm::min(p0, p1), glm::min(p2, p3)); }
  glm::dvec2 high() const { return glm::max(glm::max(p0, p1), glm::max(p2, p3)); }

  double x(double t) const { return at(t, p0.x, p1.x, p2.x, p3.x); }
  double y(double t) const { return at(t, p0.y, p1.y, p2.y, p3.y); }

  /// Both halves, by de Casteljau's construction.
  std::array<Cubic, 2> halves() const {
    const glm::dvec2 a = (p0 + p1) * 0.5, b = (p1 + p2) * 0.5, c = (p2 + p3) * 0.5;
    const glm::dvec2 d = (a + b) * 0.5, e = (b + c) * 0.5, middle = (d + e) * 0.5;
    return {Cubic(p0, a, d, middle), Cubic(middle, e, c, p3)};
  }

 private:
  /// Exact at t = 0 and t = 1, so that curves which share an end agree about it.
  static double at(double t, double a, double b, double c, double d) {
    const double s = 1 - t;
    return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
  }
};

/// Where a curve's y turns round: parameters in (0, 1), ascending, with 0 and 1 at the ends.
struct MonotonePieces {
  std::array<double, 4> bound{0, 1, 1, 1};
  int count = 1;

  explicit MonotonePieces(const Cubic& c) {
    // A third of the derivative is a t^2 - 2 b t + d.
    const double d = c.p1.y - c.p0.y, b = d - (c.p2.y - c.p1.y),
                 a = b + (c.p3.y - c.p2.y) - (c.p2.y - c.p1.y);
    const double discriminant = b * b - a * d;
    if (discriminant <= 0) return;
    const double q = b + std::copysign(std::sqrt(discriminant), b);
    double first = q == 0 ? 0 : d / q, second = a == 0 ? 0 : q / a;
    if (first > second) std::swap(first, second);
    count = 0;
    for (const double t : {first, second}) {
      if (t > bound[count] && t < 1) bound[++count] = t;
    }
    bound[++count] = 1;
  }
};

/// Where a piece of a curve that crosses a height once does so; by bisection.
double crossing_x(const Cubic& c, double from, double to, double height) {
  const bool starts_below = c.y(from) >= height;
  for (int i = 0; i < 52; ++i) {
    const double middle = (from + to) / 2;
    ((c.y(middle) >= height) == starts_below ? from : to) = middle;
  }
  return c.x(to);
}

double distance_to_line(glm::dvec2 p, glm::dvec2 from, glm::dvec2 to) {
  const glm::dvec2 along = to - from;
  const double length2 = glm::dot(along, along);
  const double t = length2 == 0 ? 0 : std::clamp(glm::dot(p - from, along) / length2, 0.0, 1.0);
  return glm::distance(p, from + along * t);
}

/// The smaller of `best` and the distance of a point from a curve.
double nearest_distance(const Cubic& c, glm::dvec2 p, double best) {
  constexpr double kFlat = 1.0 / 64;
  if (glm::distance(p, glm::clamp(p, c.low(), c.high())) >= best) return best;
  // A curve keeps within 3/4 of the larger bend of its chord.
  const glm::dvec2 bend = glm::max(glm::abs(c.p0 - 2.0 * c.p1 + c.p2), glm::abs(c.p1 - 2.0 * c.p2 + c.p3));
  if (0.75 * glm::length(bend) <= kFlat) return std::min(best, distance_to_line(p, c.p0, c.p3));
  for (const Cubic& half : c.halves()) best = nearest_distance(half, p, best);
  return best;
}

class CentreCheck {
 public:
  CentreCheck(const PlanarMap& map, const SimilarityGraph& graph)
      : map_(map), graph_(graph), changes_(std::size_t(width()) * height(), glm::ivec4(0)) {}

  CentreReport run() {
    for (int y = 0; y < height(); ++y) changes_[std::size_t(y) * width()] = levels(map_.lattice.pixel(0, y));
    for (const Segment& s : map_.segments) {
      const Cubic curve(s);
      add_crossings(curve, levels(s.left) - levels(s.right));
      approach(curve);
    }
    compare();
    report_.nearest /= kSubpixels;
    return report_;
  }

 private:
  int width() const { return map_.lattice.width(); }
  int height() const { return map_.lattice.height(); }

  static glm::ivec4 levels(Rgba c) { return {c.r, c.g, c.b, c.a}; }
  glm::ivec4 levels(int pixel) const { return levels(map_.colours[pixel]); }

  /// The colour at the centre of a pixel which lies in a region of some colour; as ShadeField has it, there
  /// in the block at the pixel's south-east, where all of the weight is the pixel's if it takes part.
  glm::ivec4 drawn(int pixel, glm::ivec4 region) const {
    const Shading& shading = map_.shading;
    if (shading.kind == ShadingKind::blur || !shading.any || shading.blocks[pixel] == 0) return region;
    const std::array<int, 4> offset = block_pixels(map_.lattice.stride());
    int own = 0;
    for (int k = 0; k < 4; ++k) own |= (levels(pixel + offset[k]) == region ? 1 : 0) << k;
    const bool takes_part = (blending_pixels(shading.blocks[pixel], own) >> kNorthWestPixel & 1) != 0;
    return takes_part ? levels(normalized(shading.shades[pixel])) : region;
  }

  /// The first centre (row or column of pixels) at or beyond a coordinate, within 0 .. count.
  static int first_centre(double subpixels, int count) {
    return static_cast<int>(std::clamp(std::ceil((subpixels - kHalf) / kSubpixels), 0.0, double(count)));
  }

  /// Adds what the curve changes to the first centre east of each crossing. A point on a row's centre line
  /// counts as below it, so ends that curves share, turning points and level pieces are counted once or not
  /// at all.
  void add_crossings(const Cubic& curve, glm::ivec4 east_when_down) {
    const MonotonePieces pieces(curve);
    for (int i = 0; i < pieces.count; ++i) {
      const double from = pieces.bound[i], to = pieces.bound[i + 1];
      const double y0 = curve.y(from), y1 = curve.y(to);
      const glm::ivec4 change = y0 < y1 ? east_when_down : -east_when_down;
      // Row centre lines with min < height <= max.
      const int first = first_centre(std::nextafter(std::min(y0, y1), 1e300), height());
      const int last = first_centre(std::nextafter(std::max(y0, y1), 1e300), height());
      for (int row = first; row < last; ++row) {
        const int column =
            first_centre(crossing_x(curve, from, to, row * double(kSubpixels) + kHalf), width());
        if (column < width()) changes_[std::size_t(row) * width() + column] += change;
      }
    }
  }

  /// Measures the distance to the centres that may be nearer than the nearest so far.
  void approach(const Cubic& curve) {
    const double reach = std::min(report_.nearest, double(kSubpixels));
    const glm::dvec2 low = curve.low() - reach, high = curve.high() + reach;
    for (int y = first_centre(low.y, height()), bottom = first_centre(high.y, height()); y < bottom; ++y) {
      for (int x = first_centre(low.x, width()), right = first_centre(high.x, width()); x < right; ++x) {
        const glm::dvec2 centre(x * double(kSubpixels) + kHalf, y * double(kSubpixels) + kHalf);
        report_.nearest = nearest_distance(curve, centre, report_.nearest);
      }
    }
  }

  void compare() {
    const Lattice& lattice = graph_.lattice;
    const int margin = lattice.margin();
    report_.pixels = lattice.shown_width() * lattice.shown_height();
    for (int y = margin; y < height() - margin; ++y) {
      glm::ivec4 shown(0);
      for (int x = 0; x < width() - margin; ++x) {
        shown += changes_[std::size_t(y) * width() + x];
        const int pixel = lattice.pixel(x, y);
        if (x < margin || drawn(pixel, shown) == levels(normalized(graph_.pixels[pixel]))) continue;
        if (report_.lost++ == 0) {
          report_.first_lost_x = x - margin;
          report_.first_lost_y = y - margin;
        }
      }
    }
  }

  const PlanarMap& map_;
  const SimilarityGraph& graph_;
  std::vector<glm::ivec4> changes_;  ///< by pixel: colour at its centre less that at the centre to the west
  CentreReport report_;
};

}  // namespace

CentreReport verify_centres(const PlanarMap& map, const SimilarityGraph& graph) {
  assert(map.lattice == graph.lattice);
  return CentreCheck(map, graph).run();
}

}  // namespace depixel
