#include "libdepixel/views/stage_view.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "libdepixel/raster/cpu_raster.hpp"
#include "libdepixel/views/painter.hpp"
#include "tests/support/random_pictures.hpp"
#include "tests/support/svg_tools.hpp"
#include "tests/support/test_pictures.hpp"

namespace depixel::test {
namespace {

std::vector<StageView> all_views() {
  std::vector<StageView> views;
  for (const std::string_view name : stage_view_names()) views.push_back(*stage_view_by_name(name));
  return views;
}

Picture painted(const StageDrawing& drawing, int scale) {
  const Lattice& lattice = drawing.fill.lattice;
  Picture picture(lattice.width() * scale, lattice.height() * scale);
  paint_stage(drawing, picture.target());
  return picture;
}

/// Two crossings (a tie and one that is decided), lines, a hole, a T-junction and transparency.
Picture sample() {
  return ascii_picture({"........", ".#.rrr._", "..#r.r__", ".#.rrr__", "#.#gggbb", "...gggbb"});
}

std::ptrdiff_t rings(const StageDrawing& drawing) {
  return std::count_if(drawing.circles.begin(), drawing.circles.end(),
                       [](const Circle& c) { return c.ring_px > 0; });
}

TEST(StageView, NamesAreThoseOfTheCommandLine) {
  const std::vector<std::string_view> expected{"bitmap",   "similarity", "cells",    "simplified", "contours",
                                               "polygons", "curves",     "smoothed", "components", "shaded"};
  EXPECT_TRUE(std::ranges::equal(stage_view_names(), expected));
  EXPECT_EQ(stage_view_by_name("smoothed"), StageView::smoothed);
  EXPECT_EQ(stage_view_by_name("blurred"), std::nullopt);
}

TEST(StageView, BitmapShowsSquarePixels) {
  const Picture in = sample(), out = painted(make_stage_drawing(StageView::bitmap, in.view(), {}), 5);
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x)
      ASSERT_EQ(out.at(x, y), normalized(in.at(x / 5, y / 5))) << x << ' ' << y;
  }
}

TEST(StageView, BitmapShowsDithersAsTheyCame) {
  const Picture in = ascii_picture({".#.#", "#.#.", ".#.#", "#.#."});
  const Options blend{.dither = DitherKind::blend};
  EXPECT_EQ(painted(make_stage_drawing(StageView::bitmap, in.view(), blend), 1), in);
  EXPECT_EQ(painted(make_stage_drawing(StageView::components, in.view(), blend), 1),
            Picture(4, 4, {128, 128, 128, 255}));
  EXPECT_EQ(rings(make_stage_drawing(StageView::similarity, in.view(), blend)), 0);
}

TEST(StageView, ComponentsShowThePicture) {
  const Picture in = sample();
  Vectorizer vectorizer;
  const PlanarMap& map = vectorizer.vectorize(in.view(), {});
  Picture expected(in.width * 7, in.height * 7);
  CpuRaster().draw(map, View::fit(map.lattice, expected.width, expected.height), false, 1, expected.target());
  EXPECT_EQ(painted(make_stage_drawing(StageView::components, in.view(), {}), 7), expected);
}

TEST(StageView, SimilarityRingsCrossingsAndJoinsLinksInARow) {
  const Picture crossing = ascii_picture({"#.", ".#"});
  const StageDrawing drawing = make_stage_drawing(StageView::similarity, crossing.view(), {});
  EXPECT_EQ(rings(drawing), 1);
  EXPECT_EQ(drawing.strokes.size(), 2u);
  EXPECT_EQ(drawing.circles.size(), 4u + 1u);

  const Picture flat = ascii_picture({"....", "...."});
  const StageDrawing links = make_stage_drawing(StageView::similarity, flat.view(), {});
  EXPECT_EQ(rings(links), 0);  // one piece through its sides, so nothing to resolve
  EXPECT_EQ(links.strokes.size(), 2u + 4u + 3u + 3u);
}

TEST(StageView, SimilarityShowsJoinedLines) {
  const Picture lines = ascii_picture({".......",  //
                                       ".33....",  //
                                       "...55..",  //
                                       "......."});
  const auto strokes = [&](bool connect_lines) {
    Options options;
    options.connect_lines = connect_lines;
    return make_stage_drawing(StageView::similarity, lines.view(), options).strokes.size();
  };
  EXPECT_EQ(strokes(true), strokes(false) + 1);
}

TEST(StageView, ContoursMarkTheirEndsAndTellKindsApart) {
  const Picture in = ascii_picture({"####", "####", "rr67", "rr67"});
  const StageDrawing drawing = make_stage_drawing(StageView::contours, in.view(), {});
  EXPECT_EQ(rings(drawing), 2 + 2 * 2);  // one contour through, two that end on it
  const auto [thin, thick] = std::ranges::minmax(drawing.strokes, {}, &Stroke::width_px);
  EXPECT_LT(thin.width_px, thick.width_px);  // grey 6 and 7 are alike
  EXPECT_EQ(thin.p0.x, 3 * kSubpixels);
}

TEST(StageView, PolygonsAreStraight) {
  const Picture in = sample();
  for (const Segment& s : make_stage_drawing(StageView::polygons, in.view(), {}).fill.segments) {
    EXPECT_EQ(s.p0 % (kSubpixels / 4), glm::ivec2(0, 0));
    EXPECT_EQ(s.p1, s.p0 + (s.p3 - s.p0) / 3);
  }
}

TEST(Painter, LevelLinesAreCoveredExactly) {
  Picture picture(20, 10, {255, 255, 255, 255});
  const glm::ivec2 from(0, 5 * kSubpixels / 2), to(20 * kSubpixels, 5 * kSubpixels / 2);
  const Stroke line{from, from, to, to, {0, 0, 0, 255}, 0.5f};
  Painter(View{}, picture.target()).paint(std::span(&line, 1));
  for (int x = 0; x < picture.width; ++x) {
    EXPECT_EQ(picture.at(x, 1).r, 255);
    EXPECT_EQ(picture.at(x, 2).r, 128);  // half of the row, also where pieces of the line join
    EXPECT_EQ(picture.at(x, 3).r, 255);
  }
}

TEST(Painter, DrawsOverTransparency) {
  Picture picture(9, 9);
  const Circle disc{glm::ivec2(9, 9) * (kSubpixels / 2), {10, 20, 30, 255}, 3.0f, 0};
  Painter(View{}, picture.target()).paint(std::span(&disc, 1));
  EXPECT_EQ(picture.at(4, 4), (Rgba{10, 20, 30, 255}));
  EXPECT_EQ(picture.at(0, 0), Rgba{});
  EXPECT_EQ(picture.at(4, 1).r, 10);  // the edge keeps its colour and fades in alpha
}

TEST(StageView, PartsAreCutFromTheWhole) {
  constexpr int kScale = 8, kLeft = 13, kTop = 6;
  const Picture in = sample();
  for (const StageView view : all_views()) {
    const StageDrawing drawing = make_stage_drawing(view, in.view(), {});
    const Picture whole = painted(drawing, kScale);
    Picture part(29, 23);
    paint_stage(drawing, {kScale, kScale, double(kLeft) / kScale, double(kTop) / kScale}, part.target());
    for (int y = 0; y < part.height; ++y) {
      for (int x = 0; x < part.width; ++x) {
        ASSERT_EQ(part.at(x, y), whole.at(x + kLeft, y + kTop))
            << stage_view_names()[static_cast<int>(view)] << ' ' << x << ' ' << y;
      }
    }
  }
}

TEST(StageView, RsvgDrawsEveryViewAsThePainterDoes) {
  constexpr int kScale = 16;
  constexpr double kMeanTolerance = 2.0;
  const Picture in = sample();
  for (const StageView view : all_views()) {
    const StageDrawing drawing = make_stage_drawing(view, in.view(), {});
    const Picture expected = painted(drawing, kScale);
    const Picture drawn = draw_with_rsvg(write_stage_svg(drawing), expected.width, expected.height);
    EXPECT_LE(compare(expected, drawn).mean, kMeanTolerance) << stage_view_names()[static_cast<int>(view)];
  }
}

RC_GTEST_PROP(StageView, NoSeamsInAnyFill, ()) {
  const Picture in = *random_picture({.colours = "#.rgb4567"});
  const Options options = *random_options();
  for (const StageView view : all_views()) {
    for (const Rgba c : painted(make_stage_drawing(view, in.view(), options), 3).pixels)
      RC_ASSERT(c.a == 255);
  }
}

RC_GTEST_PROP(StageView, SvgIsWellFormedXml, (const Picture& in)) {
  const Options options = *random_options();
  for (const StageView view : all_views()) {
    pugi::xml_document document;
    RC_ASSERT(document.load_string(write_stage_svg(make_stage_drawing(view, in.view(), options)).c_str()));
  }
}

RC_GTEST_PROP(StageView, BuffersCanBeUsedAgain, (const Picture& first, const Picture& second)) {
  Vectorizer vectorizer;
  StageDrawing drawing;
  for (const StageView view : all_views()) {
    const StageView before = *rc::gen::elementOf(all_views());
    make_stage_drawing(before, first.view(), {}, vectorizer, drawing);
    make_stage_drawing(view, second.view(), {}, vectorizer, drawing);
    RC_ASSERT(write_stage_svg(drawing) == write_stage_svg(make_stage_drawing(view, second.view(), {})));
  }
}

}  // namespace
}  // namespace depixel::test
