#include "libdepixel/stages/shading.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "libdepixel/pipeline/vectorizer.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

constexpr Options kMerged{
    .similarity = Similarity::merge, .merge_luma = 48, .shading = ShadingKind::gradient};

Shading shading_of(const Picture& picture, const Options& options) {
  Vectorizer vectorizer;
  return vectorizer.vectorize(picture.view(), options).shading;
}

int block_of(const Picture& picture, const Options& options) {
  return shading_of(picture, options).blocks[Lattice(picture.width, picture.height).corner(1, 1)];
}

TEST(Shading, PixelsOfAComponentArePairs) {
  EXPECT_EQ(block_of(ascii_picture({"45", "54"}), kMerged), Shading::kShaded | 63);
  // Three of a kind, and one that is not.
  EXPECT_EQ(block_of(ascii_picture({"45", "r4"}), kMerged),
            Shading::kShaded | kNorthPair | kEastPair | kMainPair);
  // A bridge between two that have nothing to do with each other.
  EXPECT_EQ(block_of(ascii_picture({"4r", "b5"}), kMerged), Shading::kShaded | kMainPair);
}

TEST(Shading, NothingLeaksAcrossSharpContours) {
  EXPECT_EQ(block_of(ascii_picture({"4r", "4r"}), kMerged), 0);
  EXPECT_EQ(block_of(ascii_picture({"4r", "5r"}), kMerged), Shading::kShaded | kWestPair | kEastPair);
}

TEST(Shading, EvenRegionsHaveNone) {
  EXPECT_FALSE(shading_of(ascii_picture({"44r", "44r"}), kMerged).any);
  EXPECT_FALSE(shading_of(ascii_picture({"45", "45"}), {.shading = ShadingKind::gradient}).any);
  EXPECT_FALSE(
      shading_of(ascii_picture({"45", "45"}), {.similarity = Similarity::merge, .merge_luma = 48}).any);
}

TEST(Shading, SoftContoursDivideWhatIsAlike) {
  EXPECT_EQ(block_of(ascii_picture({"45", "45"}), {.soft_contours = 24}), 0);  // 25 apart
  EXPECT_EQ(block_of(ascii_picture({"45", "45"}), {.soft_contours = 26}), Shading::kShaded | 63);
  EXPECT_EQ(block_of(ascii_picture({"45", "rb"}), {.soft_contours = 26}), Shading::kShaded | kNorthPair);
  // By one step each way the diagonal's ends hang together, but they are not alike.
  EXPECT_EQ(block_of(ascii_picture({"45", "56"}), {.soft_contours = 26}) & kMainPair, 0);
}

TEST(Shading, BeyondTheBorderLiesNothing) {
  const Picture picture = ascii_picture({"45"});
  const Lattice lattice(2, 1);
  const Shading shading = shading_of(picture, kMerged);
  EXPECT_EQ(shading.blocks[lattice.corner(1, 0)] & (kNorthPair | kSouthPair), kNorthPair | kSouthPair);
  EXPECT_EQ(shading.blocks[lattice.corner(1, 0)] & (kMainPair | kAntiPair | kWestPair | kEastPair), 0);
}

TEST(Shading, BlurWeighsByBinomials) {
  const Lattice lattice(3, 1);
  const auto shade = [&](const Picture& picture, int x) {
    return shading_of(picture,
                      {.similarity = Similarity::merge, .merge_luma = 48, .shading = ShadingKind::blur})
        .shades[lattice.pixel(x, 0)];
  };
  // 120, 145, 120: 2 4 2; 4 2 at the sides.
  EXPECT_EQ(shade(ascii_picture({"454"}), 1), (Rgba{133, 133, 133, 255}));
  EXPECT_EQ(shade(ascii_picture({"454"}), 0), (Rgba{128, 128, 128, 255}));
  EXPECT_EQ(shade(ascii_picture({"4r4"}), 1), palette_colour('r'));
}

RC_GTEST_PROP(Shading, BlendingIsMutual, ()) {
  const int pairs = *rc::gen::inRange(0, 64);
  for (int a = 0; a < 4; ++a) {
    RC_ASSERT((blending_pixels(PairMask(pairs), 1 << a) >> a & 1) == 1);
    for (int b = 0; b < 4; ++b) {
      RC_ASSERT((blending_pixels(PairMask(pairs), 1 << a) >> b & 1) ==
                (blending_pixels(PairMask(pairs), 1 << b) >> a & 1));
    }
  }
}

}  // namespace
}  // namespace depixel::test
