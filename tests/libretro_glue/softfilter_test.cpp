#include <gtest/gtest.h>
#include <malloc.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <thread>

#include "libdepixel/pipeline/vectorizer.hpp"
#include "libdepixel/raster/cpu_raster.hpp"
#include "tests/libretro_glue/softfilter_host.hpp"
#include "tests/support/random_sequences.hpp"
#include "tests/support/test_pictures.hpp"

namespace depixel::test {
namespace {

using softfilter::kRgb565, softfilter::kXrgb8888;

const SoftfilterLibrary& plug_in() {
  static const SoftfilterLibrary kLibrary(DEPIXEL_SOFTFILTER);
  return kLibrary;
}

/// What the library makes of a picture from scratch.
Picture expected(const Picture& picture, double scale, const Options& options = {}) {
  Vectorizer vectorizer;
  const PlanarMap& map = vectorizer.vectorize(picture.view(), options);
  Picture drawn(static_cast<int>(std::round(picture.width * scale)),
                static_cast<int>(std::round(picture.height * scale)));
  CpuRaster().draw(map, View::fit(map.lattice, drawn.width, drawn.height), options.linear_light, 1,
                   drawn.target());
  return drawn;
}

Picture crop(const Picture& picture, int width, int height) {
  Picture part(std::min(width, picture.width), std::min(height, picture.height));
  paste(part, picture, 0, 0);
  return part;
}

int largest_difference(const Picture& a, const Picture& b) {
  return compare(a, b).largest;
}

std::vector<Picture> shipped_sequence(const std::string& name) {
  std::set<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(data_folder() / "sequences" / name)) {
    files.insert(file.path());
  }
  std::vector<Picture> frames;
  frames.reserve(files.size());
  for (const auto& file : files) frames.push_back(load_picture(file));
  return frames;
}

TEST(Softfilter, TellsWhatItIs) {
  EXPECT_EQ(plug_in()->api_version, softfilter::kApiVersion);
  EXPECT_STREQ(plug_in()->short_ident, "depixel");
  EXPECT_EQ(plug_in()->query_input_formats(), kRgb565 | kXrgb8888);
  EXPECT_EQ(plug_in()->query_output_formats(kRgb565), kXrgb8888);
  EXPECT_EQ(plug_in()->query_output_formats(kXrgb8888), kXrgb8888);
}

TEST(Softfilter, ExportsItsEntryPointAlone) {
  FILE* pipe = popen("nm -D --defined-only '" DEPIXEL_SOFTFILTER "'", "r");
  ASSERT_NE(pipe, nullptr);
  std::string symbols;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) symbols += static_cast<char>(c);
  ASSERT_EQ(pclose(pipe), 0);
  EXPECT_TRUE(std::regex_match(symbols, std::regex("[0-9a-f]+ T softfilter_get_implementation\n")))
      << symbols;
}

/// Sequences of sizes that change, in rows with room after them, at any scale.
RC_GTEST_PROP(Softfilter, DrawsWhatTheLibraryDrawsFromScratch, (const Sequence& sequence)) {
  const unsigned format = *rc::gen::element(kRgb565, kXrgb8888);
  const std::string scale = *rc::gen::element<std::string>("1", "1.5", "2", "3", "3.33", "4", "6", "8");
  const std::string threads = *rc::gen::element<std::string>("1", "2", "3");
  const bool linear_light = *rc::gen::arbitrary<bool>();
  unsigned width = 1, height = 1;
  for (const SequenceFrame& frame : sequence.frames) {
    width = std::max(width, static_cast<unsigned>(frame.picture.width));
    height = std::max(height, static_cast<unsigned>(frame.picture.height));
  }
  SoftfilterHost host(plug_in(),
                      {{"scale", scale},
                       {"backend", "cpu"},
                       {"threads", threads},
                       {"linear_light", linear_light ? "true" : "false"}},
                      format, width, height, 4);
  for (const SequenceFrame& frame : sequence.frames) {
    const CoreFrame packed = pack(frame.picture, format, *rc::gen::inRange<std::size_t>(0, 9) * 4);
    const Picture shown = unpack(packed, format);
    RC_ASSERT(host.filter(packed) == expected(shown, std::stod(scale), {.linear_light = linear_light}));
  }
}

TEST(Softfilter, DrawsShippedSequencesAsTheLibraryDoes) {
  for (const char* name : {"alex4", "davegnukem", "jumpnbump"}) {
    const std::vector<Picture> frames = shipped_sequence(name);
    ASSERT_FALSE(frames.empty());
    for (const unsigned format : {kRgb565, kXrgb8888}) {
      SoftfilterHost host(plug_in(), {{"scale", "4"}, {"backend", "cpu"}, {"threads", "2"}}, format,
                          static_cast<unsigned>(frames[0].width), static_cast<unsigned>(frames[0].height), 2);
      for (const Picture& frame : frames) {
        const CoreFrame packed = pack(frame, format, 64);
        ASSERT_EQ(largest_difference(host.filter(packed), expected(unpack(packed, format), 4)), 0) << name;
      }
    }
  }
}

TEST(Softfilter, HasAllOptionsAsSettings) {
  const Picture picture = load_picture(data_folder() / "sprites" / "minetest_game_default_apple.png");
  const CoreFrame packed = pack(picture, kXrgb8888, 0);
  const Picture shown = unpack(packed, kXrgb8888);
  const auto drawn = [&](const Preset& preset) {
    Preset all{{"scale", "4"}, {"backend", "cpu"}};
    all.insert(preset.begin(), preset.end());
    return SoftfilterHost(plug_in(), all, kXrgb8888, packed.width, packed.height).filter(packed);
  };
  EXPECT_EQ(drawn({{"similarity", "merge"}}), expected(shown, 4, {.similarity = Similarity::merge}));
  EXPECT_EQ(drawn({{"similarity", "merge"}, {"merge_luma", "48"}}),
            expected(shown, 4, {.similarity = Similarity::merge, .merge_luma = 48}));
  EXPECT_EQ(drawn({{"connect_lines", "true"}}), expected(shown, 4, {.connect_lines = true}));
  EXPECT_EQ(drawn({{"smoothing", "none"}, {"spline", "adaptive"}}),
            expected(shown, 4, {.spline = SplineKind::adaptive, .smoothing = Smoothing::none}));
  EXPECT_EQ(drawn({{"curve_weight", "0"}, {"sparse_weight", "3.5"}, {"island_weight", "9"}}),
            expected(shown, 4, {.curve_weight = 0, .sparse_weight = 3.5, .island_weight = 9}));
}

TEST(Softfilter, BadSettingsAreWarnedOfAndTheGameGoesOn) {
  const Picture picture = ascii_picture({"#..r", ".rr.", ".#g#"});
  const CoreFrame packed = pack(picture, kXrgb8888, 0);
  testing::internal::CaptureStderr();
  SoftfilterHost host(plug_in(),
                      {{"scale", "huge"}, {"backend", "cpu"}, {"smoothing", "strong"}, {"threads", "0"}},
                      kXrgb8888, 4, 3);
  const std::string told = testing::internal::GetCapturedStderr();
  EXPECT_EQ(host.filter(packed), expected(picture, 4));
  EXPECT_NE(told.find("depixel: The setting scale stays 4: \"huge\" is not a number from 1 to 16.\n"),
            std::string::npos)
      << told;
  EXPECT_NE(told.find("smoothing"), std::string::npos) << told;
  EXPECT_NE(told.find("threads"), std::string::npos) << told;
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 3) << told;
}

TEST(Softfilter, SaysWhyItMakesNoFilter) {
  testing::internal::CaptureStderr();
  EXPECT_THROW(SoftfilterHost(plug_in(), {}, kXrgb8888, 0, 240), std::runtime_error);
  EXPECT_THROW(SoftfilterHost(plug_in(), {}, kXrgb8888, 4'000'000'000U, 240), std::runtime_error);
  EXPECT_THROW(SoftfilterHost(plug_in(), {}, 4, 320, 240), std::runtime_error);
  const std::string told = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 3) << told;
  EXPECT_NE(told.find("depixel: Frames of up to 0 x 240 pixels cannot be filtered"), std::string::npos)
      << told;
}

TEST(Softfilter, LowersAScaleThatTexturesDoNotHold) {
  testing::internal::CaptureStderr();
  const SoftfilterHost host(plug_in(), {{"scale", "16"}, {"backend", "cpu"}}, kXrgb8888, 2048, 16);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("8 times"), std::string::npos);
  EXPECT_LE(host.buffer().size(), std::size_t{4} * 16384 * 128 + 8192);
}

TEST(Softfilter, FramesAboveTheMaximumAreCutToIt) {
  const Picture picture = shipped_sequence("alex4").front();
  const CoreFrame packed = pack(picture, kXrgb8888, 12);
  SoftfilterHost host(plug_in(), {{"scale", "3"}, {"backend", "cpu"}}, kXrgb8888, 100, 90);
  EXPECT_EQ(host.filter(packed), expected(crop(unpack(packed, kXrgb8888), 100, 90), 3));
}

TEST(Softfilter, AFrameWithoutPitchIsTheOneBefore) {
  const Picture first = ascii_picture({"#..r", ".rr.", ".#g#"}), other = ascii_picture({"#.", ".r"});
  SoftfilterHost host(plug_in(), {{"scale", "4"}, {"backend", "cpu"}}, kXrgb8888, 4, 3);
  const CoreFrame packed = pack(first, kXrgb8888, 20), small = pack(other, kXrgb8888, 0);
  EXPECT_EQ(host.filter(packed), expected(first, 4));
  EXPECT_EQ(host.filter(packed, 0), expected(first, 4));
  EXPECT_EQ(host.filter(small, 0), expected(other, 4));
}

TEST(Softfilter, AnOversizedFrameWithoutPitchIsTheOneBefore) {
  const Picture picture = shipped_sequence("alex4").front();
  const CoreFrame packed = pack(picture, kXrgb8888, 12);
  SoftfilterHost host(plug_in(), {{"scale", "2"}, {"backend", "cpu"}}, kXrgb8888, 100, 90);
  const Picture first = host.filter(packed);
  EXPECT_EQ(host.filter(packed, 0), first);
}

TEST(Softfilter, WritesOnlyWhatChanged) {
  Picture picture = shipped_sequence("jumpnbump").front();
  for (Rgba& c : picture.pixels) c.a = 255;
  SoftfilterHost host(plug_in(), {{"scale", "4"}, {"backend", "cpu"}}, kXrgb8888,
                      static_cast<unsigned>(picture.width), static_cast<unsigned>(picture.height));
  host.filter(pack(picture, kXrgb8888, 0));
  host.scribble();
  const std::vector<std::uint8_t> before = host.buffer();
  host.filter(pack(picture, kXrgb8888, 0));
  EXPECT_EQ(host.buffer(), before);
  picture.at(50, 60) = {255, 0, 255, 255};
  host.filter(pack(picture, kXrgb8888, 0));
  std::size_t written = 0;
  for (std::size_t i = 0; i < before.size(); ++i) written += before[i] != host.buffer()[i] ? 1 : 0;
  EXPECT_GT(written, 0U);
  EXPECT_LT(written, before.size() / 20);
}

TEST(Softfilter, DrawsAllWhereTheBufferIsAnother) {
  const Picture picture = ascii_picture({"#..r", ".rr.", ".#g#"});
  const CoreFrame packed = pack(picture, kXrgb8888, 0);
  SoftfilterHost host(plug_in(), {{"scale", "4"}, {"backend", "cpu"}}, kXrgb8888, 4, 3);
  host.filter(packed);
  host.scribble();
  host.move_buffer();
  EXPECT_EQ(host.filter(packed), expected(picture, 4));
}

TEST(Softfilter, TenThousandFramesOfAnySizeTakeNoMoreMemory) {
  const std::vector<Picture> frames = shipped_sequence("alex4");
  SoftfilterHost host(plug_in(), {{"scale", "2"}, {"backend", "cpu"}}, kXrgb8888, 160, 120);
  const auto play = [&](int count) {
    for (int i = 0; i < count; ++i) {
      const Picture part = crop(frames[std::size_t(i) % frames.size()], 8 + i * 7 % 40, 8 + i / 50 * 5 % 30);
      host.filter(pack(part, kXrgb8888, std::size_t(i % 3) * 4));
    }
  };
  play(5000);
  const auto before = mallinfo2().uordblks;
  play(5000);
  EXPECT_LE(static_cast<double>(mallinfo2().uordblks), static_cast<double>(before) * 1.05 + 65536);
}

TEST(Softfilter, IsRecreatedAndOpenedAnew) {
  const Picture picture = ascii_picture({"#..r", ".rr.", ".#g#"});
  for (int i = 0; i < 50; ++i) {
    const SoftfilterLibrary library(DEPIXEL_SOFTFILTER);
    const unsigned format = i % 2 == 0 ? kXrgb8888 : kRgb565;
    SoftfilterHost host(library, {{"scale", "2"}, {"backend", "cpu"}, {"threads", "2"}}, format,
                        4 + static_cast<unsigned>(i), 3, 2);
    const CoreFrame packed = pack(picture, format, 0);
    if (i % 3 != 0) {
      EXPECT_EQ(host.filter(packed), expected(unpack(packed, format), 2));
    }
  }
}

TEST(Softfilter, ManyAtOnceOnThreadsOfTheirOwn) {
  const std::vector<Picture> frames = shipped_sequence("alex4");
  std::vector<std::thread> hosts;
  std::vector<int> wrong(4, 0);
  hosts.reserve(wrong.size());
  for (int i = 0; i < 4; ++i) {
    hosts.emplace_back([&, i] {
      SoftfilterHost host(plug_in(),
                          {{"scale", "2"}, {"backend", "cpu"}, {"threads", std::to_string(1 + i % 2)}},
                          kXrgb8888, 160, 120, 2);
      for (std::size_t k = 0; k < 6; ++k) {
        const Picture shown =
            unpack(pack(frames[(k + std::size_t(i)) % frames.size()], kXrgb8888, 0), kXrgb8888);
        if (host.filter(pack(shown, kXrgb8888, 0)) != expected(shown, 2)) ++wrong[std::size_t(i)];
      }
    });
  }
  for (std::thread& host : hosts) host.join();
  EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

class SoftfilterByOpenGl : public testing::Test {};

/// The rasterisers differ by a level or two of rounding; what is kept and what is drawn anew do not differ.
TEST_F(SoftfilterByOpenGl, DrawsSequencesAsTheProcessorDoes) {
  const std::vector<Picture> frames = shipped_sequence("alex4");
  SoftfilterHost host(plug_in(), {{"scale", "4"}, {"backend", "gl"}}, kXrgb8888, 160, 120);
  for (const Picture& frame : frames) {
    const CoreFrame packed = pack(frame, kXrgb8888, 0);
    const Picture drawn = host.filter(packed);
    ASSERT_LE(largest_difference(drawn, expected(unpack(packed, kXrgb8888), 4)), 4);
    SoftfilterHost fresh(plug_in(), {{"scale", "4"}, {"backend", "gl"}}, kXrgb8888, 160, 120);
    ASSERT_EQ(fresh.filter(packed), drawn);
  }
}

TEST_F(SoftfilterByOpenGl, DrawsFramesOfChangingSizes) {
  const std::vector<Picture> frames = shipped_sequence("alex4");
  SoftfilterHost host(plug_in(), {{"scale", "3.33"}, {"backend", "gl"}}, kRgb565, 160, 120);
  for (int i = 0; i < 30; ++i) {
    const CoreFrame packed =
        pack(crop(frames[std::size_t(i) % frames.size()], 20 + i * 37 % 140, 20 + i % 4 * 30), kRgb565,
             std::size_t(i % 3) * 2);
    ASSERT_LE(largest_difference(host.filter(packed), expected(unpack(packed, kRgb565), 3.33)), 4) << i;
  }
}

TEST_F(SoftfilterByOpenGl, IsLeftToTheProcessorWhereItIsSoftware) {
  const Picture picture = ascii_picture({"#..r", ".rr.", ".#g#"});
  SoftfilterHost host(plug_in(), {{"scale", "4"}, {"backend", "auto"}}, kXrgb8888, 4, 3);
  EXPECT_LE(largest_difference(host.filter(pack(picture, kXrgb8888, 0)), expected(picture, 4)), 4);
}

TEST(Installed, LibraryAndPresetsStandTogetherAlone) {
  const std::filesystem::path prefix = output_folder() / "installed";
  std::filesystem::remove_all(prefix);
  const std::string command = "\"" DEPIXEL_CMAKE "\" --install \"" DEPIXEL_BUILD
                              "\" --component plug_in --prefix \"" +
                              prefix.string() + "\" >&2";
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::set<std::string> names;
  std::filesystem::path library;
  for (const auto& file : std::filesystem::recursive_directory_iterator(prefix)) {
    if (!file.is_regular_file()) continue;
    EXPECT_EQ(file.path().parent_path().filename(), "depixel");
    names.insert(file.path().filename());
    if (file.path().extension() == ".so") library = file.path();
  }
  EXPECT_EQ(names, (std::set<std::string>{"depixel.so", "Depixel-2x.filt", "Depixel-3x.filt",
                                          "Depixel-4x.filt", "Depixel-6x.filt", "Depixel-8x.filt",
                                          "Depixel-GL-4x.filt", "Depixel-Smooth.filt"}));
  EXPECT_STREQ(SoftfilterLibrary(library)->short_ident, "depixel");
}

/// Presets name every setting that there is, so that none is hidden from the user.
TEST(Presets, NameAllSettings) {
  int presets = 0;
  for (const auto& file : std::filesystem::directory_iterator(DEPIXEL_FILTER_FOLDER)) {
    if (file.path().extension() != ".filt") continue;
    ++presets;
    std::ifstream in(file.path());
    Preset preset;
    std::string filter;
    for (std::string line; std::getline(in, line);) {
      static const std::regex kSetting("depixel_([a-z_]+) = \"([^\"]*)\""), kFilter("filter = (.*)");
      std::smatch match;
      if (std::regex_match(line, match, kSetting))
        preset[match[1]] = match[2];
      else if (std::regex_match(line, match, kFilter))
        filter = match[1];
      else
        EXPECT_TRUE(line.empty() || line.front() == '#') << file.path() << ": " << line;
    }
    EXPECT_EQ(filter, "depixel") << file.path();
    std::set<std::string> keys{"scale", "backend"}, named;
    for (const OptionInfo& option : option_table()) {
      std::string key(option.name);
      std::replace(key.begin(), key.end(), '-', '_');
      keys.insert(key);
    }
    for (const auto& [key, value] : preset) named.insert(key);
    EXPECT_EQ(named, keys) << file.path();
    testing::internal::CaptureStderr();
    const SoftfilterHost host(plug_in(), preset, kXrgb8888, 320, 240, 4);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << file.path();
  }
  EXPECT_EQ(presets, 7);
}

}  // namespace
}  // namespace depixel::test
