#include "tests/retroarch/expected.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "filter/frame_filter.hpp"
#include "tests/apps/pictures.hpp"
#include "tests/apps/process.hpp"

namespace depixel::test {
namespace {

/// The highest bits of a channel as a part of the largest value that they have, in 8 bits.
std::uint8_t with_bits(std::uint8_t channel, int bits) {
  const int high = channel >> (8 - bits), largest = (1 << bits) - 1;
  return static_cast<std::uint8_t>((2 * 255 * high + largest) / (2 * largest));
}

/// RetroArch turns 0RGB1555 into RGB565: the highest of green's five bits comes again as the sixth.
std::uint8_t six_bits_of_five(std::uint8_t channel) {
  return static_cast<std::uint8_t>((channel & 0xf8) | (channel >> 7 << 2));
}

int largest_difference(Rgba p, Rgba q) {
  return std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b), std::abs(p.a - q.a)});
}

/// Where the pictures of the running test are left.
std::filesystem::path output_folder() {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  std::string name = fmt::format("{}.{}", test.test_suite_name(), test.name());
  std::replace(name.begin(), name.end(), '/', '_');
  return std::filesystem::path(DEPIXEL_TEST_OUTPUT) / name;
}

}  // namespace

Picture colourful_picture(int width, int height) {
  Picture picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int area = x / 3 * 5 + (y + x / 5) / 2 * 89;
      picture.at(x, y) = {static_cast<std::uint8_t>(area * 37), static_cast<std::uint8_t>(area * 101 >> 1),
                          static_cast<std::uint8_t>(area * 59 >> 2), 255};
    }
  }
  return picture;
}

Picture in_format(const Picture& picture, PixelFormat format) {
  Picture result = picture;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      Rgba& c = result.at(x, y);
      c.a = 255;
      if (format == PixelFormat::xrgb8888) continue;
      if (format == PixelFormat::xrgb1555) c.g = six_bits_of_five(c.g);
      c = {with_bits(c.r, 5), with_bits(c.g, 6), with_bits(c.b, 5), 255};
    }
  }
  return result;
}

Picture enlarged(const Picture& picture, int factor) {
  Picture result(factor * picture.width(), factor * picture.height());
  for (int y = 0; y < result.height(); ++y) {
    for (int x = 0; x < result.width(); ++x) result.at(x, y) = picture.at(x / factor, y / factor);
  }
  return result;
}

Picture turned_left(const Picture& picture) {
  Picture result(picture.height(), picture.width());
  for (int y = 0; y < result.height(); ++y) {
    for (int x = 0; x < result.width(); ++x) result.at(x, y) = picture.at(picture.width() - 1 - y, x);
  }
  return result;
}

int scaled(int side, double scale) {
  return static_cast<int>(std::lround(side * scale));
}

Picture depixelled(const Picture& frame, double scale, const Options& options) {
  Picture drawn(scaled(frame.width(), scale), scaled(frame.height(), scale));
  const auto filter = FrameFilter::cpu();
  auto done = filter->submit(frame.view(), options);
  const View view = View::fit(Lattice(frame.width(), frame.height()), drawn.width(), drawn.height());
  if (done) done = filter->draw(drawn.target(), {0, 0, drawn.width(), drawn.height()}, view);
  if (!done) throw std::runtime_error(done.error().message);
  return drawn;
}

std::string mismatch(const Picture& expected, const Picture& actual, int tolerance) {
  int largest = 0, count = 0;
  const bool same_size = expected.width() == actual.width() && expected.height() == actual.height();
  for (int y = 0; same_size && y < actual.height(); ++y) {
    for (int x = 0; x < actual.width(); ++x) {
      const int difference = largest_difference(expected.at(x, y), actual.at(x, y));
      largest = std::max(largest, difference);
      count += difference > tolerance;
    }
  }
  if (same_size && count == 0 && actual.pixel_count() > 0) return "";
  const std::filesystem::path folder = output_folder();
  std::filesystem::create_directories(folder);
  write_text(folder / "expected.png", png_of(expected));
  if (actual.pixel_count() > 0) write_text(folder / "actual.png", png_of(actual));
  const std::string where = " The pictures are in " + folder.string() + '.';
  if (!same_size) {
    return fmt::format("The picture is {}x{} and not {}x{}.", actual.width(), actual.height(),
                       expected.width(), expected.height()) +
           where;
  }
  return fmt::format("{} pixels differ, channels by up to {}.", count, largest) + where;
}

}  // namespace depixel::test
