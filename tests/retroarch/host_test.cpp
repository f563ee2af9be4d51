// What RetroArch itself makes of the test core's frames, without a filter and with one of Debian's: so that
// the tests of our filter test our filter.

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/apps/pictures.hpp"
#include "tests/retroarch/expected.hpp"
#include "tests/retroarch/play.hpp"

namespace depixel::test {
namespace {

constexpr int kScale = 4;
const std::string kNormal4x = DEPIXEL_RETROARCH_FILTERS "/Normal4x.filt";

/// Plays a script that ends with a frame, each pixel of which is a square of four on the screen.
RetroArchRan play_fourfold(const TemporaryFolder& folder, const std::string& script, const Picture& shown,
                           RetroArchRun run = {}) {
  run.frames = 12;
  return play(folder, script, kScale * shown.width(), kScale * shown.height(), run);
}

/// Expects a run to have ended well, and to have shown a frame, enlarged.
void expect_shown(const RetroArchRan& run, const Picture& frame, const std::string& what = "") {
  EXPECT_EQ(run.exit_code, 0) << what << run.log;
  EXPECT_EQ(run.errors, "") << what;
  EXPECT_EQ(mismatch(enlarged(frame, kScale), run.screenshot), "") << what;
}

/// Both ways to enlarge, on the emulator's thread and on one for video.
class RetroArch : public testing::TestWithParam<std::pair<std::string, bool>> {
 protected:
  RetroArch() {
    write_text(folder_ / "large.png", png_of(large_));
    write_text(folder_ / "small.png", png_of(small_));
  }

  RetroArchRan play(const std::string& script, const Picture& shown) const {
    const auto& [filter, is_threaded] = GetParam();
    return play_fourfold(folder_, script, shown, {.filter = filter, .is_threaded = is_threaded});
  }

  const Picture large_ = colourful_picture(96, 72), small_ = sample_picture(60, 45);
  TemporaryFolder folder_;
};

TEST_P(RetroArch, ShowsEveryFormatAsItIs) {
  for (const auto& [name, format] :
       {std::pair("xrgb8888", PixelFormat::xrgb8888), std::pair("rgb565", PixelFormat::rgb565),
        std::pair("0rgb1555", PixelFormat::xrgb1555)}) {
    const std::string head = std::string("format ") + name + "\ngeometry 96x72\n";
    expect_shown(play(head + "show large.png", large_), in_format(large_, format), name);
    expect_shown(play(head + "padding 12\nshow large.png", large_), in_format(large_, format), name);
  }
}

TEST_P(RetroArch, ShowsTheFrameOnThroughDuplicates) {
  expect_shown(play("geometry 96x72\nshow small.png 2\nshow large.png\nduplicate 20\n", large_), large_);
}

TEST_P(RetroArch, FollowsGeometry) {
  const std::string head = "geometry 96x72\nshow large.png 3\nresize 60x45\nshow small.png 3\n";
  expect_shown(play(head, small_), small_);
  expect_shown(play(head + "resize 96x72\nshow large.png", large_), large_);
}

TEST_P(RetroArch, ShowsFramesOfOtherSizesThanItWasTold) {
  expect_shown(play("geometry 96x72\nshow large.png 3\nshow small.png", small_), small_);
}

TEST_P(RetroArch, FollowsAvInfo) {
  expect_shown(play("geometry 60x45\nshow small.png 3\nav_info 96x72 120x100\nshow large.png 3", large_),
               large_);
}

INSTANTIATE_TEST_SUITE_P(, RetroArch,
                         testing::Values(std::pair("", false), std::pair("", true),
                                         std::pair(kNormal4x, false), std::pair(kNormal4x, true)),
                         [](const auto& each) {
                           return std::string(each.param.first.empty() ? "Unfiltered" : "Normal4x") +
                                  (each.param.second ? "Threaded" : "");
                         });

TEST(RetroArchUnfiltered, TurnsCounterClockwise) {
  const TemporaryFolder folder;
  Picture turned = sample_picture(96, 72);
  write_text(folder / "a.png", png_of(turned));
  for (const int degrees : {0, 90, 180, 270}) {
    const std::string script = "geometry 96x72\nrotate " + std::to_string(degrees) + "\nshow a.png";
    expect_shown(play_fourfold(folder, script, turned), turned, script);
    turned = turned_left(turned);
  }
}

TEST(RetroArchUnfiltered, ShowsFramesLargerThanTheCoreSaid) {
  const TemporaryFolder folder;
  const Picture picture = sample_picture(120, 90);
  write_text(folder / "a.png", png_of(picture));
  expect_shown(play_fourfold(folder, "geometry 96x72\nshow a.png", picture), picture);
}

TEST(RetroArchUnfiltered, RefusesABadScriptWithTheCoresSentence) {
  const TemporaryFolder folder;
  const RetroArchRan run = play_fourfold(folder, "geometry 4x3\nsing", Picture(16, 16));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.log.find("test.frames, line 2: There is no action sing."), std::string::npos) << run.log;
  EXPECT_NE(run.errors, "");
}

}  // namespace
}  // namespace depixel::test
