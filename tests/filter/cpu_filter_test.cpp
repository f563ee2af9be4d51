#include <gtest/gtest.h>

#include "filter/frame_filter.hpp"
#include "libdepixel/raster/cpu_raster.hpp"
#include "tests/support/ascii_picture.hpp"
#include "tests/support/test_pictures.hpp"

namespace depixel::test {
namespace {

TEST(CpuFilter, DrawsToPicturesOnly) {
  const auto filter = FrameFilter::cpu();
  ASSERT_TRUE(filter->submit(ascii_picture({"#.", ".#"}).view(), {}));
  EXPECT_FALSE(filter->draw(GlFramebuffer{0}, {0, 0, 8, 8}, {4, 4, 0, 0}));
}

/// What a filter draws to a picture that it is told is kept.
void expect_kept_is_as_plain(FrameFilter& filter, Picture& kept) {
  constexpr View kView{4, 4, 0, 0};
  const Viewport all{0, 0, kept.width, kept.height};
  ASSERT_TRUE(filter.draw(KeptPicture{kept.target()}, all, kView));
  Picture expected(kept.width, kept.height);
  CpuRaster().draw(filter.vectorizer().map(), kView, false, 1, expected.target());
  EXPECT_TRUE(kept == expected);
}

TEST(CpuFilter, DrawsShadedFramesHoweverSmall) {
  const auto filter = FrameFilter::cpu();
  Options options;
  options.similarity = Similarity::merge;
  options.merge_luma = 48;
  options.shading = ShadingKind::gradient;
  ASSERT_TRUE(filter->submit(ascii_picture({"4455", "4455", "5566", "5566"}).view(), options));
  ASSERT_TRUE(filter->vectorizer().shading().any);
  Picture picture(3, 3);
  for (const double scale : {1e-3, 2e-8, 1e-300}) {
    EXPECT_TRUE(filter->draw(picture.target(), {0, 0, 3, 3}, {scale, scale, 0, 0}));
  }
}

TEST(CpuFilter, KeptPicturesAreBroughtUpToDate) {
  const auto filter = FrameFilter::cpu();
  filter->check_incremental(true);
  Picture kept(4 * 96, 4 * 48);
  for (const int from : {0, 1, 3, 2}) {
    ASSERT_TRUE(filter->submit(hills({from, 0}).view(), {}));
    expect_kept_is_as_plain(*filter, kept);
    EXPECT_EQ(filter->stats().moved_pixels > 0, from != 0);
  }
}

TEST(CpuFilter, ARefusedFrameLeavesNoTrace) {
  const auto filter = FrameFilter::cpu();
  Picture kept(4 * 96, 4 * 48);
  for (const int from : {0, 1}) {
    ASSERT_TRUE(filter->submit(hills({from, 0}).view(), {}));
    expect_kept_is_as_plain(*filter, kept);
  }
  EXPECT_FALSE(filter->submit({}, {}));
  expect_kept_is_as_plain(*filter, kept);
  EXPECT_EQ(filter->stats().moved_pixels, 0);
}

TEST(CpuFilter, AnEmptyViewportDoesNotTakeTheChangesOfAnother) {
  const auto filter = FrameFilter::cpu();
  Picture kept(4 * 96, 4 * 48);
  ASSERT_TRUE(filter->submit(hills({0, 0}).view(), {}));
  expect_kept_is_as_plain(*filter, kept);
  ASSERT_TRUE(filter->submit(hills({1, 0}).view(), {}));
  ASSERT_TRUE(filter->draw(KeptPicture{kept.target()}, {}, {4, 4, 0, 0}));
  expect_kept_is_as_plain(*filter, kept);
}

}  // namespace
}  // namespace depixel::test
