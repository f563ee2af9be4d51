#include "apps/player/settings.hpp"

#include <gtest/gtest.h>

#include <string>

#include "apps/common/limits.hpp"
#include "tests/apps/process.hpp"

namespace depixel::test {
namespace {

Settings unusual() {
  Settings settings;
  settings.window = {640, 480, true, -5, 7};
  settings.look = {PixelAspect::eight_sevenths, true, false, false, true, 0.25, RawSampling::bilinear};
  settings.play = {2.5, false};
  settings.options.smoothing = Smoothing::none;
  settings.options.island_weight = 3.5;
  settings.options.linear_light = true;
  settings.last_folder = "some/where";
  return settings;
}

TEST(Settings, SurviveBeingWritten) {
  const auto read = parse_settings(settings_text(unusual()));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(settings_text(*read), settings_text(unusual()));
  EXPECT_EQ(read->options, unusual().options);
  EXPECT_EQ(read->look.divider, 0.25);
  EXPECT_EQ(read->window.x, -5);
}

TEST(Settings, AreWrittenWithinTheLimitsThatTheyAreReadWith) {
  Settings settings;
  settings.window = {1, 99999, true, -99999, 99999};
  settings.play.speed = 1000;
  const auto read = parse_settings(settings_text(settings));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->window.width, kMinWindowSide);
  EXPECT_EQ(read->window.height, kMaxSide);
}

TEST(Settings, MissingOnesKeepTheirDefaults) {
  const auto read = parse_settings(R"({"play": {"speed": 0.5}, "unknown": [1, 2]})");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->play.speed, 0.5);
  EXPECT_EQ(read->options, Options{});
}

TEST(Settings, DamagedOnesAreRefused) {
  for (const char* text :
       {"", "{", "[]", "12", R"({"play": {"speed": "fast"}})", R"({"play": {"speed": -1}})",
        R"({"look": {"raw": "blurred"}})", R"({"options": {"threads": 0}})", R"({"window": 3})"}) {
    EXPECT_FALSE(parse_settings(text)) << text;
  }
}

TEST(Settings, AreSavedWithTheirFolder) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "not/yet/there.json";
  EXPECT_EQ(settings_text(load_settings(file).value()), settings_text({}));
  ASSERT_TRUE(save_settings(unusual(), file));
  EXPECT_EQ(settings_text(load_settings(file).value()), settings_text(unusual()));
  write_text(file, "{ damaged");
  const auto loaded = load_settings(file);
  ASSERT_FALSE(loaded);
  EXPECT_NE(loaded.error().message.find(file.string()), std::string::npos);
}

}  // namespace
}  // namespace depixel::test
