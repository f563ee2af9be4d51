// Every option of depixel, its exit codes, and what it tells.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "libdepixel/core/options.hpp"
#include "tests/apps/pictures.hpp"
#include "tests/apps/process.hpp"

namespace depixel::test {
namespace {

class CommandLine : public testing::Test {
 protected:
  void SetUp() override { write_text(in_, png_of(sample_picture(12, 8))); }

  /// Draws the sample with some flags more. \return the PNG.
  std::string draw(std::vector<std::string> flags) const {
    flags.insert(flags.end(), {in_, "-o", "-"});
    const Ended run = run_depixel(flags);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "") << "nothing to tell";
    return run.out;
  }

  TemporaryFolder folder_;
  std::string in_ = folder_ / "in.png", out_ = folder_ / "out.png";
};

void expect_size(const std::string& png, int width, int height) {
  const Picture picture = decoded(png);
  EXPECT_EQ(picture.width(), width);
  EXPECT_EQ(picture.height(), height);
}

TEST_F(CommandLine, DrawsFourTimesAsLargeByDefault) {
  expect_size(draw({}), 48, 32);
}

TEST_F(CommandLine, RoundsFractionalScales) {
  expect_size(draw({"-s", "2.46"}), 30, 20);
  expect_size(draw({"--scale", "0.55"}), 7, 4);
  expect_size(draw({"--scale=1"}), 12, 8);
}

TEST_F(CommandLine, StretchesToASize) {
  expect_size(draw({"--size", "100x9"}), 100, 9);
}

TEST_F(CommandLine, KeepsTheColoursAtPixelCentres) {
  const Picture source = sample_picture(12, 8), picture = decoded(draw({"-s", "15"}));
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 12; ++x) EXPECT_EQ(pixel(picture, 15 * x + 7, 15 * y + 7), pixel(source, x, y));
  }
}

TEST_F(CommandLine, TakesEveryOptionOfTheTable) {
  for (const OptionInfo& option : option_table()) {
    const std::string flag = fmt::format("--{}", option.name);
    if (const auto* choice = std::get_if<ChoiceOption>(&option.kind)) {
      for (const auto name : choice->names) expect_size(draw({flag, std::string(name)}), 48, 32);
    } else if (const auto* number = std::get_if<NumberOption>(&option.kind)) {
      for (const double value : {number->minimum, number->maximum}) draw({flag, fmt::format("{}", value)});
    } else if (const auto* count = std::get_if<CountOption>(&option.kind)) {
      draw({flag, fmt::format("{}", count->minimum + 1)});
    } else {
      draw({flag});
    }
  }
}

TEST_F(CommandLine, OptionsReachThePicture) {
  const std::string usual = draw({});
  EXPECT_TRUE(draw({"--linear-light"}) != usual);
  EXPECT_TRUE(draw({"--smoothing", "none"}) != usual);
  EXPECT_TRUE(draw({"--spline", "approximate"}) != draw({"--spline", "interpolate"}));
  EXPECT_TRUE(draw({"--similarity", "exact", "--threads", "2"}) == usual);
  const auto svg_bytes = [this](const char* tolerance) {
    return draw({"--format", "svg", "--svg-tolerance", tolerance}).size();
  };
  EXPECT_LT(svg_bytes("0.1"), svg_bytes("0"));
}

TEST_F(CommandLine, RefusesOptionsOutOfRange) {
  for (const OptionInfo& option : option_table()) {
    if (std::holds_alternative<SwitchOption>(option.kind)) continue;
    for (const char* value : {"", "-1", "nan", "inf", "1e300", "0x10", "nonsense", "1 ", "exact,merge"}) {
      const Ended run = run_depixel({in_, "-o", out_, fmt::format("--{}", option.name), value});
      EXPECT_EQ(run.exit_code, 2) << option.name << " " << value;
      EXPECT_TRUE(run.is_one_sentence()) << run.err;
    }
  }
}

TEST_F(CommandLine, SaysThatCountsAreWhole) {
  const Ended run = run_depixel({in_, "-o", out_, "--threads", "0.5"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("\"0.5\" is not a whole number from 1 to "), std::string::npos) << run.err;
}

TEST_F(CommandLine, RefusesWrongUsage) {
  const std::vector<std::vector<std::string>> wrong{
      {},
      {in_},
      {"-o", out_},
      {in_, "-o"},
      {in_, "-o", out_, "--nonsense"},
      {in_, "-o", out_, "-s", "0"},
      {in_, "-o", out_, "-s", "-2"},
      {in_, "-o", out_, "-s", "nan"},
      {in_, "-o", out_, "-s", "inf"},
      {in_, "-o", out_, "-s", "1e9"},
      {in_, "-o", out_, "-s", "2x"},
      {in_, "-o", out_, "-s", "2", "-s", "3"},
      {in_, "-o", out_, "-s", "2", "--size", "20x20"},
      {in_, "-o", out_, "--size", "0x10"},
      {in_, "-o", out_, "--size", "10"},
      {in_, "-o", out_, "--size", "10x"},
      {in_, "-o", out_, "--size", "-10x10"},
      {in_, "-o", out_, "--size", "99999999999x10"},
      {in_, "-o", out_, "--stage", "nonsense"},
      {in_, "-o", out_, "--format", "gif"},
      {in_, "-o", out_, "--format", "svg"},
      {in_, "-o", out_, "--svg-tolerance", "-0.1"},
      {in_, "-o", out_, "--svg-tolerance", "0.6"},
      {in_, "-o", out_, "--svg-tolerance", "nan"},
      {in_, "-o", out_, "--stats=xml"},
      {in_, "-o", "-", "--stats=json"},
      {in_, "-o", folder_ / "out.jpg"},
      {in_, "-o", folder_ / "out"},
      {in_, "-o", ""},
      {in_, in_, "-o", "-"},
      {in_, in_, "-o", out_},
  };
  for (const auto& arguments : wrong) {
    const Ended run = run_depixel(arguments);
    EXPECT_EQ(run.exit_code, 2) << fmt::format("{}", fmt::join(arguments, " "));
    EXPECT_TRUE(run.is_one_sentence()) << run.err;
    EXPECT_EQ(run.out, "");
  }
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"in.png"});
}

TEST_F(CommandLine, HelpNamesEveryFlag) {
  const Ended run = run_depixel({"--help"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err, "");
  for (const OptionInfo& option : option_table()) {
    EXPECT_NE(run.out.find(fmt::format("--{} ", option.name)), std::string::npos) << option.name;
  }
  for (const char* flag : {"--output", "--scale", "--size", "--stage", "--format", "--verify",
                           "--check-incremental", "--stats", "--quiet"}) {
    EXPECT_NE(run.out.find(flag), std::string::npos) << flag;
  }
}

TEST_F(CommandLine, HelpTellsTheRangesOfNumbers) {
  const std::string help = run_depixel({"--help"}).out;
  for (const char* flag :
       {"sides from 1 to 16384", "above 0 and up to 16384", "--svg-tolerance 0..0.5=", "--merge-luma 0..255=",
        "--curve-weight 0..1000=", "--soft-contours 0..100=", "--threads 1..256="}) {
    EXPECT_NE(help.find(flag), std::string::npos) << flag;
  }
}

TEST_F(CommandLine, TellsItsVersion) {
  const Ended run = run_depixel({"--version"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(run.out.starts_with("depixel ")) << run.out;
}

TEST_F(CommandLine, DrawsEveryStageAsPngAndSvg) {
  for (const char* stage : {"bitmap", "similarity", "cells", "simplified", "contours", "polygons", "curves",
                            "smoothed", "components"}) {
    expect_size(draw({"--stage", stage, "-s", "8"}), 96, 64);
    EXPECT_NE(draw({"--stage", stage, "--format", "svg"}).find("</svg>"), std::string::npos) << stage;
  }
  EXPECT_TRUE(draw({"--stage", "similarity", "-s", "8"}) != draw({"--stage", "cells", "-s", "8"}));
}

TEST_F(CommandLine, VerifiesCentres) {
  const Ended kept = run_depixel({in_, "-o", out_, "--verify"});
  EXPECT_EQ(kept.exit_code, 0);
  EXPECT_NE(kept.err.find("All 96 pixels kept"), std::string::npos) << kept.err;
  EXPECT_EQ(run_depixel({in_, "-o", out_, "--verify", "--quiet"}).err, "");
}

TEST_F(CommandLine, VerifyFailsWhereMergingRepaintsAPixel) {
  Picture picture = plain_picture(5, 5, {100, 100, 100, 255});
  picture.row(2)[8] = 101;
  write_text(in_, png_of(picture));
  const Ended run = run_depixel({in_, "-o", out_, "--verify", "--similarity", "merge"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(run.is_one_sentence()) << run.err;
  EXPECT_NE(run.err.find("1 of 25 pixels"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("(2, 2)"), std::string::npos) << run.err;
  EXPECT_EQ(
      run_depixel({in_, "-o", out_, "--verify", "--similarity", "merge", "--shading", "gradient"}).exit_code,
      0);
}

TEST_F(CommandLine, DrawsByOpenGlAsByTheProcessor) {
  const Ended cpu = run_depixel({in_, "-o", "-", "--scale", "4.5"});
  ASSERT_EQ(cpu.exit_code, 0);
  const Picture expected = decoded(cpu.out);
  for (const std::vector<std::string>& context :
       {std::vector<std::string>{}, {"--context", "egl"}, {"--context", "osmesa"}}) {
    std::vector<std::string> arguments{in_, "-o", "-", "--scale", "4.5", "--backend", "gl"};
    arguments.insert(arguments.end(), context.begin(), context.end());
    const Ended gl = run_depixel(arguments);
    ASSERT_EQ(gl.exit_code, 0) << gl.err;
    const Picture actual = decoded(gl.out);
    ASSERT_EQ(actual.width(), expected.width());
    ASSERT_EQ(actual.height(), expected.height());
    for (int y = 0; y < actual.height(); ++y) {
      for (int x = 0; x < actual.width(); ++x) {
        const Rgba a = pixel(actual, x, y), b = pixel(expected, x, y);
        EXPECT_LE(std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}), 4)
            << x << ' ' << y;
      }
    }
  }
}

TEST_F(CommandLine, RefusesContextsThatAreNotThere) {
  const Ended needless = run_depixel({in_, "-o", out_, "--context", "egl"});
  EXPECT_EQ(needless.exit_code, 2);
  EXPECT_TRUE(needless.is_one_sentence()) << needless.err;
  const Ended none = run_program("env", {"__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null", DEPIXEL_PROGRAM, in_,
                                         "-o", out_, "--backend", "gl", "--context", "egl"});
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_TRUE(none.is_one_sentence()) << none.err;
  const Ended too_small =
      run_depixel({in_, "-o", out_, "--backend", "gl", "--size", "1x1", "--scale", "0.01"});
  EXPECT_EQ(too_small.exit_code, 2);
  const Ended too_far = run_depixel({in_, "-o", out_, "--backend", "gl", "--size", "40x1"});
  EXPECT_EQ(too_far.exit_code, 0);  // an eighth of a pixel a pixel
}

TEST_F(CommandLine, TellsStatsAsATable) {
  const Ended run = run_depixel({in_, "-o", "-", "--stats"});
  EXPECT_EQ(run.exit_code, 0);
  expect_size(run.out, 48, 32);
  for (const char* row :
       {"pixels", "pixels changed", "blocks recomputed", "crossings", "contours traced", "nodes traced",
        "arcs traced", "shapes fitted", "arcs of known shape", "segments", "tiles changed", "tiles moved",
        "output drawn", "output moved", "similarity", "draw", "peak"}) {
    EXPECT_NE(run.err.find(row), std::string::npos) << row;
  }
}

TEST_F(CommandLine, TellsStatsThatAreAskedForThoughQuiet) {
  const Ended run = run_depixel({in_, "-o", out_, "--verify", "--quiet", "--stats"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.err.find("blocks recomputed"), std::string::npos) << run.err;
  EXPECT_EQ(run.err.find("kept the colour"), std::string::npos) << run.err;
  const std::string help = run_depixel({"--help"}).out;
  EXPECT_NE(help.find("only errors and what --stats asks for"), std::string::npos) << help;
}

TEST_F(CommandLine, TellsStatsAsJson) {
  const Ended run = run_depixel({in_, "--stats=json", "-o", out_});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_TRUE(run.out.starts_with("{\"frames\":1,\"pixels\":96,")) << run.out;
  EXPECT_TRUE(run.out.ends_with("}}\n")) << run.out;
}

}  // namespace
}  // namespace depixel::test
