#include "libdepixel/stages/corners.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "libdepixel/pipeline/verify.hpp"
#include "libdepixel/raster/cpu_raster.hpp"
#include "tests/support/ascii_picture.hpp"
#include "tests/support/map_segments.hpp"
#include "tests/support/map_splines.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

/// Where curves turn by more than 25 degrees from one segment to the next, in source pixels.
std::vector<glm::dvec2> kinks(const Picture& picture, Corners corners) {
  constexpr double kSine = 0.42;
  Options options;
  options.corners = corners;
  Vectorizer vectorizer;
  vectorizer.vectorize(picture.view(), options);
  std::vector<glm::dvec2> found;
  for (const ReadCurve& curve : read_curves(vectorizer)) {
    if (!curve.closed) continue;
    const std::size_t count = curve.knots.size();
    for (std::size_t k = 0; k < count; ++k) {
      // Control points at both sides of a knot tell the tangents there.
      const auto control = [&](std::size_t i) { return curve.controls[(k + i + count) % count]; };
      const glm::dvec2 in = curve.knots[k] - control(count - 1), out = control(1) - curve.knots[k];
      const double sine = (in.x * out.y - in.y * out.x) / (glm::length(in) * glm::length(out));
      const bool is_smooth =
          glm::distance(curve.knots[k], (control(count - 1) + 4.0 * control(0) + control(1)) / 6.0) <
          8.0 / kSubpixels;
      if (!is_smooth && (std::fabs(sine) > kSine || glm::dot(in, out) < 0)) found.push_back(curve.knots[k]);
    }
  }
  return found;
}

/// Black on white where a function of a pixel's centre holds.
template <typename Inside>
Picture shape(int side, Inside inside) {
  Picture picture(side, side, palette_colour('.'));
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      if (inside(x + 0.5, y + 0.5)) picture.at(x, y) = palette_colour('#');
    }
  }
  return picture;
}

/// A picture of which each pixel is a square of some.
Picture enlarged(const Picture& small, int times) {
  Picture picture(small.width * times, small.height * times, palette_colour('.'));
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) picture.at(x, y) = small.at(x / times, y / times);
  }
  return picture;
}

bool has_near(const std::vector<glm::dvec2>& points, glm::dvec2 wanted, double distance) {
  return std::any_of(points.begin(), points.end(),
                     [&](glm::dvec2 p) { return glm::distance(p, wanted) <= distance; });
}

TEST(Corners, LettersStaySharp) {
  const Picture e = ascii_picture({".....", ".###.", ".#...", ".##..", ".#...", ".###.", "....."});
  const Picture t = ascii_picture({".....", ".###.", "..#..", "..#..", "..#..", "....."});
  const Picture l = ascii_picture({".....", ".#...", ".#...", ".#...", ".###.", "....."});
  for (const int times : {3, 4, 5, 7}) {
    EXPECT_EQ(kinks(enlarged(l, times), Corners::sharp).size(), 6U) << times;
    EXPECT_EQ(kinks(enlarged(t, times), Corners::sharp).size(), 8U) << times;
    EXPECT_EQ(kinks(enlarged(e, times), Corners::sharp).size(), 12U) << times;
  }
  // Strokes two pixels wide have square ends, and an L its corner.
  EXPECT_EQ(kinks(enlarged(l, 2), Corners::sharp).size(), 6U);
  EXPECT_LT(kinks(enlarged(l, 2), Corners::round).size(), 6U);
}

TEST(Corners, BarsTwoPixelsWideHaveSquareEnds) {
  for (const int length : {2, 3, 7, 8, 20}) {
    Picture picture(length + 4, 6, palette_colour('.'));
    paste(picture, Picture(length, 2, palette_colour('#')), 2, 2);
    EXPECT_EQ(kinks(picture, Corners::sharp).size(), length >= 8 ? 4U : 0U) << length;
    EXPECT_EQ(kinks(picture, Corners::round).size(), 0U) << length;
  }
}

TEST(Corners, DiamondsHaveFour) {
  for (const int radius : {8, 9, 12, 15}) {
    for (const double centre : {20.0, 20.5}) {
      const Picture picture = shape(
          41, [&](double x, double y) { return std::fabs(x - centre) + std::fabs(y - centre) < radius; });
      const auto found = kinks(picture, Corners::sharp);
      EXPECT_TRUE(kinks(picture, Corners::round).empty());
      EXPECT_TRUE(found.size() == 4U || found.size() == 8U) << radius;  // a tip one step wide has two nodes
      for (const glm::dvec2 tip : {glm::dvec2(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        EXPECT_TRUE(has_near(found, centre + double(radius) * tip, 1.0)) << radius << ' ' << tip.x;
      }
    }
  }
}

TEST(Corners, WedgesOfAnySlopeHaveATip) {
  for (const double slope : {1.0 / 3, 1.0 / 2, 2.0 / 3, 1.0}) {
    const auto inside = [&](double x, double y) {
      return x > 4 && x < 30 && std::fabs(y - 20) < slope * (30 - x) && std::fabs(y - 20) < 14;
    };
    // The last pixel ends up to half a pixel of the tip's height before it, and nodes go on by less.
    EXPECT_TRUE(has_near(kinks(shape(40, inside), Corners::sharp), {30, 20}, 0.6 / slope)) << slope;
  }
}

TEST(Corners, PolygonsHaveTheirsWhateverTheirAngle) {
  for (int degrees = 0; degrees < 90; degrees += 7) {
    const double turn = degrees * std::acos(-1.0) / 180, c = std::cos(turn), s = std::sin(turn);
    const Picture picture = shape(48, [&](double x, double y) {
      const double u = c * (x - 24.2) + s * (y - 23.9), v = c * (y - 23.9) - s * (x - 24.2);
      return std::fabs(u) < 13 && std::fabs(v) < 13;
    });
    const auto found = kinks(picture, Corners::sharp);
    for (const glm::dvec2 corner : {glm::dvec2(13, 13), {13, -13}, {-13, -13}, {-13, 13}}) {
      const glm::dvec2 at(24.2 + c * corner.x - s * corner.y, 23.9 + s * corner.x + c * corner.y);
      EXPECT_TRUE(has_near(found, at, 1.3)) << degrees;
    }
    EXPECT_LE(found.size(), 8U) << degrees;
  }
}

TEST(Corners, DiscsAndRingsHaveNone) {
  for (double radius = 3; radius <= 20; radius += 0.25) {
    for (const glm::dvec2 centre : {glm::dvec2(22, 22), {22.5, 22.5}, {22.25, 22.4}}) {
      const auto distance = [&](double x, double y) { return glm::distance(glm::dvec2(x, y), centre); };
      const auto is_inside = [&](double x, double y) { return distance(x, y) < radius; };
      const auto is_on_ring = [&](double x, double y) {
        return distance(x, y) < radius && distance(x, y) > radius - 1.5;
      };
      // Right angles of level arms of three steps, as some discs have, are cut whatever the option.
      for (const Picture& picture : {shape(45, is_inside), shape(45, is_on_ring)}) {
        EXPECT_EQ(kinks(picture, Corners::sharp), kinks(picture, Corners::round)) << radius;
      }
    }
  }
}

TEST(Corners, SidesAreStraight) {
  // A square that stands askew: away from its corners its outline keeps to the lines.
  const double c = 0.8, s = 0.6;
  const Picture picture = shape(48, [&](double x, double y) {
    return std::fabs(c * (x - 24) + s * (y - 24)) < 14 && std::fabs(c * (y - 24) - s * (x - 24)) < 14;
  });
  const auto stray = [&](Corners corners) {
    Options options;
    options.corners = corners;
    Vectorizer vectorizer;
    vectorizer.vectorize(picture.view(), options);
    double sum = 0;
    for (const ReadCurve& curve : read_curves(vectorizer)) {
      for (const glm::dvec2 knot : curve.knots) {
        const double u = std::fabs(c * (knot.x - 24) + s * (knot.y - 24));
        const double v = std::fabs(c * (knot.y - 24) - s * (knot.x - 24));
        sum += std::fabs(std::max(u, v) - 14) / static_cast<double>(curve.knots.size());
      }
    }
    return sum;
  };
  EXPECT_LT(stray(Corners::sharp), 0.6 * stray(Corners::round));
}

TEST(Corners, StrokesKeepTheirWidthToTheirEnds) {
  constexpr int kScale = 16;
  const Picture picture = ascii_picture({".................",  //
                                         ".......#.........",  //
                                         ".......#.........",  //
                                         "......#..........",  //
                                         "......#..........",  //
                                         ".....#...........",  //
                                         ".....#...........",  //
                                         "....#............",  //
                                         "....#............",  //
                                         "...#.............",  //
                                         "...#.............",  //
                                         "..############...",  //
                                         "................."});
  Picture out(kScale * picture.width, kScale * picture.height);
  const PlanarMap map = vectorized(picture);
  CpuRaster().draw(map, View::fit(map.lattice, out.width, out.height), false, 1, out.target());
  for (int x = 6; x < 13; ++x) {
    int ink = 0;
    for (int y = 10 * kScale; y < out.height; ++y) ink += 255 - out.at(x * kScale, y).r;
    EXPECT_NEAR(ink / 255.0 / kScale, 1, 0.05) << x;
  }
}

TEST(Corners, TheBowOfAKeyStaysRound) {
  const Picture bow = ascii_picture({"................",  //
                                     "......###.......",  //
                                     ".....#####......",  //
                                     ".....######.....",  //
                                     "....########....",  //
                                     "....#########...",  //
                                     "...###########..",  //
                                     "...############.",  //
                                     "...############.",  //
                                     "...############.",  //
                                     "................"});
  for (const glm::dvec2 kink : kinks(bow, Corners::sharp)) EXPECT_GT(kink.y, 5);
}

TEST(Corners, AreNoneWithoutEnergy) {
  const Picture picture =
      shape(41, [](double x, double y) { return std::fabs(x - 20) + std::fabs(y - 20) < 12; });
  for (const Smoothing smoothing : {Smoothing::average, Smoothing::none}) {
    const auto drawn = [&](Corners corners) {
      Options options;
      options.smoothing = smoothing;
      options.corners = corners;
      return Vectorizer().vectorize(picture.view(), options).segments;
    };
    EXPECT_EQ(drawn(Corners::sharp), drawn(Corners::round));
  }
}

/// A polygon of random points, with lines of one pixel round it at times.
Picture random_polygon() {
  const int count = *rc::gen::inRange(3, 7);
  std::vector<glm::dvec2> points;
  points.reserve(count);
  for (int k = 0; k < count; ++k)
    points.emplace_back(*rc::gen::inRange(0, 320) / 10.0, *rc::gen::inRange(0, 320) / 10.0);
  const auto crossings = [&](double x, double y) {
    bool is_inside = false;
    for (int k = 0; k < count; ++k) {
      const glm::dvec2 a = points[k], b = points[(k + 1) % count];
      if ((a.y > y) != (b.y > y) && x < a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y)) is_inside = !is_inside;
    }
    return is_inside;
  };
  Picture picture = shape(32, crossings);
  if (*rc::gen::arbitrary<bool>()) {
    const Picture filled = picture;
    for (int y = 1; y < 31; ++y) {
      for (int x = 1; x < 31; ++x) {
        const bool is_inner =
            filled.at(x - 1, y) == filled.at(x, y) && filled.at(x + 1, y) == filled.at(x, y) &&
            filled.at(x, y - 1) == filled.at(x, y) && filled.at(x, y + 1) == filled.at(x, y);
        if (is_inner && filled.at(x, y) == palette_colour('#')) picture.at(x, y) = palette_colour('r');
      }
    }
  }
  return picture;
}

RC_GTEST_PROP(Corners, OfPolygonsLeaveEveryCentreItsColour, ()) {
  const Picture picture = random_polygon();
  Vectorizer vectorizer;
  const PlanarMap& map = vectorizer.vectorize(picture.view(), {});
  const CentreReport report = verify_centres(map, vectorizer.graph());
  RC_ASSERT(report.lost == 0);
  RC_ASSERT(report.nearest >= (kCentreClearance - 1.0) / kSubpixels);
}

RC_GTEST_PROP(Corners, OfPolygonsFlipAndTurnWithThem, ()) {
  const Picture picture = random_polygon();
  Vectorizer vectorizer;
  const PlanarMap map = vectorizer.vectorize(picture.view(), {});
  for (const Symmetry& symmetry : kSymmetries) {
    const Picture changed = symmetry(picture);
    RC_ASSERT(free_segments(vectorizer.vectorize(changed.view(), {})) == free_segments(map, symmetry));
  }
}

}  // namespace
}  // namespace depixel::test
