#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "libdepixel/views/stage_view.hpp"
#include "tests/apps/pictures.hpp"
#include "tests/apps/process.hpp"

namespace depixel::test {
namespace {

constexpr std::string_view kName = "depixel-player";
/// How the display is started. It would be reset, and refuse connections meanwhile, whenever its last client
/// leaves; and clients come and go while the player starts.
const char* const kServer = "-screen 0 800x600x24 -noreset";

/// Runs the player on a display of its own.
Ended run_player(std::vector<std::string> arguments, std::string_view standard_input = {}) {
  arguments.insert(arguments.begin(), {"-a", "-s", kServer, DEPIXEL_PLAYER, "--no-config"});
  return run_program(DEPIXEL_XVFB_RUN, arguments, standard_input);
}

/// Runs the player where no window can be opened: what is told before comes at once.
Ended run_without_display(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(),
                   {"-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", DEPIXEL_PLAYER, "--no-config"});
  return run_program("env", arguments);
}

/// Runs the player whose filter makes an error.
Ended run_player_with_fault(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"-a", "-s", kServer, DEPIXEL_PLAYER_WITH_FAULT, "--no-config"});
  return run_program(DEPIXEL_XVFB_RUN, arguments);
}

/// Runs a script on such a display; $player and $depixel are the programs.
Ended run_script(const std::string& script, const std::string& folder) {
  const std::string head =
      "set -e; cd '" + folder +
      "'; player='" DEPIXEL_PLAYER "'; depixel='" DEPIXEL_PROGRAM
      "'; until_true() { for i in $(seq 300); do \"$@\" && return; sleep 0.02; done; "
      "echo \"$* does not come true\" >&2; exit 9; }; await() { until_true test -s \"$1\"; }; "
      // Whether a part of the screen has more than so many colours.
      "shows() { test $(import -window root -crop $1 png:- | identify -format %k -) -gt $2; }; "
      // Starts the player and waits until keys go to its window, which has drawn something.
      "start() { $player \"$@\" & until_true xdotool search --onlyvisible --class depixel-player >id; "
      "xdotool windowfocus --sync $(cat id); until_true shows 800x600+0+0 1; sleep 0.3; }; ";
  return run_program(DEPIXEL_XVFB_RUN, {"-a", "-s", kServer, "bash", "-c", head + script});
}

bool equal(const Picture& a, const Picture& b) {
  if (a.width() != b.width() || a.height() != b.height() || a.pixel_count() == 0) return false;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      if (pixel(a, x, y) != pixel(b, x, y)) return false;
    }
  }
  return true;
}

std::string y4m_of(int width, int height, const std::vector<std::uint8_t>& lumas) {
  std::string stream =
      "YUV4MPEG2 W" + std::to_string(width) + " H" + std::to_string(height) + " F60:1 Cmono\n";
  for (const std::uint8_t luma : lumas) {
    stream += "FRAME\n" + std::string(std::size_t(width * height), static_cast<char>(luma));
  }
  return stream;
}

TEST(Player, PlaysEveryKindOfSource) {
  const TemporaryFolder folder;
  const std::string png = png_of(sample_picture(16, 16)), y4m = y4m_of(16, 16, {16, 235, 235});
  write_text(folder / "a_0.png", png);
  write_text(folder / "a_1.png", png);
  write_text(folder / "b.gif", gif_of({sample_picture(16, 16), plain_picture(16, 16, {20, 30, 60, 255})}));
  write_text(folder / "c.y4m", y4m);
  struct Source {
    std::vector<std::string> arguments;
    std::string standard_input;
  };
  const std::vector<Source> sources{{{folder / "a_0.png"}, ""},
                                    {{folder / "a_0.png", folder / "c.y4m"}, ""},
                                    {{folder / "a_%d.png"}, ""},
                                    {{folder.path().string()}, ""},
                                    {{folder / "b.gif"}, ""},
                                    {{folder / "c.y4m"}, ""},
                                    {{"-"}, y4m},
                                    {{"-"}, png}};
  for (const Source& source : sources) {
    std::vector<std::string> arguments = source.arguments;
    const std::string shot = folder / "shot.png";
    arguments.insert(arguments.end(),
                     {"--size", "320x320", "--hide-ui", "--frames", "3", "--screenshot", shot});
    const Ended ended = run_player(arguments, source.standard_input);
    EXPECT_EQ(ended.exit_code, 0) << source.arguments.front() << ended.err;
    const Picture shown = decoded(read_text(shot));
    ASSERT_EQ(shown.width(), 320);
    std::set<int> reds;
    for (int i = 0; i < 320; i += 16) reds.insert(pixel(shown, i + 8, i + 8).r);
    EXPECT_TRUE(reds.size() > 1 || *reds.begin() == 255) << source.arguments.front();
    std::filesystem::remove(shot);
  }
}

TEST(Player, KeysShowTheStepsOfTheCommandLine) {
  const TemporaryFolder folder;
  write_text(folder / "in.png", png_of(sample_picture(20, 15)));
  // Keys 0 to 9, each saved with c as in.png, in_2.png and so on, but for the input's name, which is taken.
  const Ended ended = run_script(
      "start in.png --no-config --hide-ui --size 400x300; for key in 0 1 2 3 4 5 6 7 8 9; do xdotool key "
      "$key; sleep 0.15; xdotool key c; await in_$((key + 2)).png; done; xdotool key q; wait",
      folder.path().string());
  ASSERT_EQ(ended.exit_code, 0) << ended.out << ended.err;
  std::vector<Picture> shown;
  for (int key = 0; key <= 9; ++key)
    shown.push_back(decoded(read_text(folder / ("in_" + std::to_string(key + 2) + ".png"))));
  for (int key = 0; key <= 9; ++key) {
    const std::string name(stage_view_names()[static_cast<std::size_t>(key)]);
    ASSERT_EQ(
        run_depixel({folder / "in.png", "-o", folder / "stage.png", "--stage", name, "--size", "400x300"})
            .exit_code,
        0);
    EXPECT_TRUE(equal(shown[key], decoded(read_text(folder / "stage.png")))) << name;
    for (int other = 0; other < std::min(key, 8); ++other)
      EXPECT_FALSE(equal(shown[key], shown[other])) << key << other;
  }
}

TEST(Player, ScreenshotsEqualTheWindow) {
  const TemporaryFolder folder;
  write_text(folder / "in.png", png_of(sample_picture(20, 15)));
  const Ended ended = run_script(
      "start in.png --no-config --size 800x600; xdotool key question; sleep 0.3; import -window root "
      "root.png; xdotool key question key s key Tab; sleep 0.3; import -window root split.png; xdotool key "
      "c; await in_2.png; xdotool key q; wait",
      folder.path().string());
  ASSERT_EQ(ended.exit_code, 0) << ended.out << ended.err;
  const Picture window = decoded(read_text(folder / "split.png"));
  EXPECT_TRUE(equal(decoded(read_text(folder / "in_2.png")), window));
  EXPECT_FALSE(equal(decoded(read_text(folder / "root.png")), window));
}

TEST(Player, OptionsChangeThePicture) {
  const TemporaryFolder folder;
  write_text(folder / "in.png", png_of(sample_picture(20, 15)));
  const auto shown = [&](const std::string& smoothing) {
    const std::string shot = folder / (smoothing + ".png");
    const Ended ended = run_player({folder / "in.png", "--hide-ui", "--size", "400x300", "--smoothing",
                                    smoothing, "--frames", "1", "--screenshot", shot});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    return decoded(read_text(shot));
  };
  EXPECT_FALSE(equal(shown("energy"), shown("none")));
}

TEST(Player, RemembersOptionsUnlessTheyAreDamaged) {
  const TemporaryFolder folder;
  write_text(folder / "in.png", png_of(sample_picture(20, 15)));
  const Ended ended = run_script(
      "export XDG_CONFIG_HOME=$PWD/config; see='in.png --hide-ui --size 400x300 --frames 1 --screenshot'; "
      "$player $see default.png; $player $see none.png --smoothing none; start in.png --smoothing none; "
      "xdotool key q; wait; $player $see again.png; echo '{ damaged' > config/depixel/player.json; "
      "$player $see damaged.png 2>said.txt",
      folder.path().string());
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const auto shown = [&](const std::string& name) { return decoded(read_text(folder / name)); };
  EXPECT_FALSE(equal(shown("default.png"), shown("none.png")));
  EXPECT_TRUE(equal(shown("again.png"), shown("none.png")));
  EXPECT_TRUE(equal(shown("damaged.png"), shown("default.png")));
  const Ended said{0, "", read_text(folder / "said.txt")};
  EXPECT_TRUE(said.is_one_sentence(kName)) << said.err;
}

TEST(Player, LeavesTheSettingsAloneWhereFramesAreCounted) {
  const TemporaryFolder folder;
  write_text(folder / "in.png", png_of(sample_picture(20, 15)));
  std::filesystem::create_directories(folder / "config/depixel");
  const std::string settings = R"({"options": {"smoothing": "average"}})";
  write_text(folder / "config/depixel/player.json", settings);
  const Ended ended = run_script(
      "counted='in.png --size 400x300 --threads 2 --frames 1'; XDG_CONFIG_HOME=$PWD/config $player $counted; "
      "XDG_CONFIG_HOME=$PWD/none $player $counted",
      folder.path().string());
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(read_text(folder / "config/depixel/player.json"), settings);
  EXPECT_EQ(folder.names("config/depixel"), std::vector<std::string>{"player.json"});
  EXPECT_FALSE(std::filesystem::exists(folder / "none"));
}

TEST(Player, WritesVectorPicturesAndSequences) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "clip");
  for (int i = 0; i < 3; ++i)
    write_text(folder / ("clip/" + std::to_string(i) + ".png"), png_of(sample_picture(8, 8 + i)));
  const Ended ended = run_script(
      // What is written is the frame shown, which is not at once the first one.
      "writes() { xdotool key Home key w; sleep 0.1; test -s 0.svg; }; "
      "start clip --no-config --size 400x300; xdotool key space; until_true writes; xdotool key e; await "
      "clip_depixel/2.png; sleep 0.1; xdotool key q; wait",
      folder.path().string());
  ASSERT_EQ(ended.exit_code, 0) << ended.out << ended.err;
  EXPECT_EQ(folder.names("clip_depixel"), (std::vector<std::string>{"0.png", "1.png", "2.png"}));
  EXPECT_NE(read_text(folder / "0.svg").find("viewBox=\"0 0 8 8\""), std::string::npos);
}

/// Writes frames as clip/0.png and so on.
std::vector<Picture> write_clip(const TemporaryFolder& folder) {
  std::vector<Picture> frames = sample_frames(20, 15, 6);
  std::filesystem::create_directory(folder / "clip");
  for (std::size_t i = 0; i < frames.size(); ++i) {
    write_text(folder / ("clip/" + std::to_string(i) + ".png"), png_of(frames[i]));
  }
  return frames;
}

TEST(Player, ExportsWhatTheCommandLineDrawsFrameByFrame) {
  const TemporaryFolder folder;
  const std::size_t count = write_clip(folder).size();
  const Ended ended = run_script(
      "start clip --no-config --hide-ui --size 400x300 --check-incremental; xdotool key e; await "
      "clip_depixel/5.png; sleep 0.1; xdotool key q; wait",
      folder.path().string());
  ASSERT_EQ(ended.exit_code, 0) << ended.out << ended.err;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = std::to_string(i) + ".png";
    const Ended alone = run_depixel({folder / ("clip/" + name), "-o", "-", "--size", "400x300"});
    EXPECT_TRUE(read_text(folder / ("clip_depixel/" + name)) == alone.out) << name;
  }
}

TEST(Player, MayStartUnderThePointer) {
  const TemporaryFolder folder;
  write_text(folder / "in.png", png_of(sample_picture(20, 15)));
  const Ended ended =
      run_script("xdotool mousemove 200 150; $player in.png --no-config --size 800x600 --frames 2",
                 folder.path().string());
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
}

/// The number that follows a key of a JSON object.
long number_after(const std::string& json, const std::string& key) {
  const auto at = json.find('"' + key + "\":");
  return at == std::string::npos ? -1 : std::stol(json.substr(at + key.size() + 3));
}

TEST(Player, CountsOnlyWhatChanged) {
  const TemporaryFolder folder;
  write_clip(folder);
  const Ended ended =
      run_player({folder / "clip", "--size", "400x300", "--frames", "6", "--stats", "--check-incremental"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const std::string counts = ended.out.substr(ended.out.find("\"counts\""));
  EXPECT_EQ(number_after(counts, "frames"), 6);
  EXPECT_EQ(number_after(counts, "pixels"), 6 * 300);
  EXPECT_GT(number_after(counts, "changed_pixels"), 300);
  EXPECT_LT(number_after(counts, "changed_pixels"), 6 * 300);
  EXPECT_GT(number_after(counts, "upload_bytes"), 0);
  EXPECT_EQ(number_after(counts, "drawn_pixels"), 0) << "by the processor";
}

TEST(Player, ChecksFramesAndFailsWhereTheyDiffer) {
  const TemporaryFolder folder;
  write_clip(folder);
  const std::vector<std::string> few{folder / "clip", "--size", "400x300", "--frames", "6"};
  EXPECT_EQ(run_player_with_fault(few).exit_code, 0) << "nobody looks";
  std::vector<std::string> checked = few;
  checked.emplace_back("--check-incremental");
  const Ended found = run_player_with_fault(checked);
  EXPECT_EQ(found.exit_code, 1);
  EXPECT_TRUE(found.is_one_sentence(kName)) << found.err;
  EXPECT_NE(found.err.find("Frame 1: The map"), std::string::npos) << found.err;
}

TEST(Player, SaysOverThePictureWhichFrameDiffers) {
  const TemporaryFolder folder;
  write_clip(folder);
  const Ended ended = run_script(
      "player='" DEPIXEL_PLAYER_WITH_FAULT
      "'; start clip --no-config --size 800x600 --check-incremental; "
      // The picture is not drawn and nothing outlined: left of the panels there is only the message.
      "xdotool key h; sleep 0.3; until_true shows 400x200+0+0 2; xdotool key q; wait $!",
      folder.path().string());
  EXPECT_EQ(ended.exit_code, 0) << ended.out << ended.err;
}

TEST(Player, WritesNothingOver) {
  const TemporaryFolder folder;
  for (const char* clip : {"a", "b"}) {
    std::filesystem::create_directory(folder / clip);
    write_text(folder / (std::string(clip) + "/0.png"), png_of(sample_picture(8, 8)));
  }
  const Ended ended = run_script(
      "start a/0.png b/0.png --no-config --size 400x300; xdotool key space key e; await 0_depixel/0_2.png; "
      "xdotool key q; wait",
      folder.path().string());
  ASSERT_EQ(ended.exit_code, 0) << ended.out << ended.err;
  EXPECT_EQ(folder.names("0_depixel"), (std::vector<std::string>{"0.png", "0_2.png"}));
}

TEST(Player, NeverSavesOverAnInput) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  const std::string clip = folder / "clip", in = clip + "/0.png", other = clip + "/1.png";
  fs::create_directory(clip);
  for (const std::string& file : {in, other}) write_text(file, png_of(sample_picture(8, 8)));
  fs::create_symlink("clip/0.png", folder / "symbolic.png");
  fs::create_hard_link(in, folder / "hard.png");
  struct Case {
    std::string input, screenshot;
  };
  for (const Case& c : {Case{in, in}, Case{in, clip + "/./0.png"}, Case{in, folder / "symbolic.png"},
                        Case{in, folder / "hard.png"}, Case{clip, other}, Case{clip + "/%d.png", other}}) {
    const Ended ended = run_without_display({c.input, "--frames", "1", "--screenshot", c.screenshot});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_EQ(ended.err, "depixel-player: " + c.screenshot + " is an input and is not overwritten.\n");
  }
}

TEST(Player, RefusesWrongUsage) {
  const std::vector<std::vector<std::string>> wrong{
      {"--no-such-flag"},
      {"--frames", "0"},
      {"--frames", "0.5"},
      {"--frames", "1", "--screenshot", ""},
      {"--frames", "1", "--screenshot", "-"},
      {"--frames", "1", "--screenshot", "shot"},
      {"--frames", "1", "--screenshot", "shot.jpg"},
      {"--frames", "1", "--screenshot", "folder/.png"},
      {"--size", "1x1"},
      {"--size", "400x63"},
      {"--size", "16385x400"},
  };
  for (const auto& arguments : wrong) {
    const Ended ended = run_without_display(arguments);
    EXPECT_EQ(ended.exit_code, 2) << fmt::format("{}", fmt::join(arguments, " "));
    EXPECT_TRUE(ended.is_one_sentence(kName)) << ended.err;
  }
  const Ended right =
      run_without_display({"in.png", "--size", "64x64", "--frames", "1", "--screenshot", "A.Png"});
  EXPECT_EQ(right.exit_code, 1) << "but for the display: " << right.err;
}

TEST(Player, GoesOnBehindADamagedFrameAndTellsOfItAtTheEnd) {
  const TemporaryFolder folder;
  const Rgba last{20, 30, 60, 255};
  std::filesystem::create_directory(folder / "clip");
  write_text(folder / "clip/0.png", png_of(sample_picture(8, 8)));
  write_text(folder / "clip/1.png", "no picture");
  write_text(folder / "clip/2.png", png_of(plain_picture(8, 8, last)));
  for (const char* frames : {"3", "6"}) {  // once, and round again
    const Ended ended = run_player({folder / "clip", "--size", "320x320", "--hide-ui", "--frames", frames,
                                    "--stats", "--screenshot", folder / "shot.png"});
    EXPECT_EQ(ended.exit_code, 1);
    EXPECT_TRUE(ended.is_one_sentence(kName)) << ended.err;
    EXPECT_NE(ended.err.find("1.png is not a picture"), std::string::npos) << ended.err;
    EXPECT_NE(ended.out.find("\"counts\""), std::string::npos) << ended.out;
    const Picture shown = decoded(read_text(folder / "shot.png"));
    ASSERT_EQ(shown.width(), 320);
    EXPECT_EQ(pixel(shown, 160, 160), last);
  }
}

TEST(Player, SaysWhatIsWrongInOneSentence) {
  const TemporaryFolder folder;
  write_text(folder / "bad.png", "no picture");
  write_text(folder / "good.png", png_of(sample_picture(8, 8)));
  for (const std::string& source : {folder / "bad.png", folder / "absent.png"}) {
    const Ended ended = run_player({source});
    EXPECT_EQ(ended.exit_code, 1) << source;
    EXPECT_TRUE(ended.is_one_sentence(kName)) << ended.err;
  }
  const Ended cut = run_player({"-", "--frames", "2"}, "YUV4MPEG2 W4 H4 Cmono\nFRAME\nabc");
  EXPECT_EQ(cut.exit_code, 1);
  EXPECT_TRUE(cut.is_one_sentence(kName)) << cut.err;

  const Ended no_display = run_without_display({folder / "good.png"});
  EXPECT_EQ(no_display.exit_code, 1);
  EXPECT_TRUE(no_display.is_one_sentence(kName)) << no_display.err;

  const Ended old =
      run_script("MESA_GL_VERSION_OVERRIDE=2.1 $player --no-config good.png", folder.path().string());
  EXPECT_EQ(old.exit_code, 1);
  EXPECT_TRUE(old.is_one_sentence(kName)) << old.err;
}

}  // namespace
}  // namespace depixel::test
