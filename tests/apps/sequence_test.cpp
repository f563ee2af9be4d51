// Sequences, of which only what changed is computed and drawn: their pictures are those of frames drawn
// alone.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>

#include "tests/apps/pictures.hpp"
#include "tests/apps/process.hpp"

namespace depixel::test {
namespace {

using Flags = std::vector<std::string>;

class Sequence : public testing::Test {
 protected:
  /// Writes frames as clip/00.png and so on.
  void write(const std::vector<Picture>& frames) {
    std::filesystem::create_directory(folder_ / "clip");
    for (std::size_t i = 0; i < frames.size(); ++i) {
      write_text(folder_ / fmt::format("clip/{:02}.png", i), png_of(frames[i]));
    }
  }

  Ended run(Flags flags, const std::string& program = DEPIXEL_PROGRAM) const {
    flags.insert(flags.end(), {folder_ / "clip", "-o", folder_ / "out/"});
    return run_program(program, flags);
  }

  /// That a run over all frames writes what runs over each one write.
  void expect_frames_as_alone(const Flags& flags) const {
    std::filesystem::remove_all(folder_ / "out");
    const Ended all = run(flags);
    ASSERT_EQ(all.exit_code, 0) << all.err;
    for (const std::string& name : folder_.names("out")) {
      const std::string stem = name.substr(0, name.find('.'));
      Flags alone = flags;
      alone.insert(alone.end(), {folder_ / ("clip/" + stem + ".png"), "-o", "-"});
      EXPECT_TRUE(read_text(folder_ / ("out/" + name)) == run_depixel(alone).out)
          << name << " of " << fmt::format("{}", fmt::join(flags, " "));
    }
  }

  TemporaryFolder folder_;
};

/// The number that follows a key of a JSON object.
std::int64_t number_after(const std::string& json, const std::string& key) {
  std::smatch found;
  return std::regex_search(json, found, std::regex('"' + key + "\":([0-9]+)")) ? std::stoll(found[1]) : -1;
}

TEST_F(Sequence, IsDrawnAsItsFramesAlone) {
  write(sample_frames(32, 20, 9));
  for (const Flags& flags : std::vector<Flags>{{},
                                               {"--scale", "3.7", "--threads", "2"},
                                               {"--scale", "0.6"},
                                               {"--size", "100x100", "--linear-light"},
                                               {"--similarity", "merge", "--connect-lines"},
                                               {"--format", "svg"},
                                               {"--stage", "simplified", "--scale", "4"}}) {
    expect_frames_as_alone(flags);
  }
}

TEST_F(Sequence, IsDrawnAsItsFramesAloneByOpenGl) {
  write(sample_frames(32, 20, 5));
  expect_frames_as_alone({"--backend", "gl"});
}

TEST_F(Sequence, MayChangeItsSize) {
  std::vector<Picture> frames = sample_frames(24, 16, 2);
  for (const Picture& turned : sample_frames(16, 24, 2)) frames.push_back(turned);  // as many pixels
  for (const Picture& small : sample_frames(8, 8, 2)) frames.push_back(small);
  for (const Picture& again : sample_frames(24, 16, 4)) frames.push_back(again);
  write(frames);
  expect_frames_as_alone({});
  expect_frames_as_alone({"--size", "90x90"});
}

TEST_F(Sequence, MayBecomeTransparentAndOpaqueAgain) {
  std::vector<Picture> frames = sample_frames(24, 16, 6);
  for (const std::size_t i : {2, 3}) frames[i].at(5, 5) = {};
  write(frames);
  expect_frames_as_alone({});
}

TEST_F(Sequence, CountsOnlyWhatChanged) {
  write(sample_frames(32, 20, 8));
  const Ended ended = run({"--stats=json"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const auto count = [&](const char* key) { return number_after(ended.out, key); };
  EXPECT_EQ(count("frames"), 8);
  EXPECT_EQ(count("pixels"), 8 * 640);
  EXPECT_GT(count("changed_pixels"), 640);
  EXPECT_LT(count("changed_pixels"), 8 * 640);
  EXPECT_GT(count("recomputed_blocks"), 0);
  EXPECT_GT(count("contours"), 0);
  EXPECT_GT(count("cache_hits"), 0);
  EXPECT_GT(count("fitted_shapes"), 0);
  EXPECT_GT(count("segments"), 0);
  EXPECT_LE(count("changed_tiles") + count("moved_tiles"), 8 * 640);
  EXPECT_LT(count("drawn_pixels"), 8 * 640 * 16) << "all of the output";
  EXPECT_EQ(count("upload_bytes"), 0);
}

TEST_F(Sequence, OfOneStillFrameIsDrawnOnce) {
  write(std::vector<Picture>(4, sample_picture(12, 8)));
  const Ended ended = run({"--stats=json"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const auto count = [&](const char* key) { return number_after(ended.out, key); };
  EXPECT_EQ(count("frames"), 4);
  EXPECT_EQ(count("changed_pixels"), 96);
  EXPECT_EQ(count("changed_tiles"), 96);
  EXPECT_EQ(count("moved_tiles"), 0);
  EXPECT_EQ(count("drawn_pixels"), 96 * 16);
}

TEST_F(Sequence, IsCheckedAndFoundRight) {
  write(sample_frames(32, 20, 9));
  for (const Flags& flags : std::vector<Flags>{{}, {"--format", "svg"}, {"--backend", "gl"}}) {
    Flags checked = flags;
    checked.emplace_back("--check-incremental");
    const Ended ended = run(checked);
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_EQ(ended.err, "");
  }
}

TEST_F(Sequence, IsCheckedAndTheFrameNamedThatDiffers) {
  write(sample_frames(32, 20, 4));
  EXPECT_EQ(run({}, DEPIXEL_WITH_FAULT).exit_code, 0) << "nobody looks";
  std::filesystem::remove_all(folder_ / "out");
  for (const char* backend : {"cpu", "gl"}) {
    const Ended ended = run({"--check-incremental", "--backend", backend}, DEPIXEL_WITH_FAULT);
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_TRUE(ended.is_one_sentence()) << ended.err;
    EXPECT_NE(ended.err.find("Frame 01: The map"), std::string::npos) << ended.err;
    EXPECT_EQ(folder_.names("out"), std::vector<std::string>{"00.png"});
  }
}

}  // namespace
}  // namespace depixel::test
