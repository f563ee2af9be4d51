#include "libdepixel/svg/simplify.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "libdepixel/pipeline/vectorizer.hpp"
#include "tests/support/random_pictures.hpp"
#include "tests/support/svg_tools.hpp"
#include "tests/support/test_pictures.hpp"

namespace depixel::test {
namespace {

constexpr SvgGrid kOutlineGrid = SvgGrid::within(kSvgTolerance);

struct Simplified {
  Outlines exact, simplified;

  explicit Simplified(const Picture& picture, const Options& options = {}) {
    Vectorizer vectorizer;
    Components components;
    const PlanarMap& map = vectorizer.vectorize(picture.view(), options);
    label_components(vectorizer.graph(), components);
    trace_outlines(map, vectorizer.graph(), components, exact);
    simplified = exact;
    simplify_outlines(map, kSvgTolerance, kOutlineGrid, simplified);
  }
};

using Curve = std::array<int, 8>;

/// All curves between two components, as seen from the one or from the other; border left out.
std::vector<Curve> curves(const Outlines& outlines, bool from_the_other_side) {
  std::vector<Curve> found;
  for (const OutlineLoop& loop : outlines.loops) {
    glm::ivec2 p0 = outlines.pieces[loop.first + loop.count - 1].p3;
    for (int i = loop.first; i < loop.first + loop.count; ++i) {
      const auto& [p1, p2, p3, segment] = outlines.pieces[i];
      if (segment != OutlinePiece::kBorder) {
        found.push_back(from_the_other_side ? Curve{p3.x, p3.y, p2.x, p2.y, p1.x, p1.y, p0.x, p0.y}
                                            : Curve{p0.x, p0.y, p1.x, p1.y, p2.x, p2.y, p3.x, p3.y});
      }
      p0 = p3;
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// A loop's points, close to each other, in pixels.
/// In how many pieces a curve is flattened so that none strays from it by more than 1/1000 pixel: its second
/// differences bound how far it bends. Long curves need more.
int pieces_of(glm::dvec2 p0, const OutlinePiece& piece) {
  constexpr double kStray = 0.001 * kSubpixels;
  const glm::dvec2 p1(piece.p1), p2(piece.p2), p3(piece.p3);
  const glm::dvec2 first = p0 - 2.0 * p1 + p2, second = p1 - 2.0 * p2 + p3;
  const double bend = std::max(std::hypot(first.x, first.y), std::hypot(second.x, second.y));
  return 1 + static_cast<int>(std::sqrt(0.75 * bend / kStray));
}

Polygon points(const Outlines& outlines, const OutlineLoop& loop) {
  Polygon polygon;
  glm::ivec2 p0 = outlines.pieces[loop.first + loop.count - 1].p3;
  for (int i = loop.first; i < loop.first + loop.count; ++i) {
    const OutlinePiece& piece = outlines.pieces[i];
    if (piece.segment == OutlinePiece::kBorder) {
      polygon.emplace_back(piece.p3);
    } else {
      append_curve(p0, piece.p1, piece.p2, piece.p3, polygon, pieces_of(p0, piece));
    }
    p0 = piece.p3;
  }
  for (glm::dvec2& p : polygon) p /= double(kSubpixels);
  return polygon;
}

double distance(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 ab = b - a, ap = p - a;
  const double square = ab.x * ab.x + ab.y * ab.y;
  const double t = square > 0 ? std::clamp((ab.x * ap.x + ab.y * ap.y) / square, 0.0, 1.0) : 0;
  return std::hypot(ap.x - t * ab.x, ap.y - t * ab.y);
}

/// How far the points of a polygon are at most from another's sides.
double farthest(const Polygon& from, const Polygon& to) {
  double most = 0;
  for (const glm::dvec2 p : from) {
    double least = distance(p, to.back(), to.front());
    for (std::size_t i = 1; i < to.size(); ++i) least = std::min(least, distance(p, to[i - 1], to[i]));
    most = std::max(most, least);
  }
  return most;
}

int count_crossings(const std::vector<Polygon>& polygons) {
  std::vector<std::pair<glm::dvec2, glm::dvec2>> sides;
  for (const Polygon& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      sides.emplace_back(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
  }
  const auto side_of = [](glm::dvec2 p, const auto& side) {
    const glm::dvec2 along = side.second - side.first, way = p - side.first;
    return along.x * way.y - along.y * way.x;
  };
  constexpr double kTouching = 1e-6;
  int crossings = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto &a = sides[i], &b = sides[j];
      const double a0 = side_of(a.first, b), a1 = side_of(a.second, b);
      const double b0 = side_of(b.first, a), b1 = side_of(b.second, a);
      const auto is_apart = [](double p, double q) {
        return (p > kTouching && q < -kTouching) || (p < -kTouching && q > kTouching);
      };
      if (is_apart(a0, a1) && is_apart(b0, b1)) ++crossings;
    }
  }
  return crossings;
}

std::vector<Polygon> all_points(const Outlines& outlines) {
  std::vector<Polygon> polygons;
  for (const OutlineLoop& loop : outlines.loops) polygons.push_back(points(outlines, loop));
  return polygons;
}

RC_GTEST_PROP(SimplifyOutlines, BothSidesShareTheirCurves, (const Picture& picture)) {
  const Outlines outlines = Simplified(picture, *random_options()).simplified;
  RC_ASSERT(curves(outlines, false) == curves(outlines, true));
}

RC_GTEST_PROP(SimplifyOutlines, PointsLieOnTheGrid, (const Picture& picture)) {
  const Outlines outlines = Simplified(picture, *random_options()).simplified;
  for (const OutlinePiece& piece : outlines.pieces) RC_ASSERT(kOutlineGrid.snapped(piece.p3) == piece.p3);
}

RC_GTEST_PROP(SimplifyOutlines, StrayNoFurtherThanAllowed, ()) {
  const Simplified traced(*random_picture({.max_size = 12}), *random_options());
  constexpr double kFlattening = 0.003;
  for (std::size_t i = 0; i < traced.exact.loops.size(); ++i) {
    const Polygon exact = points(traced.exact, traced.exact.loops[i]);
    const Polygon simplified = points(traced.simplified, traced.simplified.loops[i]);
    RC_ASSERT(farthest(simplified, exact) <= kSvgTolerance + kFlattening);
    RC_ASSERT(farthest(exact, simplified) <= kSvgTolerance + kFlattening);
  }
}

RC_GTEST_PROP(SimplifyOutlines, CurvesAreNoMore, (const Picture& picture)) {
  const Simplified traced(picture, *random_options());
  for (std::size_t i = 0; i < traced.exact.loops.size(); ++i) {
    RC_ASSERT(traced.simplified.loops[i].count <= traced.exact.loops[i].count);
  }
}

/// Sides of lines one pixel wide, straight, slanted and bent, come near to each other.
TEST(SimplifyOutlines, SidesOfThinLinesDoNotCross) {
  const Picture thin =
      ascii_picture({"#........#.......", ".#......#..####..", "..#....#..#....#.", "...#..#..#......#",
                     "....##...#......#", "##..##...#......#", "..##..##..#....#.", "........#..####..",
                     "###........#.....", "...###....#.#....", "......###.......#"});
  const Simplified traced(thin);
  EXPECT_EQ(count_crossings(all_points(traced.exact)), 0);
  EXPECT_EQ(count_crossings(all_points(traced.simplified)), 0);
}

/// Nothing else makes it smaller than fewer pieces. Colours are near to each other, so that what strays costs
/// little.
TEST(SimplifyOutlines, SmoothShapesTakeFewCurves) {
  Picture disc(32, 32);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      const double dx = x - 15.5, dy = y - 15.5;
      disc.at(x, y) = dx * dx + dy * dy < 169 ? Rgba{100, 100, 100, 255} : Rgba{120, 120, 120, 255};
    }
  }
  const Simplified traced(disc);
  EXPECT_GT(traced.exact.loops.back().count, 80);
  EXPECT_LE(traced.simplified.loops.back().count, 12);
}

}  // namespace
}  // namespace depixel::test
