// The plug-in frame by frame, and its colours: what is kept from frame to frame is never seen.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "apps/common/inputs.hpp"
#include "tests/apps/pictures.hpp"
#include "tests/retroarch/expected.hpp"
#include "tests/retroarch/play.hpp"

namespace depixel::test {
namespace {

namespace fs = std::filesystem;

constexpr double kFrameScale = 4;

std::string preset_text(const std::string& name) {
  return DEPIXEL_FILTER_FOLDER "/Depixel-" + name + ".filt";
}

/// The frames of a shipped sequence, in order.
std::vector<fs::path> frames_of(const std::string& sequence) {
  return find_inputs({DEPIXEL_TEST_DATA "/sequences/" + sequence}).value().files;
}

/// Expects a run to have ended well, and to have shown what the filter makes of a frame.
void expect_depixelled(const RetroArchRan& ran, const Picture& frame, double scale, const std::string& what) {
  EXPECT_EQ(ran.exit_code, 0) << what << ran.log;
  EXPECT_EQ(ran.errors, "") << what;
  EXPECT_NE(ran.log.find("Found plug: Depixel (depixel)"), std::string::npos) << what << ran.log;
  EXPECT_EQ(mismatch(depixelled(frame, scale), ran.screenshot), "") << what;
}

/// Expects a sequence to be drawn right up to its n-th frame.
void expect_drawn_up_to(std::size_t count, const std::string& sequence, const std::string& name, double scale,
                        bool is_threaded = false) {
  const TemporaryFolder folder;
  const fs::path file = frames_of(sequence)[count - 1];
  const Picture frame = decoded(read_text(file));
  const std::string script = "geometry " + std::to_string(frame.width()) + 'x' +
                             std::to_string(frame.height()) + "\nshow " + file.parent_path().string() + '\n';
  const RetroArchRan ran =
      play(folder, script, scaled(frame.width(), scale), scaled(frame.height(), scale),
           {.filter = preset_text(name), .frames = static_cast<int>(count), .is_threaded = is_threaded});
  expect_depixelled(ran, frame, scale, file.string() + ' ' + name);
}

TEST(PlugInFrames, EveryFrameOfAScrollIsAsFromScratch) {
  for (std::size_t count = 1; count <= frames_of("alex4").size(); ++count) {
    expect_drawn_up_to(count, "alex4", "4x", kFrameScale);
  }
}

TEST(PlugInFrames, ShippedSequencesAreAsFromScratch) {
  for (const std::string sequence : {"davegnukem", "jumpnbump"}) {
    expect_drawn_up_to(frames_of(sequence).size(), sequence, "2x", 2);
    expect_drawn_up_to(frames_of(sequence).size(), sequence, "4x", kFrameScale);
  }
}

TEST(PlugInFrames, OpenGlDrawsTheSameTwice) {
  const TemporaryFolder folder;
  const std::string script = "geometry 160x120\nshow " DEPIXEL_TEST_DATA "/sequences/alex4\n";
  const auto shown = [&] {
    return play(folder, script, 640, 480, {.filter = preset_text("GL-4x"), .frames = 8}).screenshot;
  };
  EXPECT_EQ(mismatch(shown(), shown()), "");
}

TEST(PlugInFrames, ColoursOf16BitsAreThoseWithoutAFilter) {
  const TemporaryFolder folder;
  const Picture picture = colourful_picture(96, 72);
  write_text(folder / "a.png", png_of(picture));
  for (const auto& [name, format] :
       {std::pair("rgb565", PixelFormat::rgb565), std::pair("0rgb1555", PixelFormat::xrgb1555)}) {
    const std::string script = std::string("format ") + name + "\npadding 6\ngeometry 96x72\nshow a.png\n";
    expect_depixelled(play(folder, script, 384, 288, {.filter = preset_text("4x"), .frames = 5}),
                      in_format(picture, format), kFrameScale, name);
  }
}

TEST(PlugInFrames, IsTurnedAfterItWasDrawn) {
  const TemporaryFolder folder;
  const Picture picture = sample_picture(96, 72);
  write_text(folder / "a.png", png_of(picture));
  Picture turned = depixelled(picture, kFrameScale);
  for (const int degrees : {0, 90, 180, 270}) {
    const std::string script = "geometry 96x72\nrotate " + std::to_string(degrees) + "\nshow a.png\n";
    const RetroArchRan ran =
        play(folder, script, turned.width(), turned.height(), {.filter = preset_text("4x"), .frames = 5});
    EXPECT_EQ(mismatch(turned, ran.screenshot), "") << degrees;
    turned = turned_left(turned);
  }
}

}  // namespace
}  // namespace depixel::test
