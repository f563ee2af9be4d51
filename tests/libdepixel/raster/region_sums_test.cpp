#include "libdepixel/raster/region_sums.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "libdepixel/pipeline/vectorizer.hpp"
#include "libdepixel/raster/cpu_raster.hpp"
#include "tests/support/map_segments.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

Picture draw_shaded(const PlanarMap& map, const View& view, int width, int height, bool linear_light,
                    int threads = 1) {
  Picture out(width, height, {1, 2, 3, 4});
  CpuRaster().draw(map, view, linear_light, threads, out.target());
  return out;
}

rc::Gen<Options> random_shaded_options() {
  return rc::gen::map(random_options(), [](Options options) {
    if (options.shading == ShadingKind::none) options.shading = ShadingKind::gradient;
    return options;
  });
}

double random_scale() {
  return *rc::gen::element(0.5, 1.0, 2.0, 2.7, 3.0, 4.0);
}

RC_GTEST_PROP(RegionSums, EvenMapsAreDrawnToTheSameBits, (const Picture& picture)) {
  const Options options = *random_options();
  PlanarMap map = vectorized(picture, options);
  map.shading = {};
  const View view{random_scale(), random_scale(), *rc::gen::element(-2.5, 0.0, 1.3),
                  *rc::gen::element(-1.0, 0.0, 0.7)};
  const Picture even = draw_shaded(map, view, 43, 35, options.linear_light);
  // All blocks are said to be shaded, each pixel with its own region's colour.
  map.shading.any = true;
  map.shading.shades = map.colours;
  map.shading.blocks.assign(map.lattice.size(), Shading::kShaded);
  RC_ASSERT(draw_shaded(map, view, 43, 35, options.linear_light, *rc::gen::element(1, 3)) == even);
}

RC_GTEST_PROP(RegionSums, CentresHaveTheirPixelsOwnColour, (const Picture& picture)) {
  // Curves keep away from centres by more than half the diagonal of a fifteenth of a pixel.
  Options options = *random_shaded_options();
  options.shading = ShadingKind::gradient;
  options.dither = DitherKind::keep;
  const PlanarMap map = vectorized(picture, options);
  const Picture out =
      draw_shaded(map, {15, 15, 0, 0}, 15 * picture.width, 15 * picture.height, options.linear_light);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      RC_ASSERT(out.at(15 * x + 7, 15 * y + 7) == normalized(picture.at(x, y)));
    }
  }
}

/// The colour of a region at a place, in floating point, from what Shading says of it.
std::array<double, 4> naive_colour(const PlanarMap& map, Rgba region, double x, double y) {
  if (!map.shading.any) return {double(region.r), double(region.g), double(region.b), double(region.a)};
  const Lattice& lattice = map.lattice;
  const int column = std::clamp(static_cast<int>(std::floor(x + 0.5)), 0, lattice.width());
  const int row = std::clamp(static_cast<int>(std::floor(y + 0.5)), 0, lattice.height());
  // A region may lie where only pixels beyond the nearest row and column are its own: none weighs nothing.
  const auto weight_after = [](double at) {
    constexpr double kLeast = 1.0 / 4096;
    return std::clamp(at + 0.5 - std::floor(at + 0.5), kLeast, 1 - kLeast);
  };
  const double east = weight_after(x), south = weight_after(y);
  const int block = lattice.corner(column, row);
  struct Corner {
    int pixel;
    double weight;
    std::map<int, int> pairs;  ///< bit of the pair, by the other pixel
  };
  const std::array<Corner, 4> corners{
      {{block, (1 - east) * (1 - south), {{1, kNorthPair}, {2, kWestPair}, {3, kMainPair}}},
       {block + 1, east * (1 - south), {{0, kNorthPair}, {2, kAntiPair}, {3, kEastPair}}},
       {block + lattice.stride(), (1 - east) * south, {{0, kWestPair}, {1, kAntiPair}, {3, kSouthPair}}},
       {block + lattice.stride() + 1, east * south, {{0, kMainPair}, {1, kEastPair}, {2, kSouthPair}}}}};
  const auto is_own = [&](int k) { return map.colours[corners[k].pixel] == region; };
  std::array<double, 4> sum{};
  double weights = 0;
  for (int k = 0; k < 4; ++k) {
    bool takes_part = is_own(k);
    for (const auto& [other, bit] : corners[k].pairs)
      takes_part |= is_own(other) && (map.shading.blocks[block] & bit) != 0;
    if (!takes_part || map.shading.blocks[block] == 0) continue;
    const Rgba c = map.shading.shades[corners[k].pixel];
    const std::array<int, 4> levels{c.r, c.g, c.b, c.a};
    const double weight = corners[k].weight;
    for (int i = 0; i < 4; ++i) sum[i] += weight * levels[i];
    weights += weight;
  }
  if (weights == 0) return {double(region.r), double(region.g), double(region.b), double(region.a)};
  for (double& channel : sum) channel /= weights;
  return sum;
}

RC_GTEST_PROP(RegionSums, PixelsAreTheMeanOfTheirRegions, ()) {
  // How much of a pixel each region covers is what its map in two greys shows; with room on either side, for
  // curves may overlap by a hair.
  constexpr std::uint8_t kDark = 32, kLight = 224;
  const Picture picture = *random_picture({.max_size = 8, .colours = "456rb"});
  const Options options = *random_shaded_options();
  const PlanarMap map = vectorized(picture, options);
  const double scale = random_scale();
  const View view{scale, scale, 0, 0};
  const int width = static_cast<int>(picture.width * scale),
            height = static_cast<int>(picture.height * scale);
  if (width == 0 || height == 0) return;
  std::vector<std::array<double, 4>> expected(std::size_t(width) * height);
  std::map<std::uint32_t, Rgba> regions;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const Rgba c = map.colours[map.lattice.pixel(x, y)];
      regions.emplace(rgba_order(c), c);
    }
  }
  for (const auto& [order, region] : regions) {
    PlanarMap covered = map;
    covered.shading = {};
    for (Rgba& c : covered.colours)
      c = c == region ? Rgba{kLight, kLight, kLight, 255} : Rgba{kDark, kDark, kDark, 255};
    const Picture coverage = draw_shaded(covered, view, width, height, false);
    for (int i = 0; i < width * height; ++i) {
      const int x = i % width, y = i / width;
      const auto colour = naive_colour(map, region, (x + 0.5) / scale, (y + 0.5) / scale);
      for (int k = 0; k < 4; ++k)
        expected[i][k] += colour[k] * (coverage.pixels[i].r - kDark) / double(kLight - kDark);
    }
  }
  const Picture out = draw_shaded(map, view, width, height, false);
  // Half a level of the greys for each coverage, and half a level for shades, their mixture and sums.
  const double rounding = 0.5 * 255 / (kLight - kDark) * double(regions.size()) + 1.5;
  for (int i = 0; i < width * height; ++i) {
    const Rgba c = out.pixels[i];
    const std::array<int, 4> levels{c.r, c.g, c.b, c.a};
    for (int k = 0; k < 4; ++k)
      RC_ASSERT(std::abs(levels[k] - std::clamp(expected[i][k], 0.0, 255.0)) <= rounding);
  }
}

}  // namespace
}  // namespace depixel::test
