#include "libdepixel/stages/border.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "libdepixel/pipeline/vectorizer.hpp"
#include "libdepixel/pipeline/verify.hpp"
#include "libdepixel/raster/cpu_raster.hpp"
#include "libdepixel/svg/svg_writer.hpp"
#include "libdepixel/views/stage_view.hpp"
#include "tests/support/random_pictures.hpp"
#include "tests/support/svg_tools.hpp"

namespace depixel::test {
namespace {

constexpr int kMargin = Border::kMargin;

/// A picture with a margin, of the pixels that `inside` tells for places along either axis.
template <typename Inside>
Picture with_margin(const Picture& picture, Inside inside) {
  Picture wide(picture.width + 2 * kMargin, picture.height + 2 * kMargin);
  for (int y = 0; y < wide.height; ++y) {
    for (int x = 0; x < wide.width; ++x) {
      wide.at(x, y) = picture.at(inside(x - kMargin, picture.width), inside(y - kMargin, picture.height));
    }
  }
  return wide;
}

Picture repeated(const Picture& picture) {
  return with_margin(picture, [](int at, int count) { return at < 0 ? 0 : at >= count ? count - 1 : at; });
}

/// Walks there and back again, a pixel at a time.
Picture mirrored(const Picture& picture) {
  return with_margin(picture, [](int at, int count) {
    int place = 0, step = 1;
    const int steps =
        at < 0 ? -at - 1 : at;  // what is mirrored at the first side begins with its first pixel
    for (int i = 0; i < steps; ++i) {
      if (place + step < 0 || place + step >= count) {
        step = -step;
      } else {
        place += step;
      }
    }
    return place;
  });
}

Picture wide(const Picture& picture, BorderKind kind) {
  return kind == BorderKind::repeat ? repeated(picture) : mirrored(picture);
}

Picture drawn(const Picture& picture, const Options& options, const View& view, int width, int height) {
  Picture out(width, height);
  CpuRaster().draw(Vectorizer().vectorize(picture.view(), options), view, options.linear_light, 1,
                   out.target());
  return out;
}

Options with_border(BorderKind kind) {
  Options options;
  options.border = kind;
  return options;
}

BorderKind random_kind() {
  return *rc::gen::element(BorderKind::repeat, BorderKind::mirror);
}

RC_GTEST_PROP(Border, ContinuesPicturesByTheirPixels, (const Picture& picture)) {
  Border border;
  RC_ASSERT(border.continued(picture.view(), BorderKind::fixed).pixels == picture.view().pixels);
  for (const BorderKind kind : {BorderKind::repeat, BorderKind::mirror}) {
    const FrameView frame = border.continued(picture.view(), kind);
    const Picture expected = wide(picture, kind);
    RC_ASSERT(frame.width == expected.width);
    RC_ASSERT(frame.height == expected.height);
    RC_ASSERT(frame.margin == kMargin);
    for (int y = 0; y < frame.height; ++y) {
      RC_ASSERT(std::equal(frame.pixels + y * frame.pitch, frame.pixels + y * frame.pitch + 4 * frame.width,
                           expected.view().pixels + y * expected.view().pitch));
    }
  }
}

RC_GTEST_PROP(Border, ShowsThePartOfAWiderPicture, (const Picture& picture)) {
  constexpr int kScale = 5;
  Options options = *random_options();
  options.border = random_kind();
  options.dither = DitherKind::keep;       // dithers are looked for before
  options.similarity = Similarity::exact;  // components take the colour of what is shown of them
  options.connect_lines = false;
  const int width = kScale * picture.width, height = kScale * picture.height;
  const Picture shown = drawn(picture, options, {kScale, kScale, 0, 0}, width, height);
  const Picture wider = wide(picture, options.border);
  options.border = BorderKind::fixed;
  RC_ASSERT(shown == drawn(wider, options, {kScale, kScale, kMargin, kMargin}, width, height));
}

TEST(Border, ContoursMeetItAtRightAnglesWhereItContinues) {
  const Picture picture = ascii_picture({"..##", ".##.", "##..", "#..."});
  // A slanted edge reaches the top: there, it turns upright.
  const auto slant_at_top = [&](BorderKind kind) {
    Vectorizer v;
    const PlanarMap& map = v.vectorize(picture.view(), with_border(kind));
    const int border = map.lattice.margin() * kSubpixels;
    double slant = 1e9;
    for (const Segment& s : map.segments) {
      if (s.p0.y != border && s.p3.y != border) continue;
      const glm::ivec2 along = s.p0.y == border ? s.p1 - s.p0 : s.p3 - s.p2;
      if (along.y == 0) continue;
      const glm::ivec2 at = s.p0.y == border ? s.p0 : s.p3;
      const int x = at.x / kSubpixels - map.lattice.margin();
      if (x >= 1 && x < 3) slant = std::min(slant, std::abs(double(along.x) / along.y));
    }
    return slant;
  };
  EXPECT_GT(slant_at_top(BorderKind::fixed), 0.1);
  EXPECT_LT(slant_at_top(BorderKind::mirror), 0.05);
}

TEST(Border, ItsPixelsHaveNoSayInTheColourOfAComponent) {
  const Rgba rim{100, 100, 100, 255}, inside{102, 102, 102, 255};
  Picture picture(8, 8, rim);
  for (int y = 1; y < 7; ++y) std::fill_n(&picture.at(1, y), 6, inside);  // 36 of 64
  for (const BorderKind kind : {BorderKind::fixed, BorderKind::repeat, BorderKind::mirror}) {
    Options options = with_border(kind);
    options.similarity = Similarity::merge;
    EXPECT_EQ(drawn(picture, options, {1, 1, 0, 0}, 8, 8), Picture(8, 8, inside));
  }
}

RC_GTEST_PROP(Border, KeepsTheCentresOfWhatIsShown, (const Picture& picture)) {
  Options options = *random_lossless_options();
  options.border = random_kind();
  Vectorizer v;
  v.vectorize(picture.view(), options);
  const CentreReport report = verify_centres(v.map(), v.graph());
  RC_ASSERT(report.pixels == picture.width * picture.height);
  RC_ASSERT(report.lost == 0);
}

TEST(Border, LostCentresAreToldByTheirPlaceInThePicture) {
  const Picture picture = ascii_picture({"....", "..4.", "...."});
  Vectorizer v;
  PlanarMap map = v.vectorize(picture.view(), with_border(BorderKind::repeat));
  map.colours[map.lattice.pixel(kMargin + 2, kMargin + 1)] = map.colours[map.lattice.pixel(0, 0)];
  const CentreReport report = verify_centres(map, v.graph());
  EXPECT_EQ(report.lost, 1);
  EXPECT_EQ(report.first_lost_x, 2);
  EXPECT_EQ(report.first_lost_y, 1);
}

TEST(Border, DocumentsAreOfTheSizeOfThePicture) {
  const Picture picture = ascii_picture({"..##", ".##.", "##.."});
  for (const BorderKind kind : {BorderKind::repeat, BorderKind::mirror}) {
    const Options options = with_border(kind);
    Vectorizer v;
    v.vectorize(picture.view(), options);
    for (const std::string& svg :
         {write_svg(v.map(), v.graph(), 0),
          write_stage_svg(make_stage_drawing(StageView::cells, picture.view(), options))}) {
      EXPECT_NE(svg.find("width=\"4\" height=\"3\" viewBox=\"6 6 4 3\""), std::string::npos) << svg;
    }
  }
}

RC_GTEST_PROP(Border, StagesShowThePartOfAWiderPicture, (const Picture& picture)) {
  constexpr int kScale = 6;
  const BorderKind kind = random_kind();
  const auto stage =
      static_cast<StageView>(*rc::gen::inRange(0, static_cast<int>(stage_view_names().size())));
  Picture shown(kScale * picture.width, kScale * picture.height), expected = shown;
  paint_stage(make_stage_drawing(stage, picture.view(), with_border(kind)), shown.target());
  paint_stage(make_stage_drawing(stage, wide(picture, kind).view(), {}), {kScale, kScale, kMargin, kMargin},
              expected.target());
  RC_ASSERT(shown == expected);
}

}  // namespace
}  // namespace depixel::test
