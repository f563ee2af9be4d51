#include "filter/host/host_frame.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace depixel::test {
namespace {

TEST(HostFrame, WordsOf32BitsKeepTheirColours) {
  const std::array<std::uint32_t, 6> words{0x00123456, 0xff000000, 0x99999999,
                                           0x00ffffff, 0x00ff0080, 0x99999999};
  std::vector<std::uint8_t> rgba;
  const FrameView view = to_rgba({words.data(), 2, 2, 12, HostFormat::xrgb8888}, rgba);
  const std::vector<std::uint8_t> expected{0x12, 0x34, 0x56, 255, 0,   0, 0,    255,
                                           255,  255,  255,  255, 255, 0, 0x80, 255};
  EXPECT_EQ(rgba, expected);
  EXPECT_EQ(view.width, 2);
  EXPECT_EQ(view.pitch, 8);
}

TEST(HostFrame, WordsOf16BitsFillTheirRange) {
  for (unsigned word = 0; word < 65536; ++word) {
    const auto pixel = static_cast<std::uint16_t>(word);
    std::vector<std::uint8_t> rgba;
    to_rgba({&pixel, 1, 1, 2, HostFormat::rgb565}, rgba);
    EXPECT_EQ(rgba[0], std::round((word >> 11) * 255 / 31.0));
    EXPECT_EQ(rgba[1], std::round((word >> 5 & 63) * 255 / 63.0));
    EXPECT_EQ(rgba[2], std::round((word & 31) * 255 / 31.0));
    EXPECT_EQ(rgba[0] >> 3, word >> 11);
    EXPECT_EQ(rgba[1] >> 2, word >> 5 & 63);
    EXPECT_EQ(rgba[2] >> 3, word & 31);
    EXPECT_EQ(rgba[3], 255);
  }
}

}  // namespace
}  // namespace depixel::test
