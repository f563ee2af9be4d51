#include "bench/quality/consistency.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace depixel::bench {
namespace {

/// What lies this near to the border, in source pixels, is not compared with its shifted copy: what enters
/// changes windows of votes and ends of contours, and sweeps pass that on from node to node.
constexpr int kBorder = 16;
/// The grey below transparent pixels: neither white nor black, which outlines often are.
constexpr int kGrey = 128;

Rgba on_grey(Rgba c) {
  const auto mixed = [&](int value) {
    return static_cast<std::uint8_t>((value * c.a + kGrey * (255 - c.a) + 127) / 255);
  };
  return {mixed(c.r), mixed(c.g), mixed(c.b), 255};
}

std::array<int, 3> channels(Rgba c) {
  return {c.r, c.g, c.b};
}

/// The picture moved right and down; its first column and row are repeated.
Picture shifted(const Picture& picture, int right, int down) {
  Picture out(picture.width(), picture.height());
  for (int y = 0; y < out.height(); ++y) {
    for (int x = 0; x < out.width(); ++x) {
      out.at(x, y) = picture.at(std::max(x - right, 0), std::max(y - down, 0));
    }
  }
  return out;
}

/// Mean absolute difference of two enlarged pictures away from the border, the second of which was drawn of
/// pixels shifted right and down.
double difference_of_shifted(const Picture& still, const Picture& moved, int right, int down, int scale) {
  const int border = kBorder * scale;
  double sum = 0;
  for (int y = border; y < still.height() - border; ++y) {
    for (int x = border; x < still.width() - border; ++x) {
      const auto a = channels(still.at(x, y)), b = channels(moved.at(x + right * scale, y + down * scale));
      for (int c = 0; c < 3; ++c) sum += std::abs(a[c] - b[c]);
    }
  }
  return sum / (3.0 * (still.width() - 2 * border) * (still.height() - 2 * border));
}

}  // namespace

std::vector<SamplePicture> read_samples(const std::vector<std::filesystem::path>& files) {
  std::vector<SamplePicture> samples;
  for (const auto& file : files) {
    Picture picture = read_picture(file);
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) picture.at(x, y) = on_grey(picture.at(x, y));
    }
    samples.push_back({file.stem().string(), std::move(picture)});
  }
  return samples;
}

double reduction_error(const Upscaler& upscaler, const Picture& picture, int scale) {
  const Picture large = upscaler.enlarge(picture, scale);
  double sum = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      std::array<int, 3> total{};
      for (int v = y * scale; v < (y + 1) * scale; ++v) {
        for (int u = x * scale; u < (x + 1) * scale; ++u) {
          const auto found = channels(large.at(u, v));
          for (int c = 0; c < 3; ++c) total[c] += found[c];
        }
      }
      const auto wanted = channels(picture.at(x, y));
      for (int c = 0; c < 3; ++c) sum += std::abs(double(total[c]) / (scale * scale) - wanted[c]);
    }
  }
  return sum / (3.0 * double(picture.pixel_count()));
}

bool has_middle(const Picture& picture) {
  return std::min(picture.width(), picture.height()) > 2 * kBorder;
}

double shift_error(const Upscaler& upscaler, const Picture& picture, int scale) {
  const Picture still = upscaler.enlarge(picture, scale);
  const Picture right = upscaler.enlarge(shifted(picture, 1, 0), scale);
  const Picture below = upscaler.enlarge(shifted(picture, 0, 1), scale);
  return (difference_of_shifted(still, right, 1, 0, scale) +
          difference_of_shifted(still, below, 0, 1, scale)) /
         2;
}

}  // namespace depixel::bench
