#include "libdepixel/svg/svg_writer.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <set>
#include <utility>

#include "libdepixel/pipeline/vectorizer.hpp"
#include "libdepixel/raster/cpu_raster.hpp"
#include "tests/support/random_pictures.hpp"
#include "tests/support/svg_tools.hpp"
#include "tests/support/test_pictures.hpp"

namespace depixel::test {
namespace {

constexpr int kDrawnAt = 8;

struct Written {
  Vectorizer vectorizer;
  std::string svg;
  pugi::xml_document document;
  std::vector<SvgPath> paths;

  explicit Written(const Picture& picture, const Options& options = {}, double tolerance_px = kSvgTolerance) {
    vectorizer.vectorize(picture.view(), options);
    svg = write_svg(vectorizer.map(), vectorizer.graph(), tolerance_px);
    document.load_string(svg.c_str());
    paths = filled_paths(document);
  }

  Picture raster() const {
    const Lattice& lattice = vectorizer.map().lattice;
    Picture picture(lattice.width() * kDrawnAt, lattice.height() * kDrawnAt);
    CpuRaster().draw(vectorizer.map(), View::fit(lattice, picture.width, picture.height), false, 1,
                     picture.target());
    return picture;
  }
};

std::string hex(Rgba c) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", c.r, c.g, c.b);
  return text.data();
}

TEST(SvgNumbers, AreShort) {
  const auto written = [](int thousandths) {
    std::string text;
    append_svg_number(text, thousandths);
    return text;
  };
  EXPECT_EQ(written(0), "0");
  EXPECT_EQ(written(1000), "1");
  EXPECT_EQ(written(-1000), "-1");
  EXPECT_EQ(written(1500), "1.5");
  EXPECT_EQ(written(-250), "-.25");
  EXPECT_EQ(written(7), ".007");
  EXPECT_EQ(written(120040), "120.04");
}

TEST(SvgPathData, RoundsPointsBeforeDifferences) {
  std::string text;
  SvgPathData path(text);
  path.move_to({0, kSubpixels});
  path.line_to({kSubpixels / 2, kSubpixels});
  for (int i = 1; i <= 3; ++i) path.line_to({kSubpixels / 2 + i, kSubpixels});
  path.curve_to({kSubpixels, kSubpixels}, {kSubpixels, 2 * kSubpixels}, {2 * kSubpixels, 2 * kSubpixels});
  path.close();
  EXPECT_EQ(text, "M0 1h.501c.499 0 .499 1 1.499 1z");
}

std::string path_data(const std::function<void(SvgPathData&)>& draw, SvgGrid grid = {}) {
  std::string text;
  SvgPathData path(text, grid);
  draw(path);
  return text;
}

constexpr int kPixel = kSubpixels;

TEST(SvgPathData, LinesThatGoOnAreOne) {
  EXPECT_EQ(path_data([](SvgPathData& path) {
              path.move_to({0, 0});
              for (int x = 1; x <= 3; ++x) path.line_to({x * kPixel, 0});
              path.line_to({2 * kPixel, 0});  // and back
              path.line_to({3 * kPixel, kPixel});
              path.line_to({5 * kPixel, 3 * kPixel});
              path.line_to({0, 3 * kPixel});
              path.line_to({0, 0});
              path.close();
            }),
            "M0 0h3-1l3 3h-5z");
}

TEST(SvgPathData, SmoothAndQuadraticCurvesAreWrittenAsSuch) {
  EXPECT_EQ(path_data([](SvgPathData& path) {
              path.move_to({0, 0});
              path.curve_to({0, kPixel}, {kPixel, 2 * kPixel}, {2 * kPixel, 2 * kPixel});
              path.curve_to({3 * kPixel, 2 * kPixel}, {4 * kPixel, kPixel}, {4 * kPixel, 0});
              path.curve_to({4 * kPixel, -2 * kPixel}, {5 * kPixel, -3 * kPixel}, {7 * kPixel, -3 * kPixel});
              path.curve_to({9 * kPixel, -3 * kPixel}, {10 * kPixel, -2 * kPixel}, {10 * kPixel, 0});
              path.end();
            }),
            "M0 0c0 1 1 2 2 2s2-1 2-2q0-3 3-3t3 3");
}

TEST(SvgPathData, NumbersAreSeparatedOnlyWhereTheyMustBe) {
  EXPECT_EQ(path_data(
                [](SvgPathData& path) {
                  path.move_to({kPixel / 2, kPixel / 4});
                  path.line_to({kPixel, kPixel});
                  path.line_to({3 * kPixel, kPixel * 3 / 2});
                  path.close();
                  path.move_to({kPixel, -kPixel});
                  path.line_to({2 * kPixel, kPixel});
                  path.end();
                },
                SvgGrid{10}),
            "M.5.25l.5.75 2 .5zm.5-1.25 1 2");
}

TEST(SvgWriter, ColoursAreSaidOnce) {
  const Written written(ascii_picture({"#r#", "...", "#g#"}));
  EXPECT_EQ(written.document.select_nodes("//path[@fill='#000']").size(), 1u);
  EXPECT_EQ(written.document.select_nodes("//path[@fill='#dc1e1e']").size(), 1u);
  EXPECT_EQ(written.document.select_nodes("//path[@fill='#fff']").size(), 1u);
}

TEST(SvgWriter, ToleranceMakesFilesSmallerAndPicturesNoWorse) {
  constexpr double kMostDifference = 0.3, kMostBytes = 0.4;
  const Picture picture = load_picture(data_folder() / "frames" / "alex4_0036.png");
  const Written exact(picture, {}, 0), simplified(picture);
  EXPECT_LT(double(simplified.svg.size()), kMostBytes * double(exact.svg.size()));
  const int width = picture.width * kDrawnAt, height = picture.height * kDrawnAt;
  const Picture expected = draw_with_rsvg(exact.svg, width, height);
  EXPECT_LT(compare(expected, draw_with_rsvg(simplified.svg, width, height)).mean, kMostDifference);
}

TEST(SvgWriter, MeasuresInSourcePixels) {
  const Written written(ascii_picture({"##..", "##..", "...."}));
  const pugi::xml_node svg = written.document.child("svg");
  EXPECT_STREQ(svg.attribute("viewBox").value(), "0 0 4 3");
  EXPECT_STREQ(svg.attribute("width").value(), "4");
  EXPECT_STREQ(svg.attribute("height").value(), "3");
}

TEST(SvgWriter, DrawsOpaqueShapesTwiceAndOthersOnce) {
  const Written written(ascii_picture({"##__", "##RR", "..RR"}));
  ASSERT_EQ(written.paths.size(), 3u);  // the transparent component is not drawn
  EXPECT_EQ(
      std::count_if(written.paths.begin(), written.paths.end(), [](const SvgPath& p) { return p.in_defs; }),
      2);
  const auto uses = written.document.select_nodes("//use[@*='#shapes']");
  ASSERT_EQ(uses.size(), 2u);
  EXPECT_STREQ(uses[0].node().attribute("shape-rendering").value(), "crispEdges");
  EXPECT_STREQ(uses[0].node().attribute("mask").value(), "url(#inside)");
  EXPECT_STREQ(uses[1].node().attribute("shape-rendering").value(), "");
  EXPECT_STREQ(uses[1].node().attribute("mask").value(), "");
  EXPECT_EQ(written.document.select_nodes("//path[@fill-opacity='.502']").size(), 1u);
}

TEST(SvgWriter, MasksOnlyWhatHasASilhouette) {
  const Written all_opaque(ascii_picture({"##..", "####", "...."}));
  EXPECT_TRUE(all_opaque.document.select_nodes("//mask").empty());
  EXPECT_TRUE(all_opaque.document.select_nodes("//use[@mask]").empty());
  EXPECT_EQ(all_opaque.document.select_nodes("//use").size(), 2u);
  const Written nothing(ascii_picture({"__", "__"}));
  EXPECT_TRUE(nothing.document.select_nodes("//mask").empty());
}

RC_GTEST_PROP(SvgWriter, OnePathAColour, (const Picture& picture)) {
  const Written written(picture, *random_options());
  Components components;
  label_components(written.vectorizer.graph(), components);
  find_majority_colours(written.vectorizer.graph(), components);
  std::set<std::uint32_t> visible;
  for (const Rgba c : components.colour) {
    if (c.a > 0) visible.insert(rgba_order(c));
  }
  RC_ASSERT(written.paths.size() == visible.size());
}

RC_GTEST_PROP(SvgWriter, AreasAddUpToTheFrameToTheLastDigit, ()) {
  const Picture picture = *random_picture({.colours = ".#rgb4567R"});
  std::int64_t area = 0;
  const double tolerance_px = *rc::gen::element(0.0, kSvgTolerance, kMaxSvgTolerance);
  for (const SvgPath& path : Written(picture, *random_options(), tolerance_px).paths) area += path.area_60;
  RC_ASSERT(area == std::int64_t{60'000'000} * picture.width * picture.height);
}

RC_GTEST_PROP(SvgWriter, PixelCentresHaveTheirColour, ()) {
  const Picture picture = *random_picture({.max_size = 12});
  const Written written(picture, *random_lossless_options(), *rc::gen::element(0.0, kSvgTolerance));
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      std::vector<std::string> found;
      for (const SvgPath& path : written.paths) {
        if (is_inside(glm::dvec2(x, y) + 0.5, path.polygons)) found.push_back(path.fill);
      }
      const Rgba colour = normalized(picture.at(x, y));
      RC_ASSERT(found == (colour.a == 0 ? std::vector<std::string>{} : std::vector{hex(colour)}));
    }
  }
}

/// True in the source pixels round one that is neither opaque nor transparent, where alpha may be rounded up
/// to opaque, and beside output pixels that are not covered wholly: curves may stray half a pixel from there.
bool may_be_seen_through(const Picture& picture, const Picture& raster, int x, int y) {
  const int u = x / kDrawnAt, v = y / kDrawnAt;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (raster.contains(x + dx, y + dy) && raster.at(x + dx, y + dy).a != 255) return true;
      if (!picture.contains(u + dx, v + dy)) continue;
      const int alpha = picture.at(u + dx, v + dy).a;
      if (alpha > 0 && alpha < 255) return true;
    }
  }
  return false;
}
static_assert(kDrawnAt * kSvgTolerance <= 0.5);

/// Empty if rsvg-convert's picture is what the rasteriser's is, else what differs.
std::string rsvg_mismatch(const Picture& picture, const Options& options, double mean_tolerance = 2.0,
                          double svg_tolerance_px = kSvgTolerance) {
  const Written written(picture, options, svg_tolerance_px);
  const Picture expected = written.raster();
  const Picture drawn = draw_with_rsvg(written.svg, expected.width, expected.height);
  if (drawn.width == 0) return "rsvg-convert fails on " + written.svg;
  const PictureDifference difference = compare(premultiplied(expected), premultiplied(drawn));
  if (difference.mean > mean_tolerance) return "mean difference " + std::to_string(difference.mean);
  for (int y = 0; y < expected.height; ++y) {
    for (int x = 0; x < expected.width; ++x) {
      if (drawn.at(x, y).a == 255 || may_be_seen_through(picture, expected, x, y)) continue;
      return "see-through at " + std::to_string(x) + ", " + std::to_string(y);
    }
  }
  return "";
}

/// The middle of a picture: enough to see of a whole frame.
Picture middle(const Picture& picture) {
  Picture part(std::min(picture.width, 160), std::min(picture.height, 100));
  paste(part, picture, (part.width - picture.width) / 2, (part.height - picture.height) / 2);
  return part;
}

TEST(SvgWriter, RsvgDrawsRealPicturesAsTheRasterDoes) {
  for (const char* folder : {"sprites", "frames"}) {
    for (const auto& file : std::filesystem::directory_iterator(data_folder() / folder)) {
      EXPECT_EQ(rsvg_mismatch(middle(load_picture(file.path())), {}), "") << file.path();
    }
  }
}

/// Blending two shapes that share a pixel misses their exact sum by up to a quarter of their contrast, and of
/// pictures of a few pixels, most are shared.
RC_GTEST_PROP(SvgWriter, RsvgDrawsSmallPicturesNearly, ()) {
  constexpr double kMeanTolerance = 4.0;
  const Picture picture = *random_picture({.colours = "._#rgb4567"});
  Options options = *random_options();
  options.shading = ShadingKind::none;
  options.soft_contours = 0;
  const std::string mismatch = rsvg_mismatch(picture, options, kMeanTolerance);
  if (!mismatch.empty()) RC_FAIL(mismatch);
}

TEST(SvgWriter, RsvgDrawsTranslucentShapes) {
  EXPECT_EQ(rsvg_mismatch(ascii_picture({"RRRR____", "RRRR_##_", "GGGG_##_", "GG..____"}), {}), "");
}

/// Of pictures of a few pixels, where curves stray most is much.
TEST(SvgWriter, RsvgDrawsSilhouettesWithTheirCoverage) {
  const Options adaptive{.spline = SplineKind::adaptive};
  for (const auto& [tolerance_px, mean] : {std::pair{0.0, 2.0}, std::pair{kSvgTolerance, 3.0}}) {
    EXPECT_EQ(rsvg_mismatch(ascii_picture({"_..", "._.", "_.."}), adaptive, mean, tolerance_px), "");
    EXPECT_EQ(rsvg_mismatch(ascii_picture({"_.", "._", "_.", ".."}), adaptive, mean, tolerance_px), "");
  }
}

/// Chains are simplified alike wherever they lie and however they are turned; only where a path starts
/// depends on that.
RC_GTEST_PROP(SvgWriter, FlipsAndTurnsTakeAsMuch, ()) {
  constexpr double kPart = 0.1;
  const Picture picture = *random_picture({.colours = ".#r"});
  const auto size = double(Written(picture).svg.size());
  const Symmetry symmetry = *rc::gen::elementOf(kSymmetries);
  RC_ASSERT(std::abs(double(Written(symmetry(picture)).svg.size()) - size) <= kPart * size);
}

}  // namespace
}  // namespace depixel::test
