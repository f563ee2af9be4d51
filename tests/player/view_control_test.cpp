#include "apps/player/view_control.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace depixel {
namespace {

ViewControl control(glm::ivec2 source, int width, int height) {
  ViewControl view;
  view.set_area({0, 0, width, height});
  view.set_source(source);
  return view;
}

TEST(ViewControl, FitsThePictureInTheMiddle) {
  const ViewControl view = control({100, 50}, 400, 400);
  EXPECT_EQ(view.placement(), (PixelRect{0, 100, 400, 200}));
  EXPECT_EQ(view.scale(), 4);
}

TEST(ViewControl, FitsWholeScalesBelow) {
  ViewControl view = control({100, 50}, 399, 400);
  view.set_whole(true);
  EXPECT_EQ(view.scale(), 3);
}

TEST(ViewControl, MakesPixelsAsWideAsAsked) {
  ViewControl view = control({256, 224}, 2000, 224);
  view.set_aspect(PixelAspect::eight_sevenths);
  EXPECT_EQ(view.placement().width, 293);  // 256 * 8 / 7, rounded
  view.set_aspect(PixelAspect::picture_4_3);
  EXPECT_EQ(view.placement().width, 299);  // 224 * 4 / 3, rounded
}

TEST(ViewControl, FollowsTheSourcesAspectUnlessToldOtherwise) {
  ViewControl view = control({100, 50}, 2000, 100);
  view.set_source({100, 50}, 1.5);
  EXPECT_EQ(view.placement().width, 300);
  view.set_aspect(PixelAspect::eight_sevenths);
  EXPECT_EQ(view.placement().width, 229);  // 200 * 8 / 7, rounded
}

TEST(ViewControl, ViewsAgreeWithThePlacement) {
  ViewControl view = control({100, 50}, 400, 400);
  view.zoom_about({10, 120}, 3.3);
  const PixelRect all = view.placement(), visible = view.visible();
  const View whole = view.view_of(all), part = view.view_of(visible);
  EXPECT_EQ(whole.origin_x, 0);
  EXPECT_EQ(whole.scale_x, part.scale_x);
  EXPECT_NEAR(part.origin_x * part.scale_x, visible.x - all.x, 1e-9);
  EXPECT_NEAR(part.origin_y * part.scale_y, visible.y - all.y, 1e-9);
}

RC_GTEST_PROP(ViewControl, ZoomingKeepsThePointUnderThePointer, ()) {
  ViewControl view = control({256, 224}, 800, 600);
  for (int i = *rc::gen::inRange(1, 6); i > 0; --i) {
    const PixelRect visible = view.visible();
    const glm::dvec2 pointer(visible.x + visible.width / 2, visible.y + visible.height / 2);
    const glm::dvec2 before = view.source_at(pointer);
    view.zoom_about(pointer, *rc::gen::element(0.8, 1.1, 1.5, 3.0));
    const glm::dvec2 after = view.source_at(pointer);
    RC_ASSERT(std::abs(after.x - before.x) < 1e-9);
    RC_ASSERT(std::abs(after.y - before.y) < 1e-9);
  }
}

RC_GTEST_PROP(ViewControl, NeverLosesThePicture, ()) {
  ViewControl view = control({*rc::gen::inRange(1, 500), *rc::gen::inRange(1, 500)}, 640, 480);
  for (int i = *rc::gen::inRange(1, 12); i > 0; --i) {
    if (*rc::gen::arbitrary<bool>()) {
      view.pan({*rc::gen::inRange(-2000, 2000), *rc::gen::inRange(-2000, 2000)});
    } else {
      view.zoom_about({*rc::gen::inRange(0, 640), *rc::gen::inRange(0, 480)},
                      *rc::gen::element(0.1, 0.5, 2.0, 30.0));
    }
    RC_ASSERT(!view.visible().empty());
    RC_ASSERT(view.scale() >= ViewControl::kMinScale);
    RC_ASSERT(view.scale() <= ViewControl::kMaxScale);
  }
  view.fit();
  RC_ASSERT(view.visible() == view.placement());
}

}  // namespace
}  // namespace depixel
