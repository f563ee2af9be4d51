#include "bench/common/generated.hpp"

#include <algorithm>
#include <random>

namespace depixel::bench {
namespace {

constexpr Rgba kBlack{0, 0, 0, 255}, kWhite{255, 255, 255, 255};
constexpr int kSeed = 1;

template <typename ColourAt>
Picture make_picture(int width, int height, ColourAt colour_at) {
  Picture picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) picture.at(x, y) = colour_at(x, y);
  }
  return picture;
}

}  // namespace

Picture checkerboard(int width, int height) {
  return make_picture(width, height, [](int x, int y) { return (x + y) % 2 ? kWhite : kBlack; });
}

Picture colour_noise(int width, int height) {
  std::mt19937 random(kSeed);
  return make_picture(width, height, [&](int, int) {
    const auto bits = random();
    return Rgba{std::uint8_t(bits), std::uint8_t(bits >> 8), std::uint8_t(bits >> 16), 255};
  });
}

Picture two_colour_noise(int width, int height) {
  std::mt19937 random(kSeed);
  return make_picture(width, height, [&](int, int) { return random() >> 31 ? kWhite : kBlack; });
}

Picture dithered_gradient(int width, int height) {
  // Errors carried to this row and the next, in 1/16 levels, with a margin of one on either side.
  std::vector<int> here(std::size_t(width) + 2), below(here.size());
  Picture picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t i = std::size_t(x) + 1;
      const int wanted = 255 * (x + y) / (width + height - 2) + here[i] / 16;
      const bool white = wanted > 127;
      const int error = wanted - (white ? 255 : 0);
      picture.at(x, y) = white ? kWhite : kBlack;
      here[i + 1] += 7 * error;
      below[i - 1] += 3 * error;
      below[i] += 5 * error;
      below[i + 1] += error;
    }
    here.swap(below);
    std::fill(below.begin(), below.end(), 0);
  }
  return picture;
}

Picture tile(std::span<const Picture> frames, int width, int height) {
  Picture picture(width, height);
  std::size_t next = 0;
  for (int top = 0, row_height = 0; top < height; top += row_height) {
    row_height = height - top;
    for (int left = 0; left < width;) {
      const Picture& frame = frames[next++ % frames.size()];
      row_height = std::min(row_height, frame.height());
      const int rows = std::min(frame.height(), height - top),
                columns = std::min(frame.width(), width - left);
      for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) picture.at(left + x, top + y) = frame.at(x, y);
      }
      left += frame.width();
    }
  }
  return picture;
}

}  // namespace depixel::bench
