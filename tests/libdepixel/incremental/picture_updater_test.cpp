#include "libdepixel/incremental/picture_updater.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <optional>
#include <ostream>
#include <tuple>

#include "tests/support/guarded_canvas.hpp"
#include "tests/support/random_sequences.hpp"
#include "tests/support/test_pictures.hpp"

namespace depixel::test {
namespace {

/// A view of any frame, and the size of the picture that is drawn.
struct ViewPlan {
  enum class Kind { fit, whole, cut };
  Kind kind = Kind::fit;
  double scale_x = 1, scale_y = 1;
  double origin_x = 0, origin_y = 0;
  int width = 1, height = 1;  ///< output pixels, of a cut

  glm::ivec2 size_of(const Picture& frame) const {
    if (kind == Kind::cut) return {width, height};
    return {std::max(1, static_cast<int>(std::ceil(frame.width * scale_x))),
            std::max(1, static_cast<int>(std::ceil(frame.height * scale_y)))};
  }
  View view_of(const Picture& frame) const {
    const glm::ivec2 size = size_of(frame);
    if (kind == Kind::fit) return View::fit(Lattice(frame.width, frame.height), size.x, size.y);
    if (kind == Kind::whole) return {scale_x, scale_y, 0, 0};
    return {scale_x, scale_y, origin_x, origin_y};
  }
};

std::ostream& operator<<(std::ostream& out, const ViewPlan& v) {
  constexpr std::array<std::string_view, 3> kKinds{"fit", "whole", "cut"};
  return out << "{ViewPlan::Kind::" << kKinds[static_cast<int>(v.kind)] << ", " << v.scale_x << ", "
             << v.scale_y << ", " << v.origin_x << ", " << v.origin_y << ", " << v.width << ", " << v.height
             << '}';
}

/// How a frame is drawn.
struct DrawPlan {
  int view = 0;               ///< one of two
  int target = 0;             ///< one of two
  bool is_left_out = false;   ///< nothing is drawn until the next frame
  bool is_kept = true;        ///< else, the picture was written to
  bool linear_light = false;  ///< else, what the frame's options say
  int threads = 1;
};

std::ostream& operator<<(std::ostream& out, const DrawPlan& p) {
  return out << '{' << p.view << ", " << p.target << ", " << p.is_left_out << ", " << p.is_kept << ", "
             << p.linear_light << ", " << p.threads << '}';
}

rc::Gen<ViewPlan> random_plan() {
  const auto kind = rc::gen::map(random_int(0, 3), [](int k) { return ViewPlan::Kind(k); });
  const auto scale = rc::gen::element(1.0, 1.5, 2.0, 2.0, 2.5, 3.0, 3.0, 3.33, 4.0, 4.0, 6.0, 7.0);
  const auto both = rc::gen::map(scale, [](double s) { return std::pair(s, s); });
  const auto each = rc::gen::pair(scale, rc::gen::element(1.0, 2.0, 2.5, 5.0, 0.5));
  const auto plain = rc::gen::build<ViewPlan>(
      rc::gen::set(&ViewPlan::kind, kind),
      rc::gen::set(&ViewPlan::origin_x, rc::gen::element(0.0, 1.0, 4.0, -3.0, 2.5, 0.3, 11.0)),
      rc::gen::set(&ViewPlan::origin_y, rc::gen::element(0.0, 1.0, 3.0, -2.0, 1.25, 0.7)),
      rc::gen::set(&ViewPlan::width, random_int(1, 130)),
      rc::gen::set(&ViewPlan::height, random_int(1, 100)));
  return rc::gen::apply(
      [](ViewPlan view, std::pair<double, double> scales) {
        std::tie(view.scale_x, view.scale_y) = scales;
        return view;
      },
      plain, rc::gen::weightedOneOf<std::pair<double, double>>({{3, both}, {1, each}}));
}

rc::Gen<DrawPlan> random_draw() {
  const auto rarely = rc::gen::weightedElement<bool>({{5, false}, {1, true}});
  const auto mostly = rc::gen::weightedElement<bool>({{9, true}, {1, false}});
  const auto one_of_two = rc::gen::weightedElement<int>({{9, 0}, {1, 1}});
  return rc::gen::build<DrawPlan>(
      rc::gen::set(&DrawPlan::view, one_of_two), rc::gen::set(&DrawPlan::target, one_of_two),
      rc::gen::set(&DrawPlan::is_left_out, rarely), rc::gen::set(&DrawPlan::is_kept, mostly),
      rc::gen::set(&DrawPlan::linear_light, rarely), rc::gen::set(&DrawPlan::threads, random_int(1, 4)));
}

/// Vectorizes and draws frames as the filter does, and compares with what is drawn from scratch.
class Drawing {
 public:
  explicit Drawing(const std::array<ViewPlan, 2>& views) : views_(views) {}

  /// \return empty if the picture is the one drawn from scratch, else how it differs.
  std::string mismatch(const SequenceFrame& frame, const DrawPlan& plan) {
    if (frame.is_reset) vectorizer_.reset();
    vectorizer_.vectorize(frame.picture.view(), frame.options);
    changes_.add(vectorizer_.changes());
    if (plan.is_left_out) return "";
    const ViewPlan& planned = views_[plan.view];
    const View view = planned.view_of(frame.picture);
    const glm::ivec2 size = planned.size_of(frame.picture);
    std::optional<GuardedCanvas>& canvas = canvases_[plan.target];
    bool is_kept = plan.is_kept;
    if (!canvas || canvas->target().width != size.x || canvas->target().height != size.y) {
      canvas.emplace(size.x, size.y);
      is_kept = false;
    }
    if (!is_kept) canvas->scribble();
    const bool linear_light = plan.linear_light || frame.options.linear_light;
    updater_.draw(vectorizer_, changes_, view, linear_light, plan.threads, canvas->target(), is_kept);
    changes_.set_nothing();

    Picture expected(size.x, size.y);
    raster_.draw(scratch_.vectorize(frame.picture.view(), frame.options), view, linear_light, 1,
                 expected.target());
    if (!canvas->is_guard_whole()) return "memory outside the picture was written to";
    return difference(expected, canvas->picture());
  }

  const PictureUpdater& updater() const { return updater_; }
  const IncrementalVectorizer& vectorizer() const { return vectorizer_; }

 private:
  static std::string difference(const Picture& expected, const Picture& actual) {
    int count = 0;
    std::string first;
    for (int y = 0; y < expected.height; ++y) {
      for (int x = 0; x < expected.width; ++x) {
        if (expected.at(x, y) == actual.at(x, y)) continue;
        if (count++ == 0) first = std::to_string(x) + ", " + std::to_string(y);
      }
    }
    return count == 0 ? "" : std::to_string(count) + " pixels differ, the first at " + first;
  }

  std::array<ViewPlan, 2> views_;
  IncrementalVectorizer vectorizer_;
  PictureUpdater updater_;
  MapChanges changes_;
  std::array<std::optional<GuardedCanvas>, 2> canvases_;
  Vectorizer scratch_;
  CpuRaster raster_;
};

RC_GTEST_PROP(PictureUpdater, PixelsAreThoseDrawnFromScratch, (const Sequence& sequence)) {
  const std::array<ViewPlan, 2> views{*random_plan(), *random_plan()};
  // Where the list is too short, frames are drawn in the plainest way.
  const auto plans = *rc::gen::resize(20, rc::gen::container<std::vector<DrawPlan>>(random_draw()));
  Drawing drawing(views);
  for (std::size_t i = 0; i < sequence.frames.size(); ++i) {
    const std::string found = drawing.mismatch(sequence.frames[i], i < plans.size() ? plans[i] : DrawPlan{});
    if (!found.empty()) RC_FAIL("frame " + std::to_string(i) + ": " + found);
  }
}

class Scale : public testing::TestWithParam<double> {};

TEST_P(Scale, PixelsOfLongSequencesAreThoseDrawnFromScratch) {
  const ViewPlan view{ViewPlan::Kind::fit, GetParam(), GetParam()};
  Drawing drawing({view, view});
  std::int64_t moved = 0;
  for (const SequenceFrame& frame :
       fixed_sequence(7, {.max_width = 40, .max_height = 32, .steps = 150}).frames) {
    ASSERT_EQ(drawing.mismatch(frame, {.threads = 2}), "") << frame.picture;
    moved += drawing.updater().moved_pixels();
  }
  if (GetParam() == std::floor(GetParam())) {
    EXPECT_GT(moved, 0);
  } else {
    EXPECT_EQ(moved, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(PictureUpdater, Scale, testing::Values(1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 7.0));

constexpr int kUpdatedScale = 4;

constexpr std::int64_t kPixels = std::int64_t{96} * 48 * kUpdatedScale * kUpdatedScale;

/// Whole frames at four times their size.
constexpr ViewPlan kWhole{ViewPlan::Kind::whole, kUpdatedScale, kUpdatedScale};

TEST(PictureUpdater, TheFirstFrameIsDrawnWhole) {
  Drawing drawing({kWhole, kWhole});
  ASSERT_EQ(drawing.mismatch({hills({0, 0}), {}}, {}), "");
  EXPECT_EQ(drawing.updater().drawn_pixels(), kPixels);
  EXPECT_EQ(drawing.updater().moved_pixels(), 0);
}

TEST(PictureUpdater, TheSameFrameAgainDrawsNothing) {
  Drawing drawing({kWhole, kWhole});
  for (int i = 0; i < 2; ++i) ASSERT_EQ(drawing.mismatch({hills({0, 0}), {}}, {}), "");
  EXPECT_EQ(drawing.updater().drawn_pixels(), 0);
  EXPECT_EQ(drawing.updater().moved_pixels(), 0);
}

TEST(PictureUpdater, ASmallChangeDrawsAFewPixels) {
  Drawing drawing({kWhole, kWhole});
  Picture picture = hills({0, 0});
  ASSERT_EQ(drawing.mismatch({picture, {}}, {}), "");
  picture.at(50, 20) = palette_colour('#');
  ASSERT_EQ(drawing.mismatch({picture, {}}, {}), "");
  EXPECT_GE(drawing.updater().drawn_pixels(), kUpdatedScale * kUpdatedScale);
  EXPECT_LT(drawing.updater().drawn_pixels(), kPixels / 20);
}

TEST(PictureUpdater, AScrollByWholePixelsMoves) {
  for (const glm::ivec2 by : {glm::ivec2(1, 0), glm::ivec2(-2, 1), glm::ivec2(3, -2)}) {
    Drawing drawing({kWhole, kWhole});
    ASSERT_EQ(drawing.mismatch({hills({0, 0}), {}}, {}), "");
    ASSERT_EQ(drawing.mismatch({hills(-by), {}}, {}), "");
    EXPECT_GT(drawing.updater().moved_pixels(), drawing.updater().drawn_pixels());
    EXPECT_GT(drawing.updater().moved_pixels(), kPixels / 4);
  }
}

TEST(PictureUpdater, AScrollMovesTranslucentPixelsToo) {
  Drawing drawing({kWhole, kWhole});
  ASSERT_EQ(drawing.mismatch({hills({0, 0}, 'R'), {}}, {}), "");
  ASSERT_EQ(drawing.mismatch({hills({2, 0}, 'R'), {}}, {}), "");
  EXPECT_GT(drawing.updater().moved_pixels(), kPixels / 4);
}

TEST(PictureUpdater, FramesThatWereNotDrawnAddUp) {
  Drawing drawing({kWhole, kWhole});
  ASSERT_EQ(drawing.mismatch({hills({0, 0}), {}}, {}), "");
  Picture picture = hills({0, 0});
  for (int i = 0; i < 4; ++i) {
    picture.at(10 + 20 * i, 10 * i) = palette_colour('#');
    ASSERT_EQ(drawing.mismatch({picture, {}}, {.is_left_out = i < 3}), "");
  }
  EXPECT_GT(drawing.updater().drawn_pixels(), 4 * kUpdatedScale * kUpdatedScale);
  EXPECT_LT(drawing.updater().drawn_pixels(), kPixels / 5);
  for (int i = 1; i < 4; ++i) {
    ASSERT_EQ(drawing.mismatch({hills({i, 0}), {}}, {.is_left_out = i < 3}), "");
  }
}

TEST(PictureUpdater, PixelsThatReachIntoTheNextTileShowAllOfItsCurves) {
  const Picture before = ascii_picture({"......",  //
                                        ".#.#.#",  //
                                        "......"});
  const Picture after = ascii_picture({".#....",  //
                                       ".#.#.#",  //
                                       "......"});
  Options options;
  options.smoothing = Smoothing::average;
  const ViewPlan view{ViewPlan::Kind::cut, 1.5, 2.5, 0.3, -2, 5, 9};
  Drawing drawing({view, view});
  for (const Picture& picture : {before, after}) EXPECT_EQ(drawing.mismatch({picture, options}, {}), "");
}

TEST(PictureUpdater, WhatIsNotKeptIsDrawnWhole) {
  Drawing drawing({kWhole, kWhole});
  ASSERT_EQ(drawing.mismatch({hills({0, 0}), {}}, {}), "");
  ASSERT_EQ(drawing.mismatch({hills({0, 0}), {}}, {.is_kept = false}), "");
  EXPECT_EQ(drawing.updater().drawn_pixels(), kPixels);
}

TEST(PictureUpdater, AnotherTargetIsDrawnWhole) {
  Drawing drawing({kWhole, kWhole});
  for (const int target : {0, 1, 0, 1}) {
    ASSERT_EQ(drawing.mismatch({hills({0, 0}), {}}, {.target = target}), "");
    EXPECT_EQ(drawing.updater().drawn_pixels(), kPixels);
  }
}

TEST(PictureUpdater, OtherLightIsDrawnWhole) {
  Drawing drawing({kWhole, kWhole});
  for (const bool linear_light : {false, true, false}) {
    ASSERT_EQ(drawing.mismatch({hills({0, 0}), {}}, {.linear_light = linear_light}), "");
    EXPECT_EQ(drawing.updater().drawn_pixels(), kPixels);
  }
}

TEST(PictureUpdater, EmptyTargetsAreLeftAlone) {
  IncrementalVectorizer vectorizer;
  vectorizer.vectorize(hills({0, 0}).view(), {});
  PictureUpdater updater;
  updater.draw(vectorizer, vectorizer.changes(), {}, false, 1, {nullptr, 0, 5, 0}, true);
  updater.draw(vectorizer, vectorizer.changes(), {}, false, 1, {nullptr, 5, 0, 0}, true);
  EXPECT_EQ(updater.drawn_pixels(), 0);
}

TEST(PictureUpdater, AnEmptyTargetDoesNotTakeTheChangesOfAnother) {
  const View view{kUpdatedScale, kUpdatedScale, 0, 0};
  IncrementalVectorizer vectorizer;
  PictureUpdater updater;
  Picture kept(96 * kUpdatedScale, 48 * kUpdatedScale), expected = kept;
  vectorizer.vectorize(hills({0, 0}).view(), {});
  updater.draw(vectorizer, vectorizer.changes(), view, false, 1, kept.target(), true);
  vectorizer.vectorize(hills({1, 0}).view(), {});
  updater.draw(vectorizer, vectorizer.changes(), view, false, 1, {kept.target().pixels, 0, 5, 0}, true);
  MapChanges none;
  none.set_nothing();
  updater.draw(vectorizer, none, view, false, 1, kept.target(), true);
  CpuRaster().draw(vectorizer.map(), view, false, 1, expected.target());
  EXPECT_TRUE(kept == expected);
}

}  // namespace
}  // namespace depixel::test
