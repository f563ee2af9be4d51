#include "libdepixel/svg/chain_simplifier.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace depixel::test {
namespace {

constexpr SvgGrid kGrid = SvgGrid::within(kSvgTolerance);

/// A flat bow from (0, 0) to (8, 0) pixels, as a chain of short lines, that rises to a height.
Chain bow(double height_px, int weight) {
  constexpr int kLines = 8;
  const auto at = [&](int i) {
    const double x = i - kLines / 2.0;
    const double y = height_px * (1 - 4 * x * x / (kLines * kLines));
    return glm::ivec2(i * kSubpixels, static_cast<int>(std::lround(y * kSubpixels)));
  };
  Chain chain;
  chain.is_free = {true, true};
  chain.weight = weight;
  for (int i = 0; i < kLines; ++i) {
    const glm::ivec2 from = at(i), to = at(i + 1);
    chain.curves.push_back({from, (2 * from + to) / 3, (from + 2 * to) / 3, to});
  }
  return chain;
}

std::vector<Cubic> simplified(const Chain& chain) {
  std::vector<Cubic> curves;
  ChainSimplifier(kSvgTolerance, kGrid).simplify(chain, curves);
  return curves;
}

bool is_level(const Cubic& c) {
  return c.p0.y == c.p1.y && c.p1.y == c.p2.y && c.p2.y == c.p3.y;
}

TEST(CurveCost, CountsCharactersOfBothSides) {
  const CurveCost cost(kGrid);
  const auto px = [](double x, double y) {
    return glm::ivec2(std::lround(x * kSubpixels), std::lround(y * kSubpixels));
  };
  EXPECT_EQ(cost.of_line({{px(0, 0), px(1, 0), px(2, 0), px(3, 0)}, 0}), 2 * 3.0);  // "h 3", "h-3"
  EXPECT_EQ(cost.of_line({{px(0, 0), px(1, .5), px(2, 1), px(3, 1.5)}, 0}), 2 * (1 + 2 + 4.0));
  EXPECT_EQ(cost.of_quadratic({{px(0, 0), px(2, 0), px(3, 1), px(3, 3)}, 0}), 2 * (1 + 4 + 4.0));
  EXPECT_EQ(cost.of_cubic({{px(0, 0), px(1, 0), px(3, 1), px(3, 3)}, 0}), 2 * (1 + 4 + 4 + 4.0));
}

TEST(ChainSimplifier, WhatIsSeenMostStraysLeast) {
  constexpr double kHeight = 0.008;
  const Chain faint = bow(kHeight, 1), strong = bow(kHeight, CurveCost::kWeights);
  ASSERT_EQ(simplified(faint).size(), 1u);
  EXPECT_TRUE(is_level(simplified(faint).front()));
  EXPECT_FALSE(is_level(simplified(strong).front()));
}

TEST(ChainSimplifier, StartsAtTheGivenStartAndGoesOn) {
  const std::vector<Cubic> curves = simplified(bow(1.5, 4));
  EXPECT_EQ(curves.front().p0, glm::ivec2(0, 0));
  EXPECT_EQ(curves.back().p3, glm::ivec2(8 * kSubpixels, 0));
  for (std::size_t i = 1; i < curves.size(); ++i) EXPECT_EQ(curves[i].p0, curves[i - 1].p3);
}

}  // namespace
}  // namespace depixel::test
