#include "tests/retroarch/core/script.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "tests/apps/pictures.hpp"
#include "tests/apps/process.hpp"

namespace depixel::test {
namespace {

/// What is wrong with a script, from its line on; empty if it is right.
std::string complaint(std::string_view script) {
  const TemporaryFolder folder;
  write_text(folder / "a.png", png_of(plain_picture(4, 3, {10, 20, 30, 255})));
  write_text(folder / "b.frames", script);
  const auto loaded = load_script(folder / "b.frames");
  if (loaded) return "";
  const auto at = loaded.error().message.find(".frames") + 7;
  return loaded.error().message.substr(at);
}

TEST(Script, SaysWhatIsWrongAndWhere) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"geometry 4x3\nshow a.png", ""},
      {"# nothing\n\n  geometry 4x3 8x8 # sizes\nshow a.png 3\nduplicate 2\nresize 2x2\nav_info 9x9\nrotate "
       "270",
       ""},
      {"", " shows no picture."},
      {"show a.png", " gives no geometry."},
      {"geometry 4x3\nshowing a.png", ", line 2: There is no action showing."},
      {"geometry 4",
       ", line 1: geometry takes a size such as 320x240 and perhaps a larger one, before the first "
       "picture."},
      {"geometry 4x3 3x4",
       ", line 1: geometry takes a size such as 320x240 and perhaps a larger one, before the "
       "first picture."},
      {"format rgba", ", line 1: format takes xrgb8888, rgb565 or 0rgb1555, before the first picture."},
      {"show a.png\nformat rgb565",
       ", line 2: format takes xrgb8888, rgb565 or 0rgb1555, before the first picture."},
      {"padding 6", ", line 1: padding takes a number of bytes that is a whole number of pixels."},
      {"format rgb565\npadding 6\n", " shows no picture."},
      {"show a.png 0", ", line 1: show takes pictures and perhaps a number of times."},
      {"duplicate", ", line 1: duplicate takes perhaps a number of times, after a picture."},
      {"rotate 45", ", line 1: rotate takes 0, 90, 180 or 270."}};
  for (const auto& [script, expected] : cases) EXPECT_EQ(complaint(script), expected) << script;
  EXPECT_NE(complaint("show absent.png").find("absent.png cannot be read: "), std::string::npos);
}

TEST(Script, PicturesAreConvertedAsTheFormatSays) {
  const TemporaryFolder folder;
  write_text(folder / "a.png", png_of(plain_picture(2, 2, {0xff, 0x81, 0x08, 0xff})));
  write_text(folder / "b.frames", "format rgb565\ngeometry 2x2\npadding 2\nshow a.png 2");
  const auto script = load_script(folder / "b.frames");
  ASSERT_TRUE(script) << script.error().message;
  EXPECT_EQ(script->actions.size(), 2U);
  ASSERT_EQ(script->frames.size(), 1U);
  EXPECT_EQ(script->frames[0].pitch, 6U);
  const std::vector<std::uint8_t> row{0x01, 0xfc, 0x01, 0xfc, 0xa5, 0xa5};
  EXPECT_TRUE(std::equal(row.begin(), row.end(), script->frames[0].bytes.begin()));
}

}  // namespace
}  // namespace depixel::test
