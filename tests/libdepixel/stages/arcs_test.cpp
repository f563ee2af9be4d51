#include "libdepixel/stages/arcs.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>

#include "libdepixel/pipeline/vectorizer.hpp"
#include "libdepixel/stages/node_placement.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

using Points = std::vector<std::pair<int, int>>;

Points points_of(const Vectorizer& v, const Arc& arc) {
  Points list;
  for (int k = arc.first; k < arc.first + arc.count; ++k) {
    const glm::ivec2 p = v.cells().lattice.corner_position(v.arcs().corner[k]);
    list.emplace_back(p.x, p.y);
  }
  return list;
}

std::vector<Points> all_corners(const Vectorizer& v) {
  std::vector<Points> list;
  for (const Arc& arc : v.arcs().list) list.push_back(points_of(v, arc));
  return list;
}

TEST(Arcs, ARoundContourIsOneClosedArc) {
  Vectorizer v;
  v.vectorize(ascii_picture({"....",  //
                             ".##.",  //
                             ".##.",  //
                             "...."})
                  .view(),
              {});
  ASSERT_EQ(v.arcs().list.size(), 1U);
  EXPECT_TRUE(v.arcs().list[0].kind.closed);
  EXPECT_EQ(v.arcs().list[0].count, 8);
  EXPECT_EQ(v.arcs().list[0].step_count(), 8);
}

TEST(Arcs, AreCutAtJunctionsOfFour) {
  Vectorizer v;
  v.vectorize(ascii_picture({"rg",  //
                             "by"})
                  .view(),
              {});
  EXPECT_EQ(all_corners(v),
            (std::vector<Points>{{{1, 0}, {1, 1}}, {{1, 1}, {1, 2}}, {{0, 1}, {1, 1}}, {{1, 1}, {2, 1}}}));
}

/// A square with sides of this many pixels.
Picture square(int side) {
  Picture picture(side + 4, side + 4, palette_colour('.'));
  paste(picture, Picture(side, side, palette_colour('r')), 2, 2);
  return picture;
}

TEST(Arcs, AreCutAtRightAnglesWithLongArms) {
  for (const int side : {3, 4, 5, 6, 7}) {
    Vectorizer v;
    v.vectorize(square(side).view(), {});
    const bool is_cut = v.arcs().list.size() == 4;
    EXPECT_EQ(is_cut, side >= 3) << side;
    EXPECT_TRUE(is_cut || v.arcs().list.size() == 1);
  }
}

TEST(Arcs, ArmsOfTwoStepsAreTooShort) {
  Vectorizer v;
  v.vectorize(square(2).view(), {});
  EXPECT_EQ(v.arcs().list.size(), 1U);
}

TEST(Arcs, RightAnglesAreCutWithEnergyOnly) {
  for (const Smoothing smoothing : {Smoothing::average, Smoothing::none}) {
    Options options;
    options.smoothing = smoothing;
    Vectorizer v;
    v.vectorize(square(8).view(), options);
    ASSERT_EQ(v.arcs().list.size(), 1U);
    EXPECT_TRUE(v.arcs().list[0].kind.closed);
    for (const ShapeWord word : v.arcs().words(v.arcs().list[0])) EXPECT_EQ(word.thin_sides(), 0);
  }
}

TEST(Arcs, AClosedContourThatIsCutOnceRunsFromTheCutToTheCut) {
  // Its other corners are rounded off.
  Vectorizer v;
  v.vectorize(ascii_picture({".......",  //
                             ".####..",  //
                             ".#####.",  //
                             ".#####.",  //
                             ".#####.",  //
                             "..###..",  //
                             "......."})
                  .view(),
              {});
  ASSERT_EQ(v.arcs().list.size(), 1U);
  const Points corners = points_of(v, v.arcs().list[0]);
  EXPECT_FALSE(v.arcs().list[0].kind.closed);
  EXPECT_EQ(corners.front(), std::pair(1, 1));
  EXPECT_EQ(corners.back(), std::pair(1, 1));
}

TEST(Arcs, WordsTellThinSides) {
  Vectorizer v;
  v.vectorize(ascii_picture({"........",  //
                             "........",  //
                             "..####..",  //
                             "........",  //
                             "........"})
                  .view(),
              {});
  int left = 0, right = 0;
  for (const Arc& arc : v.arcs().list) {
    for (const ShapeWord word : v.arcs().words(arc)) {
      left += word.thin_sides() & 1;
      right += word.thin_sides() >> 1;
    }
  }
  // Clockwise round the line, which is on the right.
  EXPECT_EQ(left, 0);
  EXPECT_GT(right, 0);
}

RC_GTEST_PROP(Arcs, EachStepOfEachContourIsInOneArc, (const Picture& picture)) {
  Vectorizer v;
  v.vectorize(picture.view(), *random_options());
  std::map<std::pair<int, int>, int> steps;  // by corner and heading
  for (const Contour& contour : v.contours().list) {
    for (int k = contour.first; k < contour.first + contour.step_count(); ++k) {
      ++steps[{v.contours().corner[k], v.contours().heading[k]}];
    }
  }
  for (const Arc& arc : v.arcs().list) {
    RC_ASSERT(arc.count >= 2);
    const std::span<const ShapeWord> words = v.arcs().words(arc);
    for (int k = 0; k < arc.step_count(); ++k) {
      const int corner = v.arcs().corner[arc.first + k];
      RC_ASSERT((--steps[{corner, words[k].heading()}]) == 0);
      const int next = v.arcs().corner[arc.first + (k + 1) % arc.count];
      RC_ASSERT(corner + v.cells().lattice.step_offsets()[words[k].heading()] == next);
    }
  }
  RC_ASSERT(std::all_of(steps.begin(), steps.end(), [](const auto& step) { return step.second == 0; }));
}

RC_GTEST_PROP(Arcs, EndsHaveNoCodeAndWhatIsBetweenHas, (const Picture& picture)) {
  const Options options = *random_options();
  Vectorizer v;
  v.vectorize(picture.view(), options);
  std::vector<PixelMarks> marks;
  find_pixel_marks(v.graph(), options.text_safe, marks);
  const std::array<int, 4> left = v.cells().lattice.left_offsets();
  for (const Arc& arc : v.arcs().list) {
    const std::span<const ShapeWord> words = v.arcs().words(arc);
    for (int k = 0; k < arc.count; ++k) {
      const int corner = v.arcs().corner[arc.first + k];
      const bool is_end = !arc.kind.closed && (k == 0 || k == arc.count - 1);
      RC_ASSERT(words[k].code().bits() == (is_end ? 0 : v.cells().corners[corner].bits()));
      if (k == arc.step_count()) continue;  // where an open arc ends, no step leaves
      const bool is_marked = options.smoothing == Smoothing::energy;
      const PixelMarks on_left = marks[corner + left[words[k].heading()]];
      const PixelMarks on_right = marks[corner + left[turned(words[k].heading(), 1)]];
      const int thin_sides = ((on_left & kThinLine) != 0 ? 1 : 0) + ((on_right & kThinLine) != 0 ? 2 : 0);
      RC_ASSERT(words[k].thin_sides() == (is_marked ? thin_sides : 0));
      RC_ASSERT(words[k].is_text() == (is_marked && ((on_left | on_right) & kText) != 0));
    }
    if (!arc.kind.closed) {
      RC_ASSERT(words.back().heading() == words[words.size() - 2].heading());
      RC_ASSERT(words.back().thin_sides() == 0);
      RC_ASSERT(!words.back().is_text());
    }
    RC_ASSERT(arc.kind.interpolated || options.spline != SplineKind::interpolate);
    RC_ASSERT(!arc.kind.interpolated || options.spline != SplineKind::approximate);
    RC_ASSERT((arc.kind.rounds > 0) == (options.smoothing == Smoothing::average));
  }
}

}  // namespace
}  // namespace depixel::test
