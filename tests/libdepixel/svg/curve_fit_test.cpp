#include "libdepixel/svg/curve_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "libdepixel/svg/svg_document.hpp"
#include "tests/support/svg_tools.hpp"

namespace depixel::test {
namespace {

constexpr double kTolerance = 0.04;
constexpr SvgGrid kFitGrid = SvgGrid::within(kTolerance);

/// A point in hundredths of a pixel.
glm::ivec2 hundredths(double x, double y) {
  return {static_cast<int>(std::lround(x * kSubpixels / 100)),
          static_cast<int>(std::lround(y * kSubpixels / 100))};
}

/// A run of a chain that is all of it.
struct Fitting {
  std::vector<Cubic> chain;
  std::vector<char> is_free;
  CurveFitter fitter{kTolerance, kFitGrid};

  explicit Fitting(std::vector<Cubic> curves) : chain(std::move(curves)), is_free(chain.size() + 1, 0) {
    fitter.set_chain(chain, is_free);
  }
  int size() const { return static_cast<int>(chain.size()); }
};

/// A part of a circle round (0, 0), in curves of the same angle.
std::vector<Cubic> arc(double radius, double radians, int curves) {
  std::vector<Cubic> chain;
  const double step = radians / curves, handle = radius * 4 / 3 * std::tan(step / 4);
  for (int i = 0; i < curves; ++i) {
    const double a = i * step, b = a + step;
    chain.push_back(
        {hundredths(radius * std::cos(a), radius * std::sin(a)),
         hundredths(radius * std::cos(a) - handle * std::sin(a), radius * std::sin(a) + handle * std::cos(a)),
         hundredths(radius * std::cos(b) + handle * std::sin(b), radius * std::sin(b) - handle * std::cos(b)),
         hundredths(radius * std::cos(b), radius * std::sin(b))});
  }
  return chain;
}

Cubic straight(glm::ivec2 from, glm::ivec2 to) {
  return {from, (2 * from + to) / 3, (from + 2 * to) / 3, to};
}

TEST(SvgGrid, IsAsCoarseAsTheToleranceAllows) {
  EXPECT_EQ(SvgGrid::within(0).step, 1);
  EXPECT_EQ(SvgGrid::within(0.01).step, 1);
  EXPECT_EQ(SvgGrid::within(kSvgTolerance).step, 10);
  EXPECT_EQ(SvgGrid::within(0.3).step, 100);
}

TEST(SvgGrid, FindsSnappedPointsAgain) {
  for (const int step : {1, 10, 100}) {
    const SvgGrid grid{step};
    for (int i = -3 * kSubpixels; i < 3 * kSubpixels; i += 7) {
      const glm::ivec2 point(i, -i), snapped = grid.snapped(point);
      ASSERT_EQ(grid.thousandths(snapped), grid.thousandths(point));
      ASSERT_EQ(grid.thousandths(snapped).x % step, 0);
      ASSERT_LE(std::abs(snapped.x - i), step * kSubpixels / 2000 + 1);
    }
  }
}

TEST(CurveFitter, FitsALineToWhatIsNearlyStraight) {
  Fitting run(
      {straight(hundredths(0, 0), hundredths(100, 2)), straight(hundredths(100, 2), hundredths(300, 0))});
  const auto line = run.fitter.fit_line(0, 2);
  ASSERT_TRUE(line);
  const Cubic& c = line->curve;
  EXPECT_TRUE(is_svg_line(c.p0, c.p1, c.p2, c.p3));
  EXPECT_EQ(c.p3, run.chain.back().p3);
  EXPECT_NEAR(line->area_px, 0.03, 0.01);  // of a triangle 3 pixels wide and 0.02 high
}

TEST(CurveFitter, FitsNoLineToWhatIsTooFarOff) {
  Fitting run(
      {straight(hundredths(0, 0), hundredths(100, 5)), straight(hundredths(100, 5), hundredths(200, 0))});
  EXPECT_FALSE(run.fitter.fit_line(0, 2));
}

TEST(CurveFitter, FitsNoLineToWhatLeavesItsEndsAskew) {
  // A control point 0.035 pixel beyond the end and 0.035 aside is farther from it than either.
  const auto with_last = [](double x, double y) {
    return Fitting({Cubic{hundredths(0, 0), hundredths(100, 0), hundredths(x, y), hundredths(300, 0)}});
  };
  Fitting near = with_last(303.5, 0), far = with_last(303.5, 3.5);
  near.is_free = far.is_free = {1, 1};
  EXPECT_TRUE(near.fitter.fit_line(0, 1));
  EXPECT_FALSE(far.fitter.fit_line(0, 1));
}

TEST(CurveFitter, KeepsTangentsUnlessFree) {
  Fitting run({{hundredths(0, 0), hundredths(5, 3), hundredths(20, 2), hundredths(40, 0)}});
  EXPECT_FALSE(run.fitter.fit_line(0, 1));
  run.is_free.front() = 1;
  EXPECT_TRUE(run.fitter.fit_line(0, 1));
}

TEST(CurveFitter, FitsAQuadraticCurveToABend) {
  Fitting run(arc(150, 0.8, 4));
  const auto curve = run.fitter.fit_quadratic(0, 4);
  ASSERT_TRUE(curve);
  const Cubic& c = curve->curve;
  EXPECT_TRUE(svg_quadratic_control(c.p0, c.p1, c.p2, c.p3));
}

TEST(CurveFitter, FitsACubicCurveToAThirdOfACircle) {
  Fitting run(arc(400, 2.0, 9));
  const auto curve = run.fitter.fit_cubic(0, 9);
  ASSERT_TRUE(curve);
  EXPECT_FALSE(run.fitter.fit_quadratic(0, 9));
  Polygon points;
  const Cubic& c = curve->curve;
  append_curve(c.p0, c.p1, c.p2, c.p3, points);
  for (const glm::dvec2 p : points) {
    EXPECT_NEAR(std::hypot(p.x, p.y) / kSubpixels, 4.0, kTolerance);
  }
}

TEST(CurveFitter, FitsNothingToWhatTurnsTooMuch) {
  Fitting run(arc(400, 5.0, 16));
  EXPECT_FALSE(run.fitter.fit_line(0, 16));
  EXPECT_FALSE(run.fitter.fit_quadratic(0, 16));
  EXPECT_FALSE(run.fitter.fit_cubic(0, 16));
}

TEST(CurveFitter, KnowsCorners) {
  const Cubic east = straight({0, 0}, {300, 0});
  EXPECT_TRUE(is_corner(east, straight({300, 0}, {300, 300})));
  EXPECT_FALSE(is_corner(east, straight({300, 0}, {600, 60})));
  EXPECT_TRUE(is_corner(east, straight({300, 0}, {0, 0})));
}

}  // namespace
}  // namespace depixel::test
