#include "bench/gl/gl_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>

namespace depixel::bench {
namespace {

int premultiplied(int channel, int alpha) {
  return (channel * alpha + 127) / 255;
}

void add(GlComparison& comparison, const Picture& ours, const Picture& theirs) {
  std::int64_t sum = 0;
  for (int y = 0; y < ours.height(); ++y) {
    for (int x = 0; x < ours.width(); ++x) {
      const Rgba a = ours.at(x, y), b = theirs.at(x, y);
      for (const int off : {premultiplied(a.r, a.a) - premultiplied(b.r, b.a),
                            premultiplied(a.g, a.a) - premultiplied(b.g, b.a),
                            premultiplied(a.b, a.a) - premultiplied(b.b, b.a), a.a - b.a}) {
        sum += std::abs(off);
        comparison.worst_pixel = std::max(comparison.worst_pixel, std::abs(off));
      }
    }
  }
  comparison.worst_mean = std::max(comparison.worst_mean, double(sum) / (4.0 * double(ours.pixel_count())));
  ++comparison.views;
}

}  // namespace

GlComparison compare(GlTimer& timer, const std::vector<std::filesystem::path>& files) {
  std::vector<View> views{{3.7, 2.9, -3.3, 5.21}, {5, 5, 10.4, 7.7}};
  for (const double scale : {1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 7.3}) views.push_back({scale, scale, 0, 0});
  const auto side = [](int size, double scale) { return static_cast<int>(std::lround(size * scale)); };
  const auto cpu = FrameFilter::cpu();
  GlComparison comparison;
  for (const auto& file : files) {
    const Picture frame = read_picture(file);
    for (const View& view : views) {
      Picture ours(side(frame.width(), view.scale_x), side(frame.height(), view.scale_y));
      Picture theirs(ours.width(), ours.height());
      timer.draw(frame.view(), view, ours);
      const Viewport whole{0, 0, theirs.width(), theirs.height()};
      if (!cpu->submit(frame.view(), {}) || !cpu->draw(theirs.target(), whole, view)) {
        throw std::runtime_error("The processor does not draw " + file.string() + ".");
      }
      add(comparison, ours, theirs);
    }
  }
  return comparison;
}

}  // namespace depixel::bench
