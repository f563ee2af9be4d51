#include "tests/retroarch/retroarch_run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>
#include <vector>

#include "tests/apps/pictures.hpp"

namespace depixel::test {
namespace {

namespace fs = std::filesystem;

/// What RetroArch says on a machine without Wayland, menu, sound and music, with or without a filter.
constexpr std::array<std::string_view, 5> kOfNoConcern{"[Wayland]", "menu driver", "[MIDI]", "[udev]",
                                                       "audio_driver"};

std::string errors_in(const std::string& log) {
  std::istringstream lines(log);
  std::string errors;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("[ERROR]") == std::string::npos) continue;
    const bool is_known = std::any_of(kOfNoConcern.begin(), kOfNoConcern.end(), [&](std::string_view known) {
      return line.find(known) != std::string::npos;
    });
    if (!is_known) errors += line + "\n";
  }
  return errors;
}

/// What all runs share, after what is this one's own: of two lines for one key the first counts.
std::string configuration(const RetroArchRun& wanted, const fs::path& folder) {
  std::map<std::string, std::string> settings = wanted.settings;
  for (const char* name : {"savefile", "savestate", "system", "screenshot", "cache", "playlist"}) {
    settings[std::string(name) + "_directory"] = folder;
  }
  settings["video_threaded"] = wanted.is_threaded ? "true" : "false";
  settings["video_scale"] = fmt::format("{}.000000", wanted.scale);
  if (!wanted.filter.empty()) settings["video_filter"] = wanted.filter;
  std::string text;
  for (const auto& [key, value] : settings) text += fmt::format("{} = \"{}\"\n", key, value);
  return text + read_text(DEPIXEL_RETROARCH_CONFIGURATION);
}

}  // namespace

RetroArchRan run_retroarch(const RetroArchRun& wanted) {
  const TemporaryFolder folder;
  write_text(folder / "ra.cfg", configuration(wanted, folder.path()));
  const std::string screenshot = folder / "shot.png", home = folder.path();
  // Without a session bus, D-Bus would abort the program that asks for one. The display would be reset, and
  // refuse connections meanwhile, when its last client leaves; RetroArch does where it makes its window anew.
  std::vector<std::string> words{"HOME=" + home, "XDG_CONFIG_HOME=" + home, "LIBGL_ALWAYS_SOFTWARE=1",
                                 "DBUS_FATAL_WARNINGS=0"};
  words.insert(words.end(), wanted.environment.begin(), wanted.environment.end());
  words.insert(words.end(),
               {"timeout", "-k", "5", "50", DEPIXEL_XVFB_RUN, "-a", "-s", "-screen 0 2600x2000x24 -noreset",
                DEPIXEL_RETROARCH, "-v", "-c", folder / "ra.cfg", "-L", wanted.core,
                fmt::format("--max-frames={}", wanted.frames), "--max-frames-ss",
                "--max-frames-ss-path=" + screenshot, wanted.content});
  const Ended ended = run_program("env", words);
  RetroArchRan ran{ended.exit_code, ended.out + ended.err, {}, {}};
  ran.errors = errors_in(ran.log);
  if (fs::exists(screenshot)) ran.screenshot = decoded(read_text(screenshot));
  return ran;
}

}  // namespace depixel::test
