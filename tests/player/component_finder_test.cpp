#include "apps/player/component_finder.hpp"

#include <gtest/gtest.h>

#include "apps/common/picture.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"

namespace depixel {
namespace {

constexpr Rgba kInk{10, 20, 30, 255}, kPaper{240, 230, 220, 255};

/// A square of ink of 2 x 2 pixels in the middle of 6 x 6 of paper.
Picture square() {
  Picture picture(6, 6);
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 6; ++x) picture.at(x, y) = x / 2 == 1 && y / 2 == 1 ? kInk : kPaper;
  }
  return picture;
}

TEST(ComponentFinder, FindsWhatLiesUnderAPoint) {
  Vectorizer vectorizer;
  vectorizer.vectorize(square().view(), {});
  ComponentFinder finder;
  finder.take(vectorizer.map(), vectorizer.graph(), 1);
  const auto ink = finder.at({3, 3}), paper = finder.at({0.5, 5.5});
  ASSERT_TRUE(ink && paper);
  EXPECT_EQ(ink->colour, kInk);
  EXPECT_EQ(ink->size_px, 4);
  EXPECT_EQ(paper->colour, kPaper);
  EXPECT_EQ(paper->size_px, 32);
  EXPECT_EQ(finder.loops(ink->index).size(), 1u);
  EXPECT_EQ(finder.loops(paper->index).size(), 2u);  // round itself and round its hole
  EXPECT_FALSE(finder.at({-0.1, 3}));
  EXPECT_FALSE(finder.at({3, 6}));
}

TEST(ComponentFinder, FollowsCurvesNotPixels) {
  // A dot is a disc: at the corner of its pixel lies paper.
  Picture dot(3, 3);
  for (int i = 0; i < 9; ++i) dot.at(i % 3, i / 3) = i == 4 ? kInk : kPaper;
  Vectorizer vectorizer;
  vectorizer.vectorize(dot.view(), {});
  ComponentFinder finder;
  finder.take(vectorizer.map(), vectorizer.graph(), 1);
  EXPECT_EQ(finder.at({1.5, 1.5})->colour, kInk);
  EXPECT_EQ(finder.at({1.02, 1.02})->colour, kPaper);
}

TEST(ComponentFinder, TakesOtherVersionsOnly) {
  Vectorizer vectorizer;
  ComponentFinder finder;
  vectorizer.vectorize(square().view(), {});
  finder.take(vectorizer.map(), vectorizer.graph(), 1);
  Picture plain(6, 6);
  for (int i = 0; i < 36; ++i) plain.at(i % 6, i / 6) = kPaper;
  vectorizer.vectorize(plain.view(), {});
  finder.take(vectorizer.map(), vectorizer.graph(), 1);
  EXPECT_EQ(finder.at({3, 3})->size_px, 4);
  finder.take(vectorizer.map(), vectorizer.graph(), 2);
  EXPECT_EQ(finder.at({3, 3})->size_px, 36);
}

}  // namespace
}  // namespace depixel
