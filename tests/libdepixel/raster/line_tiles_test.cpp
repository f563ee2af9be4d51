#include "libdepixel/raster/line_tiles.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "libdepixel/pipeline/vectorizer.hpp"
#include "tests/support/ascii_picture.hpp"
#include "tests/support/map_sampler.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

using Sum = std::array<int, 4>;

void add(Sum& sum, const TileColour& change, int times) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += times * change[i];
}

/// The colour at a place in a tile, as Tile says: a walk from its top left down its left side, then east.
Sum colour_at(const LineTiles& tiles, const Tile& tile, double x, double y) {
  Sum sum{};
  add(sum, tile.colour, 1);
  for (std::uint32_t i = tile.first; i < tile.first + tile.count; ++i) {
    const TileLine& line = tiles.lines()[i];
    if (line.x0 == 0 && line.y0 < y) add(sum, line.change, -1);
    if (line.x1 == 0 && line.y1 < y) add(sum, line.change, 1);
    if ((line.y0 < y) == (line.y1 < y)) continue;
    const double crossing = line.x0 + (line.x1 - line.x0) * (y - line.y0) / double(line.y1 - line.y0);
    if (crossing < x) add(sum, line.change, line.y0 < y ? 1 : -1);
  }
  return sum;
}

/// Mean colour of an output pixel, 0..255, from places on a grid.
glm::dvec4 mean_of_pixel(const LineTiles& tiles, int scale, int x, int y) {
  constexpr int kPlacesAcross = 12;
  const Tile& tile = tiles.tiles()[std::size_t(y / scale) * tiles.width() + x / scale];
  const auto place = [&](int pixel, int i) {
    return (pixel % scale + (i + 0.5) / kPlacesAcross) * kTileUnits / scale + 0.1;
  };
  glm::dvec4 mean(0);
  for (int i = 0; i < kPlacesAcross * kPlacesAcross; ++i) {
    const Sum sum = colour_at(tiles, tile, place(x, i % kPlacesAcross), place(y, i / kPlacesAcross));
    mean += glm::dvec4(sum[0], sum[1], sum[2], sum[3]) / (128.0 * kPlacesAcross * kPlacesAcross);
  }
  return mean;
}

LineTiles cut(const Picture& picture, const Options& options, double scale) {
  Vectorizer vectorizer;
  LineTiles tiles;
  tiles.build(vectorizer.vectorize(picture.view(), options), {scale, scale},
              options.linear_light ? TileEncoding::light : TileEncoding::levels);
  return tiles;
}

TEST(LineTiles, StraightSidesLeaveNoLines) {
  const LineTiles tiles =
      cut(ascii_picture({"####", "#rr#", "#rr#", "####"}), {.smoothing = Smoothing::none}, 4);
  EXPECT_EQ(tiles.width(), 4);
  EXPECT_EQ(tiles.height(), 4);
  for (const int inner : {1 * 4 + 1, 2 * 4 + 2}) EXPECT_LE(tiles.tiles()[inner].count, 4u);
  EXPECT_EQ(tiles.tiles()[0].count, 0u);
}

RC_GTEST_PROP(LineTiles, CentresHaveTheirColour, ()) {
  const Picture picture = *random_picture({.max_size = 12});
  Options options = *random_lossless_options();
  options.linear_light = false;
  const LineTiles tiles = cut(picture, options, *rc::gen::element(0.5, 1.0, 2.7, 4.0, 33.0));
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const Tile& tile = tiles.tiles()[std::size_t(y) * tiles.width() + x];
      const Rgba c = normalized(picture.at(x, y));
      const Sum found = colour_at(tiles, tile, 0.5 * kTileUnits + 0.5, 0.5 * kTileUnits + 0.5);
      RC_ASSERT(found[3] == 128 * c.a);
      if (c.a == 255) RC_ASSERT((found == Sum{128 * c.r, 128 * c.g, 128 * c.b, 128 * 255}));
    }
  }
}

RC_GTEST_PROP(LineTiles, PixelsHaveTheMeanOfTheMap, ()) {
  constexpr double kTolerance =
      255.0 * (kFlatteningTolerance + 2.0 / 12);  // and a row of places on two edges
  const int scale = *rc::gen::element(1, 2, 4);
  const Picture picture = *random_picture({.max_size = 10});
  Vectorizer vectorizer;
  LineTiles tiles;
  const double out = scale;
  tiles.build(vectorizer.vectorize(picture.view(), *random_options()), {out, out}, TileEncoding::levels);
  const int width = picture.width * scale, height = picture.height * scale;
  const auto expected = sampled(vectorizer.map(), {out, out, 0, 0}, false, width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::dvec4 off = mean_of_pixel(tiles, scale, x, y) - expected[std::size_t(y) * width + x];
      for (int i = 0; i < 4; ++i) RC_ASSERT(std::abs(off[i]) <= kTolerance);
    }
  }
}

RC_GTEST_PROP(LineTiles, BuffersLeaveNoTrace, ()) {
  const Picture first = *random_picture({}), second = *random_picture({});
  Vectorizer vectorizer;
  LineTiles warm;
  warm.build(vectorizer.vectorize(first.view(), {}), {3, 3}, TileEncoding::light);
  warm.build(vectorizer.vectorize(second.view(), {}), {4, 5}, TileEncoding::levels);
  LineTiles fresh;
  fresh.build(vectorizer.map(), {4, 5}, TileEncoding::levels);
  const auto bytes = [](const auto& values) { return std::as_bytes(std::span(values)); };
  RC_ASSERT(std::ranges::equal(bytes(warm.tiles()), bytes(fresh.tiles())));
  RC_ASSERT(std::ranges::equal(bytes(warm.lines()), bytes(fresh.lines())));
}

}  // namespace
}  // namespace depixel::test
