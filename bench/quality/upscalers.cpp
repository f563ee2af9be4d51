#include "bench/quality/upscalers.hpp"

#include <fmt/core.h>

#include <array>
#include <stdexcept>
#include <string_view>

#include "bench/common/option_variants.hpp"
#include "bench/peers/libav_scaler.hpp"
#include "bench/peers/xbrz_process.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"
#include "libdepixel/pipeline/verify.hpp"
#include "libdepixel/raster/cpu_raster.hpp"

namespace depixel::bench {
namespace {

/// The rivals are asked for this scale to see what they show in the middle of each pixel.
constexpr int kCentreScale = 3;

/// Enlarges by the largest factors that a scaler has, one after the other.
template <typename Step>
Picture enlarge_in_steps(Picture picture, int scale, Step step) {
  while (scale > 1) {
    int factor = 4;
    while (factor > 1 && scale % factor != 0) --factor;
    if (factor == 1) throw std::runtime_error(fmt::format("The rivals cannot enlarge {} times.", scale));
    picture = step(picture, factor);
    scale /= factor;
  }
  return picture;
}

/// Counts pixels whose colour is not that of the middle one of their 3x3 output pixels.
int count_lost_middles(const Picture& picture, const Picture& large) {
  int lost = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const int middle_x = x * kCentreScale + kCentreScale / 2,
                middle_y = y * kCentreScale + kCentreScale / 2;
      lost += large.at(middle_x, middle_y) != picture.at(x, y);
    }
  }
  return lost;
}

/// A rival that scales by whole factors.
/// \param step  enlarges a picture by a factor of 2, 3 or 4.
template <typename Step>
Upscaler rival(const std::string& name, Step step) {
  const auto enlarge = [step](const Picture& picture, int scale) {
    return enlarge_in_steps(picture, scale, step);
  };
  const auto lost = [step](const Picture& picture) {
    return count_lost_middles(picture, step(picture, kCentreScale));
  };
  return {.name = name, .enlarge = enlarge, .count_lost_centres = lost};
}

Upscaler libav_rival(const std::string& filter) {
  return rival(filter, [filter](const Picture& picture, int factor) {
    LibavScaler scaler(filter, factor, picture.width(), picture.height());
    scaler.load(picture.view());
    scaler.run();
    return scaler.picture();
  });
}

Upscaler xbrz_rival() {
  Upscaler upscaler = rival("xbrzscale", run_xbrzscale);
  if (!has_xbrzscale()) upscaler.missing = "not installed (Debian package xbrzscale)";
  return upscaler;
}

Picture depixel_enlarge(const Picture& picture, int scale, const Options& options) {
  Vectorizer vectorizer;
  CpuRaster raster;
  Picture out(picture.width() * scale, picture.height() * scale);
  const PlanarMap& map = vectorizer.vectorize(picture.view(), options);
  raster.draw(map, View::fit(map.lattice, out.width(), out.height()), options.linear_light, 1, out.target());
  return out;
}

int depixel_lost_centres(const Picture& picture, const Options& options) {
  Vectorizer vectorizer;
  vectorizer.vectorize(picture.view(), options);
  return verify_centres(vectorizer.map(), vectorizer.graph()).lost;
}

Upscaler ours(const std::string& name, const Options& options) {
  return {
      .name = name,
      .is_default = options == Options{},
      .enlarge = [=](const Picture& picture, int scale) { return depixel_enlarge(picture, scale, options); },
      .count_lost_centres = [=](const Picture& picture) { return depixel_lost_centres(picture, options); }};
}

struct NamedSmoothing {
  Smoothing value;
  std::string_view name;
};
constexpr std::array<NamedSmoothing, 3> kSmoothings{
    {{Smoothing::energy, "energy"}, {Smoothing::average, "average"}, {Smoothing::none, "none"}}};

struct NamedSpline {
  SplineKind value;
  std::string_view name;
};
constexpr std::array<NamedSpline, 3> kSplines{{{SplineKind::adaptive, "adaptive"},
                                               {SplineKind::approximate, "approximate"},
                                               {SplineKind::interpolate, "interpolate"}}};

}  // namespace

std::vector<Upscaler> all_upscalers() {
  std::vector<Upscaler> all{rival("nearest", enlarge_nearest), libav_rival("hqx"), libav_rival("xbr"),
                            xbrz_rival()};
  for (const auto& smoothing : kSmoothings) {
    for (const auto& spline : kSplines) {
      Options options;
      options.smoothing = smoothing.value;
      options.spline = spline.value;
      all.push_back(ours(fmt::format("depixel {} {}", smoothing.name, spline.name), options));
    }
  }
  for (const auto& variant : kOptionVariants) {
    all.push_back(ours(fmt::format("depixel {}", variant.name), variant.options()));
  }
  return all;
}

}  // namespace depixel::bench
