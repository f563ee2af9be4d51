#include "libdepixel/svg/svg_shading.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string_view>

#include "libdepixel/pipeline/vectorizer.hpp"
#include "libdepixel/raster/cpu_raster.hpp"
#include "libdepixel/svg/svg_writer.hpp"
#include "tests/support/svg_tools.hpp"
#include "tests/support/test_pictures.hpp"

namespace depixel::test {
namespace {

constexpr int kShadedAt = 8;

/// A picture with shaded regions, as the rasteriser draws it, and as SVG.
struct Shaded {
  std::string name;
  Picture raster;
  std::string svg;
  std::string flat_svg;  ///< without what makes colours run

  Shaded(std::string_view of, const char* kind, const Picture& picture, const Options& options)
      : name(std::string(of) + " " + kind) {
    Vectorizer vectorizer;
    const PlanarMap& map = vectorizer.vectorize(picture.view(), options);
    raster = Picture(picture.width * kShadedAt, picture.height * kShadedAt);
    CpuRaster().draw(map, View::fit(map.lattice, raster.width, raster.height), false, 1, raster.target());
    raster = premultiplied(raster);
    svg = write_svg(map, vectorizer.graph());
    flat_svg = svg.substr(0, svg.find("<g id=\"shading\">")) + "</svg>\n";
  }
  double error(const Picture& drawn) const { return compare(raster, premultiplied(drawn)).mean; }
};

/// Gradients, blurs and soft contours, all within clips.
std::vector<Shaded> shaded_pictures() {
  std::vector<Shaded> pictures;
  for (const char* file : {"minetest_game_default_apple.png", "minetest_game_bucket_lava.png"}) {
    const auto add = [&](const char* kind, const Options& options) {
      pictures.emplace_back(file, kind, load_picture(data_folder() / "sprites" / file), options);
    };
    add("gradient", {.similarity = Similarity::merge, .merge_luma = 48, .shading = ShadingKind::gradient});
    add("discs", {.similarity = Similarity::merge, .merge_luma = 48, .shading = ShadingKind::discs});
    add("blur", {.similarity = Similarity::merge, .merge_luma = 48, .shading = ShadingKind::blur});
    add("soft", {.soft_contours = 40});
  }
  return pictures;
}

/// Strips, discs and blurred squares come near to the raster's mixtures, and nearer than components of one
/// colour do.
constexpr double kMostError = 3.0, kPartOfFlat = 0.75;
/// Edges take most of it; where all is of one colour it is 0.4.
constexpr double kMostErrorOfGradients = 0.65;

TEST(SvgShading, RsvgDrawsItNearly) {
  for (const Shaded& shaded : shaded_pictures()) {
    const auto drawn = [&](const std::string& svg) {
      return draw_with_rsvg(svg, shaded.raster.width, shaded.raster.height);
    };
    EXPECT_LT(shaded.error(drawn(shaded.svg)), kMostError) << shaded.name;
    EXPECT_LT(shaded.error(drawn(shaded.svg)), kPartOfFlat * shaded.error(drawn(shaded.flat_svg)))
        << shaded.name;
  }
}

TEST(SvgShading, ChromiumDrawsItNearly) {
  if (!has_chromium()) GTEST_SKIP() << "there is no chromium; Debian's package is called so";
  const std::vector<Shaded> pictures = shaded_pictures();
  std::vector<SvgToDraw> documents;
  for (const Shaded& shaded : pictures) {
    documents.push_back({shaded.svg, shaded.raster.width, shaded.raster.height});
    documents.push_back({shaded.flat_svg, shaded.raster.width, shaded.raster.height});
  }
  const std::vector<Picture> drawn = draw_with_chromium(documents);
  ASSERT_EQ(drawn.size(), documents.size());
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    EXPECT_LT(pictures[i].error(drawn[2 * i]), kMostError) << pictures[i].name;
    EXPECT_LT(pictures[i].error(drawn[2 * i]), kPartOfFlat * pictures[i].error(drawn[2 * i + 1]))
        << pictures[i].name;
  }
}

Picture part_of(const Picture& picture, glm::ivec2 from, glm::ivec2 size) {
  Picture part(size.x, size.y);
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) part.at(x, y) = picture.at(from.x + x, from.y + y);
  }
  return part;
}

/// Gradients mix as the raster does: nothing shows through round what lies on them, nothing reaches other
/// shapes, and lines stay straight.
TEST(SvgShading, GradientsAreAsInTheRaster) {
  const Picture frame = load_picture(data_folder() / "frames/davegnukem_0052.png");
  const Options merged{.similarity = Similarity::merge, .merge_luma = 48, .shading = ShadingKind::gradient};
  const Options connected{.connect_lines = true, .shading = ShadingKind::gradient};
  const std::array<Shaded, 3> pictures{
      {{"word", "merged", part_of(frame, {228, 4}, {60, 30}), merged},
       {"windows", "merged", part_of(frame, {0, 0}, {60, 60}), merged},
       {"camera", "connected", part_of(frame, {172, 28}, {52, 40}), connected}}};
  for (const Shaded& shaded : pictures) {
    const Picture drawn = draw_with_rsvg(shaded.svg, shaded.raster.width, shaded.raster.height);
    EXPECT_LT(shaded.error(drawn), kMostErrorOfGradients) << shaded.name;
  }
}

/// Rows that look the same share their gradient.
TEST(SvgShading, GradientsTakeOneStripARow) {
  Picture ramp(8, 3);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 8; ++x) {
      const auto level = static_cast<std::uint8_t>(100 + 4 * x);
      ramp.at(x, y) = {level, level, level, 255};
    }
  }
  Vectorizer vectorizer;
  vectorizer.vectorize(ramp.view(),
                       Options{.similarity = Similarity::merge, .shading = ShadingKind::gradient});
  const std::string svg = write_svg(vectorizer.map(), vectorizer.graph());
  const auto count = [&](std::string_view what) {
    int found = 0;
    for (std::size_t at = 0; (at = svg.find(what, at)) != std::string::npos; ++at) ++found;
    return found;
  };
  EXPECT_EQ(count("<linearGradient id=\"s"), 1);
  EXPECT_EQ(count("fill=\"url(#s0)\""), 3);
}

/// One clipping path will do for colours that all run into each other.
TEST(SvgShading, BlendingComponentsShareAClip) {
  Picture ramp(12, 12);
  for (int y = 0; y < 12; ++y) {
    for (int x = 0; x < 12; ++x) {
      const auto level = static_cast<std::uint8_t>(100 + 2 * x + 2 * y);
      ramp.at(x, y) = {level, level, level, 255};
    }
  }
  Vectorizer vectorizer;
  vectorizer.vectorize(ramp.view(), Options{.soft_contours = 20});
  const std::string svg = write_svg(vectorizer.map(), vectorizer.graph());
  EXPECT_NE(svg.find("<clipPath"), std::string::npos);
  EXPECT_EQ(svg.find("<clipPath"), svg.rfind("<clipPath"));
}

}  // namespace
}  // namespace depixel::test
