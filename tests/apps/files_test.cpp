// Where depixel reads from and writes to: files, streams, folders and sequences.

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/apps/pictures.hpp"
#include "tests/apps/process.hpp"

namespace depixel::test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

constexpr Rgba kRed{230, 80, 40, 255}, kBlue{20, 30, 60, 255};

void expect_failure(const Ended& run) {
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(run.is_one_sentence()) << run.err;
  EXPECT_EQ(run.out, "");
}

void expect_success(const Ended& run) {
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err, "");
}

class Files : public testing::Test {
 protected:
  std::string write(std::string_view name, std::string_view file) const {
    write_text(folder_ / name, file);
    return folder_ / name;
  }
  Rgba centre(std::string_view name) const {
    const Picture picture = decoded(read_text(folder_ / name));
    return picture.width() > 0 ? pixel(picture, picture.width() / 2, picture.height() / 2) : Rgba{};
  }

  TemporaryFolder folder_;
  std::string sample_ = png_of(sample_picture(12, 8));
  std::string red_ = png_of(plain_picture(3, 3, kRed)), blue_ = png_of(plain_picture(3, 3, kBlue));
};

TEST_F(Files, KindFollowsTheEnding) {
  const std::string in = write("in.png", sample_);
  expect_success(run_depixel({in, "-o", folder_ / "out.svg"}));
  expect_success(run_depixel({in, "-o", folder_ / "out.png"}));
  EXPECT_NE(read_text(folder_ / "out.svg").find("viewBox=\"0 0 12 8\""), std::string::npos);
  EXPECT_EQ(decoded(read_text(folder_ / "out.png")).width(), 48);
}

TEST_F(Files, EndingsMayBeInCapitals) {
  const std::string in = write("in.png", sample_);
  expect_success(run_depixel({in, "-o", folder_ / "OUT.SVG"}));
  expect_success(run_depixel({in, "-o", folder_ / "Out.Png"}));
  EXPECT_NE(read_text(folder_ / "OUT.SVG").find("</svg>"), std::string::npos);
  EXPECT_EQ(decoded(read_text(folder_ / "Out.Png")).width(), 48);
  EXPECT_EQ(run_depixel({in, "-o", folder_ / "other.PNG", "--format", "svg"}).exit_code, 2);
}

TEST_F(Files, ReadsStandardInputAndWritesStandardOutput) {
  const Ended png = run_depixel({"-", "-o", "-"}, sample_);
  expect_success(png);
  EXPECT_EQ(decoded(png.out).width(), 48);
  const Ended svg = run_depixel({"-", "-o", "-", "--format", "svg"}, sample_);
  expect_success(svg);
  EXPECT_NE(svg.out.find("</svg>"), std::string::npos);
}

TEST_F(Files, AllKindsOfTheSamePictureGiveTheSameOutput) {
  const Picture picture = sample_picture(13, 7);
  const std::string expected = run_depixel({"-", "-o", "-"}, png_of(picture)).out;
  EXPECT_TRUE(run_depixel({"-", "-o", "-"}, bmp_of(picture)).out == expected);
  EXPECT_TRUE(run_depixel({"-", "-o", "-"}, gif_of({picture})).out == expected);
}

TEST_F(Files, ReadsJpeg) {
  const Ended run = run_depixel({DEPIXEL_TEST_DATA "/formats/red.jpg", "-o", "-", "-s", "1"});
  expect_success(run);
  const Picture picture = decoded(run.out);
  ASSERT_EQ(picture.width(), 8);
  EXPECT_GT(pixel(picture, 4, 4).r, 200);
  EXPECT_LT(pixel(picture, 4, 4).b, 60);
}

TEST_F(Files, TransparencySurvives) {
  const Ended run = run_depixel({"-", "-o", "-"}, png_of(plain_picture(4, 4, {10, 20, 30, 128})));
  EXPECT_EQ(pixel(decoded(run.out), 8, 8), (Rgba{10, 20, 30, 128}));
}

TEST_F(Files, SeveralInputsGoToAFolderAndKeepTheirNames) {
  const std::string out = folder_ / "new/out";
  expect_success(
      run_depixel({write("b.png", red_), write("a.gif", gif_of({plain_picture(3, 3, kBlue)})), "-o", out}));
  EXPECT_EQ(folder_.names("new/out"), (Names{"a.png", "b.png"}));
  EXPECT_EQ(centre("new/out/a.png"), kBlue);
  EXPECT_EQ(centre("new/out/b.png"), kRed);
}

TEST_F(Files, AFolderIsASequence) {
  fs::create_directory(folder_ / "frames");
  write("frames/2.png", red_);
  write("frames/10.PNG", blue_);
  write("frames/notes.txt", "no picture");
  write("frames/.hidden.png", "no picture");
  expect_success(run_depixel({folder_ / "frames", "-o", folder_ / "out", "--format", "svg"}));
  EXPECT_EQ(folder_.names("out"), (Names{"10.svg", "2.svg"}));
}

TEST_F(Files, AFolderOfOnePictureIsASequenceToo) {
  fs::create_directory(folder_ / "frames");
  write("frames/one.png", red_);
  expect_success(run_depixel({folder_ / "frames", "-o", folder_ / "out"}));
  EXPECT_EQ(folder_.names("out"), Names{"one.png"});
}

TEST_F(Files, APatternStandsForNumberedFiles) {
  for (const char* name :
       {"f_0001.png", "f_0002.png", "f_0010.png", "f_12345.png", "f_01.png", "f_x.png", "g_0001.png"}) {
    write(name, red_);
  }
  expect_success(run_depixel({folder_ / "f_%04d.png", "-o", folder_ / "out"}));
  EXPECT_EQ(folder_.names("out"), (Names{"f_0001.png", "f_0002.png", "f_0010.png", "f_12345.png"}));
  expect_failure(run_depixel({folder_ / "h_%04d.png", "-o", folder_ / "out"}));
}

TEST_F(Files, AFileThatLooksLikeAPatternIsItself) {
  expect_success(run_depixel({write("%d.png", red_), "-o", folder_ / "out.png"}));
  EXPECT_EQ(centre("out.png"), kRed);
}

TEST_F(Files, AnAnimatedGifIsASequence) {
  const std::string in = write("walk.gif", gif_of({plain_picture(3, 3, kRed), plain_picture(3, 3, kBlue)}));
  expect_success(run_depixel({in, "-o", folder_ / "out"}));
  EXPECT_EQ(folder_.names("out"), (Names{"walk_0000.png", "walk_0001.png"}));
  EXPECT_EQ(centre("out/walk_0000.png"), kRed);
  EXPECT_EQ(centre("out/walk_0001.png"), kBlue);
  EXPECT_EQ(run_depixel({in, "-o", folder_ / "out.png"}).exit_code, 2);
  EXPECT_EQ(run_depixel({in, "-o", "-"}).exit_code, 2);
}

TEST_F(Files, ASinglePictureMayGoToAFolder) {
  fs::create_directory(folder_ / "out");
  expect_success(run_depixel({write("in.png", red_), "-o", folder_ / "out"}));
  expect_success(run_depixel({"-", "-o", folder_ / "new/"}, red_));
  EXPECT_EQ(folder_.names("out"), Names{"in.png"});
  EXPECT_EQ(folder_.names("new"), Names{"stdin.png"});
}

TEST_F(Files, AnExistingOutputIsReplacedAndNothingIsLeftBeside) {
  const std::string in = write("in.png", red_), out = write("out.png", "old");
  expect_success(run_depixel({in, "-o", out}));
  EXPECT_EQ(centre("out.png"), kRed);
  EXPECT_EQ(folder_.names(), (Names{"in.png", "out.png"}));
}

TEST_F(Files, ALinkedOutputIsReplacedBehindTheLink) {
  const std::string in = write("in.png", red_), out = write("out.png", "old");
  fs::create_symlink("out.png", folder_ / "link.png");
  expect_success(run_depixel({in, "-o", folder_ / "link.png"}));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.png"));
  EXPECT_EQ(centre("out.png"), kRed);
}

TEST_F(Files, AnInputIsNeverOverwritten) {
  const std::string in = write("in.png", red_), other = write("other.png", blue_);
  fs::create_symlink("in.png", folder_ / "symbolic.png");
  fs::create_hard_link(in, folder_ / "hard.png");
  for (const std::string& out : {in, folder_ / "../" + folder_.path().filename().string() + "/in.png",
                                 folder_ / "symbolic.png", folder_ / "hard.png"}) {
    expect_failure(run_depixel({in, "-o", out}));
  }
  expect_failure(run_depixel({in, other, "-o", folder_.path().string()}));
  expect_failure(run_depixel({folder_.path().string(), "-o", folder_.path().string()}));
  EXPECT_EQ(read_text(in), red_);
  EXPECT_EQ(read_text(other), blue_);
}

TEST_F(Files, AnInputThatIsRedirectedIsNeverOverwritten) {
  const std::string in = write("in.png", red_);
  expect_failure(run_program("sh", {"-c", "exec \"$1\" - -o \"$2\" <\"$2\"", "sh", DEPIXEL_PROGRAM, in}));
  EXPECT_EQ(read_text(in), red_);
}

TEST_F(Files, TwoInputsNeverGoToOneFile) {
  fs::create_directory(folder_ / "a");
  fs::create_directory(folder_ / "b");
  expect_failure(run_depixel({write("a/x.png", red_), write("b/x.png", blue_), "-o", folder_ / "out"}));
  EXPECT_FALSE(fs::exists(folder_ / "out")) << "refused before anything was made";
}

TEST_F(Files, FramesOfAStreamHaveNamesOfTheirOwn) {
  const std::string stream = "YUV4MPEG2 W3 H3 Cmono\nFRAME\n" + std::string(9, 'x');
  expect_success(run_depixel({write("x.y4m", stream), write("x.png", red_), "-o", folder_ / "out"}));
  EXPECT_EQ(folder_.names("out"), (Names{"x.png", "x_0000.png"}));
}

TEST_F(Files, OutputsThatCannotBeWrittenFail) {
  const std::string in = write("in.png", red_), file = write("file", "text");
  fs::create_directory(folder_ / "folder.png");
  for (const std::string& out : {file + "/out.png", folder_ / "missing/out.png",
                                 std::string("/proc/depixel.png"), file + "/folder/"}) {
    expect_failure(run_depixel({in, "-o", out}));
  }
  fs::create_symlink("/dev/null", folder_ / "null.png");
  expect_failure(run_depixel({in, "-o", folder_ / "null.png"}));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(read_text(file), "text");
  EXPECT_EQ(folder_.names(), (Names{"file", "folder.png", "in.png", "null.png"}));
}

TEST_F(Files, ABrokenFrameStopsASequenceWithItsName) {
  write("1.png", red_);
  write("2.png", "no picture");
  const Ended run = run_depixel({folder_ / "1.png", folder_ / "2.png", "-o", folder_ / "out"});
  expect_failure(run);
  EXPECT_NE(run.err.find("2.png"), std::string::npos) << run.err;
  EXPECT_EQ(folder_.names("out"), Names{"1.png"});
}

TEST_F(Files, SaysWhatCanBeRead) {
  EXPECT_NE(run_depixel({"-", "-o", "-"}, "text").err.find("PNG, BMP, JPEG, GIF or Y4M."), std::string::npos);
  const Ended folder = run_depixel({folder_.path().string(), "-o", folder_ / "out"});
  EXPECT_NE(folder.err.find("no .png, .bmp, .jpg, .gif or .y4m."), std::string::npos) << folder.err;
}

TEST_F(Files, MissingAndEmptyInputsFail) {
  const Ended nameless = run_depixel({"", "-o", folder_ / "out.png"});
  expect_failure(nameless);
  EXPECT_EQ(nameless.err, "depixel: An input's name is empty.\n");
  expect_failure(run_depixel({folder_ / "missing.png", "-o", folder_ / "out.png"}));
  expect_failure(run_depixel({folder_.path().string(), "-o", folder_ / "out"}));
  expect_failure(run_depixel({"-", "-o", "-"}));
  expect_failure(run_depixel({"/dev/zero", "-o", folder_ / "out.png"}));
}

}  // namespace
}  // namespace depixel::test
