#include "libdepixel/core/color.hpp"

#include <gtest/gtest.h>

#include "tests/support/ascii_picture.hpp"

namespace depixel {
namespace {

using test::kHqxLuma;

constexpr Rgba grey(int v) {
  const auto level = static_cast<std::uint8_t>(v);
  return {level, level, level, 255};
}

TEST(Color, AllTransparentColoursAreOne) {
  EXPECT_EQ(normalized({200, 10, 30, 0}), Rgba{});
  EXPECT_EQ(normalized({200, 10, 30, 1}), (Rgba{200, 10, 30, 1}));
}

TEST(Color, OrderIsRedFirstAlphaLast) {
  EXPECT_LT(rgba_order({1, 255, 255, 255}), rgba_order({2, 0, 0, 0}));
  EXPECT_LT(rgba_order({1, 2, 3, 4}), rgba_order({1, 2, 3, 5}));
  EXPECT_LT(rgba_order({1, 2, 255, 255}), rgba_order({1, 3, 0, 0}));
}

TEST(Color, YuvOfPrimariesAsInTheSpecification) {
  const YuvDifference red = yuv_difference({255, 0, 0, 255}, {0, 0, 0, 255});
  EXPECT_EQ(red.y, 255 * 299);
  EXPECT_EQ(red.u, 255 * -169);
  EXPECT_EQ(red.v, 255 * 500);
  const YuvDifference green = yuv_difference({0, 255, 0, 255}, {0, 0, 0, 255});
  EXPECT_EQ(green.y, 255 * 587);
  EXPECT_EQ(green.u, 255 * -331);
  EXPECT_EQ(green.v, 255 * -419);
  const YuvDifference blue = yuv_difference({0, 0, 255, 255}, {0, 0, 0, 255});
  EXPECT_EQ(blue.y, 255 * 114);
  EXPECT_EQ(blue.u, 255 * 500);
  EXPECT_EQ(blue.v, 255 * -81);
}

TEST(Color, GreysMergeUpToABound) {
  for (const int apart : {0, 5, 48}) {
    EXPECT_TRUE(similar_yuv(grey(100), grey(100 + apart), 1000 * apart));
    EXPECT_TRUE(similar_yuv(grey(100 + apart), grey(100), 1000 * apart));
    EXPECT_FALSE(similar_yuv(grey(100), grey(101 + apart), 1000 * apart));
  }
}

TEST(Color, ChromaBoundsAreTighterThanLuma) {
  // 14 levels of blue: 7 in U. 12 of red: 6 in V.
  EXPECT_TRUE(similar_yuv({100, 100, 114, 255}, grey(100), kHqxLuma));
  EXPECT_FALSE(similar_yuv({100, 100, 115, 255}, grey(100), kHqxLuma));
  EXPECT_TRUE(similar_yuv({112, 100, 100, 255}, grey(100), kHqxLuma));
  EXPECT_FALSE(similar_yuv({113, 100, 100, 255}, grey(100), kHqxLuma));
}

TEST(Color, ShadingDistanceIsEuclideanUpToOneHundred) {
  EXPECT_TRUE(near_yuv(grey(50), grey(150)));
  EXPECT_FALSE(near_yuv(grey(50), grey(151)));
  // Blue by 171 levels: (19.5, 85.5, -13.9), 88.8 in all; by 193: 100.2.
  EXPECT_TRUE(near_yuv({0, 0, 171, 255}, grey(0)));
  EXPECT_FALSE(near_yuv({0, 0, 193, 255}, grey(0)));
}

TEST(Color, UnequalAlphaIsNeitherSimilarNorNear) {
  EXPECT_FALSE(similar_yuv({9, 9, 9, 254}, grey(9), kHqxLuma));
  EXPECT_FALSE(near_yuv({9, 9, 9, 254}, grey(9)));
}

}  // namespace
}  // namespace depixel
