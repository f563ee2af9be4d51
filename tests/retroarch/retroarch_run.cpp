#include "tests/retroarch/retroarch_run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
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

/// A window whose screenshot holds the filter's pixels one to one, and nothing that asks for a user or sound.
std::string configuration(const RetroArchRun& wanted, const fs::path& folder) {
  std::map<std::string, std::string> settings{
      {"video_driver", "gl"},
      {"video_vsync", "false"},
      {"video_smooth", "false"},
      {"video_threaded", wanted.is_threaded ? "true" : "false"},
      {"video_gpu_screenshot", "true"},
      {"video_scale", fmt::format("{}.000000", std::ceil(wanted.scale))},
      {"aspect_ratio_index", "21"},  // square pixels
      {"video_font_enable", "false"},
      {"menu_enable_widgets", "false"},
      {"menu_driver", "null"},
      {"audio_enable", "false"},
      {"audio_driver", "null"},
      {"input_driver", "x"},
      {"input_joypad_driver", "null"},
      {"pause_nonactive", "false"},
      {"config_save_on_exit", "false"},
      {"gamemode_enable", "false"},
      {"libretro_info_path", "/usr/share/libretro/info"},
  };
  for (const char* name : {"savefile", "savestate", "system", "screenshot", "cache", "playlist"}) {
    settings[std::string(name) + "_directory"] = folder;
  }
  if (wanted.scale != std::floor(wanted.scale)) {
    // Windows are whole multiples of a frame: a part of one.
    settings["aspect_ratio_index"] = "23";
    settings["custom_viewport_x"] = settings["custom_viewport_y"] = "0";
    settings["custom_viewport_width"] = fmt::format("{}", std::lround(wanted.base_width * wanted.scale));
    settings["custom_viewport_height"] = fmt::format("{}", std::lround(wanted.base_height * wanted.scale));
  }
  if (!wanted.filter.empty()) settings["video_filter"] = wanted.filter;
  for (const auto& [key, value] : wanted.settings) settings[key] = value;
  std::string text;
  for (const auto& [key, value] : settings) text += fmt::format("{} = \"{}\"\n", key, value);
  return text;
}

}  // namespace

RetroArchRan run_retroarch(const RetroArchRun& wanted) {
  const TemporaryFolder folder;
  write_text(folder / "ra.cfg", configuration(wanted, folder.path()));
  const std::string screenshot = folder / "shot.png", home = folder.path();
  // Without a session bus, D-Bus would abort the program that asks for one. The display would be reset, and
  // refuse connections meanwhile, when its last client leaves; RetroArch does where it makes its window anew.
  const Ended ended = run_program("env", {"HOME=" + home,
                                          "XDG_CONFIG_HOME=" + home,
                                          "LIBGL_ALWAYS_SOFTWARE=1",
                                          "DBUS_FATAL_WARNINGS=0",
                                          wanted.environment,
                                          "timeout",
                                          "-k",
                                          "5",
                                          "50",
                                          DEPIXEL_XVFB_RUN,
                                          "-a",
                                          "-s",
                                          "-screen 0 2600x2000x24 -noreset",
                                          DEPIXEL_RETROARCH,
                                          "-v",
                                          "-c",
                                          folder / "ra.cfg",
                                          "-L",
                                          wanted.core,
                                          fmt::format("--max-frames={}", wanted.frames),
                                          "--max-frames-ss",
                                          "--max-frames-ss-path=" + screenshot,
                                          wanted.content});
  RetroArchRan ran{ended.exit_code, ended.out + ended.err, {}, {}};
  ran.errors = errors_in(ran.log);
  if (fs::exists(screenshot)) ran.screenshot = decoded(read_text(screenshot));
  return ran;
}

}  // namespace depixel::test
