#include "filter/host/host_filter.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/guarded_canvas.hpp"

namespace depixel::test {
namespace {

std::vector<std::uint32_t> sample_words(int width, int height) {
  std::vector<std::uint32_t> words;
  for (int i = 0; i < width * height; ++i)
    words.push_back(i % 3 == 0 ? 0xff8040U : i % 5 == 0 ? 0x2040U : 0xffU);
  return words;
}

HostFilter cpu_filter(double scale, int max_width, int max_height, std::vector<std::string>& warnings) {
  HostSettings settings;
  settings.scale = scale;
  settings.backend = HostBackend::cpu;
  return HostFilter(settings, max_width, max_height, [&](const std::string& w) { warnings.push_back(w); });
}

TEST(HostFilter, OutputsAreRoundedAndWithinTheMaximum) {
  std::vector<std::string> warnings;
  const HostFilter filter = cpu_filter(3.33, 100, 50, warnings);
  EXPECT_EQ(filter.output_size(100, 50), (HostFilter::Size{333, 167}));
  EXPECT_EQ(filter.output_size(10, 3), (HostFilter::Size{33, 10}));
  EXPECT_EQ(filter.output_size(1000, 1000), filter.output_size(100, 50));
  EXPECT_EQ(filter.output_size(0, -1), (HostFilter::Size{3, 3}));
}

TEST(HostFilter, WritesInsideThePictureOnly) {
  std::vector<std::string> warnings;
  HostFilter filter = cpu_filter(4, 7, 5, warnings);
  const auto words = sample_words(7, 5);
  GuardedCanvas canvas(28, 20);
  const PictureView target = canvas.target();
  for (int i = 0; i < 2; ++i) {
    filter.draw({words.data(), 7, 5, 28, HostFormat::xrgb8888}, target.pixels,
                static_cast<std::size_t>(target.pitch));
    EXPECT_TRUE(canvas.is_guard_whole());
  }
  EXPECT_EQ(canvas.picture().at(0, 0), (Rgba{0x40, 0x80, 0xff, 255}));  // blue comes first
  EXPECT_TRUE(warnings.empty());
}

TEST(HostFilter, RowsWithoutRoomAreWarnedOfOnce) {
  std::vector<std::string> warnings;
  HostFilter filter = cpu_filter(4, 7, 5, warnings);
  const auto words = sample_words(7, 5);
  std::vector<std::uint8_t> output(28 * 20 * 4, 0x11);
  for (int i = 0; i < 3; ++i)
    filter.draw({words.data(), 7, 5, 28, HostFormat::xrgb8888}, output.data(), 27 * 4);
  EXPECT_EQ(output, std::vector<std::uint8_t>(28 * 20 * 4, 0x11));
  EXPECT_EQ(warnings.size(), 1U);
}

TEST(HostFilter, NothingIsDrawnOfNothing) {
  std::vector<std::string> warnings;
  HostFilter filter = cpu_filter(4, 7, 5, warnings);
  const auto words = sample_words(7, 5);
  std::vector<std::uint8_t> output(28 * 20 * 4, 0x11);
  filter.draw({nullptr, 7, 5, 28, HostFormat::xrgb8888}, output.data(), 112);
  filter.draw({words.data(), 0, 5, 28, HostFormat::xrgb8888}, output.data(), 112);
  filter.draw({words.data(), 7, 0, 28, HostFormat::xrgb8888}, output.data(), 112);
  filter.draw({words.data(), 7, 5, 28, HostFormat::xrgb8888}, nullptr, 112);
  EXPECT_EQ(output, std::vector<std::uint8_t>(28 * 20 * 4, 0x11));
}

}  // namespace
}  // namespace depixel::test
