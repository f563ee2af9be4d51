#include "apps/player/playback.hpp"

#include <gtest/gtest.h>

namespace depixel {
namespace {

constexpr Playback::Extent kTen{0, 10, 10};

double tenth(int) {
  return 0.1;
}

TEST(Playback, ShowsEachFrameForItsTime) {
  Playback playback;
  playback.advance(0.09, kTen, tenth);
  EXPECT_EQ(playback.index(), 0);
  playback.advance(0.02, kTen, tenth);
  EXPECT_EQ(playback.index(), 1);
  playback.advance(0.2, kTen, tenth);
  EXPECT_EQ(playback.index(), 3);
}

TEST(Playback, TakesTheTimesOfFrames) {
  Playback playback;
  const auto seconds_of = [](int index) { return index == 0 ? 0.2 : 0.05; };
  playback.advance(0.19, kTen, seconds_of);
  EXPECT_EQ(playback.index(), 0);
  playback.advance(0.07, kTen, seconds_of);
  EXPECT_EQ(playback.index(), 2);
}

TEST(Playback, SpeedMultipliesTime) {
  Playback playback;
  playback.set_speed(2);
  playback.advance(0.21, kTen, tenth);
  EXPECT_EQ(playback.index(), 4);
  playback.set_speed(1000);
  EXPECT_EQ(playback.speed(), Playback::kMaxSpeed);
  playback.set_speed(0);
  EXPECT_EQ(playback.speed(), Playback::kMinSpeed);
}

TEST(Playback, LoopsOrStopsAtTheEnd) {
  Playback playback;
  playback.seek(9, kTen);
  playback.play(kTen);
  playback.advance(0.11, kTen, tenth);
  EXPECT_EQ(playback.index(), 0);
  playback.set_loop(false);
  playback.seek(9, kTen);
  playback.play(kTen);  // from the first frame again
  EXPECT_EQ(playback.index(), 0);
  for (int i = 0; i < 20; ++i) playback.advance(0.1, kTen, tenth);
  EXPECT_EQ(playback.index(), 9);
  EXPECT_FALSE(playback.is_playing());
}

TEST(Playback, StepsRoundTheEndsOnlyInALoop) {
  Playback playback;
  playback.step(-1, kTen);
  EXPECT_EQ(playback.index(), 9);
  EXPECT_FALSE(playback.is_playing());
  playback.step(1, kTen);
  EXPECT_EQ(playback.index(), 0);
  playback.set_loop(false);
  playback.step(-1, kTen);
  EXPECT_EQ(playback.index(), 0);
  playback.seek(100, kTen);
  EXPECT_EQ(playback.index(), 9);
  playback.step(3, kTen);
  EXPECT_EQ(playback.index(), 9);
}

TEST(Playback, WaitsForFramesThatHaveNotCome) {
  Playback playback;
  const Playback::Extent three{0, 3, std::nullopt};
  for (int i = 0; i < 20; ++i) playback.advance(0.1, three, tenth);
  EXPECT_EQ(playback.index(), 2);
  EXPECT_TRUE(playback.is_playing());
  playback.advance(0.01, {0, 4, std::nullopt}, tenth);
  EXPECT_EQ(playback.index(), 3);
  playback.advance(0.01, {2, 2, std::nullopt}, tenth);  // nothing there: nothing happens
  playback.advance(0.01, {8, 9, std::nullopt}, tenth);  // its frame is gone
  EXPECT_EQ(playback.index(), 8);
}

TEST(Playback, DoesNotMakeUpForLongPauses) {
  Playback playback;
  playback.advance(1000, kTen, tenth);
  EXPECT_LE(playback.index(), 3);
}

TEST(Playback, TellsWhenTheNextFrameIsDue) {
  Playback playback;
  playback.set_speed(2);
  playback.advance(0.02, kTen, tenth);
  ASSERT_TRUE(playback.seconds_left(kTen, tenth));
  EXPECT_NEAR(*playback.seconds_left(kTen, tenth), 0.03, 1e-9);
  EXPECT_FALSE(playback.seconds_left({0, 1, 1}, tenth));  // nothing follows
  EXPECT_TRUE(playback.seconds_left({0, 1, std::nullopt}, tenth));
  playback.pause();
  EXPECT_FALSE(playback.seconds_left(kTen, tenth));
}

TEST(Playback, FramesOfNoTimeDoNotHang) {
  Playback playback;
  playback.advance(0.1, kTen, [](int) { return 0.0; });
  EXPECT_EQ(playback.index(), 1);
}

}  // namespace
}  // namespace depixel
