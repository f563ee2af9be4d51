#include "libdepixel/core/light.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace depixel {
namespace {

TEST(Light, EverySrgbValueSurvivesTheWayThereAndBack) {
  for (int v = 0; v < 256; ++v) EXPECT_EQ(from_light(to_light(static_cast<std::uint8_t>(v))), v);
}

TEST(Light, EndsAndMiddleAsInTheStandard) {
  EXPECT_EQ(to_light(0), 0);
  EXPECT_EQ(to_light(255), kLightLevels);
  // IEC 61966-2-1: half the light of white is 188 in sRGB, and 128 is 21.6 % of it.
  EXPECT_EQ(from_light(kLightLevels / 2), 188);
  EXPECT_NEAR(to_light(128) / double(kLightLevels), 0.2158, 0.0002);
  EXPECT_NEAR(to_light(10) / double(kLightLevels), 10 / 255.0 / 12.92, 0.0001);
}

TEST(Light, LevelsBecomeTheNearestValue) {
  for (int level = 0; level <= kLightLevels; ++level) {
    const auto error = [&](int srgb) { return std::abs(to_light(static_cast<std::uint8_t>(srgb)) - level); };
    const int v = from_light(level);
    EXPECT_LE(error(v), error(std::max(v - 1, 0))) << level;
    EXPECT_LE(error(v), error(std::min(v + 1, 255))) << level;
  }
}

TEST(Light, OutOfRangeIsClamped) {
  EXPECT_EQ(from_light(-5), 0);
  EXPECT_EQ(from_light(kLightLevels + 1), 255);
}

}  // namespace
}  // namespace depixel
