// The plug-in in RetroArch: what the window shows is what the library draws of the frame, pixel for pixel.

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "libdepixel/core/color.hpp"
#include "tests/apps/pictures.hpp"
#include "tests/retroarch/expected.hpp"
#include "tests/retroarch/games/games.hpp"
#include "tests/retroarch/play.hpp"
#include "tests/retroarch/retroarch_run.hpp"

namespace depixel::test {
namespace {

namespace fs = std::filesystem;

const fs::path kFilters = DEPIXEL_FILTER_FOLDER;
const fs::path kSequence = DEPIXEL_TEST_DATA "/sequences/alex4";  ///< 160 x 120, scrolls in layers

fs::path preset(const std::string& name) {
  return kFilters / ("Depixel-" + name + ".filt");
}

Picture last_frame() {
  std::set<fs::path> files;
  for (const auto& file : fs::directory_iterator(kSequence)) files.insert(file.path());
  return decoded(read_text(*files.rbegin()));
}

Picture cropped(const Picture& picture, int width, int height) {
  Picture part(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) part.at(x, y) = picture.at(x, y);
  }
  return part;
}

/// Runs a script of the test core, and expects what every run must be like.
class PlugIn : public testing::Test {
 protected:
  RetroArchRan play(const std::string& script, RetroArchRun wanted) {
    wanted.core = DEPIXEL_TEST_CORE;
    wanted.content = folder_ / "script.frames";
    write_text(wanted.content, script);
    return ended_well(run_retroarch(wanted));
  }

  /// Expects what every run with the plug-in must be like.
  static RetroArchRan ended_well(RetroArchRan ran) {
    EXPECT_EQ(ran.exit_code, 0) << ran.log;
    EXPECT_EQ(ran.errors, "");
    EXPECT_NE(ran.log.find("Found plug: Depixel (depixel)"), std::string::npos) << ran.log;
    return ran;
  }

  /// Writes pictures for a script; returns the path.
  std::string written(const std::string& name, const Picture& picture) {
    write_text(folder_ / name, png_of(picture));
    return folder_ / name;
  }

  /// Writes a preset of its own beside a link to the library.
  fs::path own_preset(const std::string& settings) {
    const fs::path link = folder_.path() / "depixel.so";
    if (!fs::exists(link)) fs::create_symlink(kFilters / "depixel.so", link);
    write_text(folder_ / "own.filt", "filter = depixel\n" + settings);
    return folder_.path() / "own.filt";
  }

  /// Expects a picture in the window. Leaves what was shown on disk, to be looked at, and the log, where it
  /// was another.
  void expect_shown(const Picture& expected, const RetroArchRan& ran, int levels = 0) {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = test->name();
    std::replace(name.begin(), name.end(), '/', '.');
    const fs::path stem = fs::path(DEPIXEL_TEST_OUTPUT) / name;
    fs::create_directories(stem.parent_path());
    write_text(stem.string() + ".png", png_of(ran.screenshot));
    const std::string found = mismatch(expected, ran.screenshot, levels);
    EXPECT_EQ(found, "");
    if (!found.empty()) write_text(stem.string() + ".log", ran.log);
  }

  TemporaryFolder folder_;
};

std::string scroll(const std::string& before = "") {
  return before + "geometry 160x120\nshow " + kSequence.string() + "\n";
}

int sequence_frames() {
  return static_cast<int>(std::distance(fs::directory_iterator(kSequence), fs::directory_iterator()));
}

TEST_F(PlugIn, ScrollingFramesOf32Bits) {
  expect_shown(depixelled(last_frame(), 4),
               play(scroll(), {.filter = preset("4x"), .frames = sequence_frames()}));
}

TEST_F(PlugIn, FramesOf16Bits) {
  expect_shown(depixelled(in_format(last_frame(), PixelFormat::rgb565), 4),
               play(scroll("format rgb565\n"), {.filter = preset("4x"), .frames = sequence_frames()}));
}

TEST_F(PlugIn, FramesOf15Bits) {
  expect_shown(depixelled(in_format(last_frame(), PixelFormat::xrgb1555), 4),
               play(scroll("format 0rgb1555\n"), {.filter = preset("4x"), .frames = sequence_frames()}));
}

TEST_F(PlugIn, RowsWithRoomAfterThem) {
  expect_shown(depixelled(last_frame(), 4),
               play(scroll("padding 96\n"), {.filter = preset("4x"), .frames = sequence_frames()}));
}

TEST_F(PlugIn, OnRetroArchsVideoThread) {
  expect_shown(
      depixelled(last_frame(), 4),
      play(scroll(), {.filter = preset("4x"), .frames = sequence_frames() + 4, .is_threaded = true}));
}

TEST_F(PlugIn, ByOpenGl) {
  for (const bool is_threaded : {false, true}) {
    expect_shown(
        depixelled(last_frame(), 4),
        play(scroll(),
             {.filter = preset("GL-4x"), .frames = sequence_frames() + 4, .is_threaded = is_threaded}),
        2);
  }
}

TEST_F(PlugIn, ByTheProcessorWhereThereIsNoOpenGl) {
  const RetroArchRan ran = play(scroll(), {.filter = preset("GL-4x"),
                                           .frames = sequence_frames(),
                                           .environment = {"__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null"}});
  expect_shown(depixelled(last_frame(), 4), ran);
  EXPECT_NE(
      ran.log.find("depixel: The processor draws instead of OpenGL. There is no OpenGL context to be had"),
      std::string::npos)
      << ran.log;
}

TEST_F(PlugIn, DuplicatesAndIdenticalFrames) {
  const std::string script =
      scroll() + "duplicate 5\nshow " + written("last.png", last_frame()) + " 5\nduplicate 5\n";
  for (const int more : {3, 8, 14}) {
    expect_shown(depixelled(last_frame(), 4),
                 play(script, {.filter = preset("4x"), .frames = sequence_frames() + more}));
  }
}

TEST_F(PlugIn, AllPresets) {
  const auto shown = [&](const std::string& name, int scale, const Options& options, int levels) {
    expect_shown(depixelled(last_frame(), scale, options),
                 play(scroll(), {.filter = preset(name), .frames = sequence_frames(), .scale = scale}),
                 levels);
  };
  shown("2x", 2, {}, 0);
  shown("3x", 3, {}, 0);
  shown("6x", 6, {}, 2);
  shown("8x", 8, {}, 2);
  shown("Smooth", 4, {.soft_contours = 20}, 0);
}

TEST_F(PlugIn, FractionalScales) {
  for (const double scale : {1.5, 2.5, 3.33}) {
    const auto own = own_preset(fmt::format("depixel_scale = \"{}\"\ndepixel_backend = \"cpu\"\n", scale));
    expect_shown(depixelled(last_frame(), scale),
                 ended_well(test::play(folder_, scroll(), scaled(160, scale), scaled(120, scale),
                                       {.filter = own, .frames = sequence_frames()})));
  }
}

TEST_F(PlugIn, ThreadsAndLinearLight) {
  const auto own =
      own_preset("depixel_threads = \"2\"\ndepixel_linear_light = \"true\"\ndepixel_backend = \"cpu\"\n");
  expect_shown(depixelled(last_frame(), 4, {.linear_light = true}),
               play(scroll(), {.filter = own, .frames = sequence_frames()}));
}

TEST_F(PlugIn, BadSettingsAreWarnedOf) {
  const auto own = own_preset("depixel_scale = \"huge\"\ndepixel_backend = \"cpu\"\n");
  const RetroArchRan ran = play(scroll(), {.filter = own, .frames = sequence_frames()});
  expect_shown(depixelled(last_frame(), 4), ran);
  EXPECT_NE(ran.log.find("depixel: The setting scale stays 4: \"huge\" is not a number from 1 to 16."),
            std::string::npos)
      << ran.log;
}

TEST_F(PlugIn, SmallerGeometryAndBack) {
  const std::string small = written("small.png", cropped(last_frame(), 80, 60));
  const std::string script = scroll() + "resize 80x60\nshow " + small + " 5\n";
  // The window stays as large: the picture is shown twice its size.
  expect_shown(enlarged(depixelled(cropped(last_frame(), 80, 60), 4), 2),
               play(script, {.filter = preset("4x"), .frames = sequence_frames() + 5}));
  const std::string back = script + "resize 160x120\nshow " + written("last.png", last_frame()) + " 5\n";
  expect_shown(depixelled(last_frame(), 4),
               play(back, {.filter = preset("4x"), .frames = sequence_frames() + 10}));
}

TEST_F(PlugIn, IsMadeAnewForAnotherMaximum) {
  const Picture frame = decoded(read_text(DEPIXEL_TEST_DATA "/frames/davegnukem_0052.png"));
  const std::string script =
      scroll() + "av_info 320x200\nshow " DEPIXEL_TEST_DATA "/frames/davegnukem_0052.png 8\n";
  for (const char* name : {"4x", "GL-4x"}) {
    const RetroArchRan ran = play(script, {.filter = preset(name), .frames = sequence_frames() + 8});
    expect_shown(depixelled(frame, 4), ran, std::string(name) == "4x" ? 0 : 2);
  }
}

TEST_F(PlugIn, FramesAboveTheMaximumAreCutToIt) {
  const std::string script = "geometry 100x80\nshow " + kSequence.string() + "\n";
  expect_shown(depixelled(cropped(last_frame(), 100, 80), 4),
               play(script, {.filter = preset("4x"), .frames = sequence_frames()}));
}

/// A core, and a game: one that a package ships, or one of our own.
struct Game {
  std::string core, file;
  Rom (*make)();  ///< nullptr for the former
};

class PlugInOn : public PlugIn, public testing::WithParamInterface<Game> {};

/// What a console shows is filtered as it is: its picture without a filter, depixelled, is the picture with
/// it.
TEST_P(PlugInOn, ShowsTheConsolesPictureDepixelled) {
  const Game& game = GetParam();
  fs::path content = game.file;
  if (game.make != nullptr) {
    content = folder_.path() / game.file;
    const Rom rom = game.make();
    write_text(content, {reinterpret_cast<const char*>(rom.data()), rom.size()});
  }
  RetroArchRun run{.core = fs::path(DEPIXEL_CORES) / (game.core + "_libretro.so"),
                   .content = content,
                   .frames = 120,
                   .scale = 1};
  const RetroArchRan raw = run_retroarch(run);
  ASSERT_EQ(raw.exit_code, 0) << raw.log;
  ASSERT_GT(raw.screenshot.width(), 0) << raw.log;
  std::set<std::uint32_t> colours;
  for (int y = 0; y < raw.screenshot.height(); ++y) {
    for (int x = 0; x < raw.screenshot.width(); ++x) colours.insert(rgba_order(pixel(raw.screenshot, x, y)));
  }
  EXPECT_GE(colours.size(), game.make == nullptr ? 2U : 4U) << "an empty screen proves nothing";
  run.scale = 4;
  for (const char* name : {"4x", "GL-4x"}) {
    run.filter = preset(name);
    expect_shown(depixelled(raw.screenshot, 4), ended_well(run_retroarch(run)),
                 std::string(name) == "4x" ? 0 : 2);
  }
}

INSTANTIATE_TEST_SUITE_P(Consoles, PlugInOn,
                         testing::Values(Game{"nestopia", "/usr/share/nes/efp.nes", nullptr},
                                         Game{"gambatte", "faces.gb", game_boy_rom},
                                         Game{"mgba", "faces.gba", game_boy_advance_rom},
                                         Game{"bsnes_mercury_balanced", "faces.sfc", super_nintendo_rom}),
                         [](const auto& test) { return test.param.core; });

}  // namespace
}  // namespace depixel::test
