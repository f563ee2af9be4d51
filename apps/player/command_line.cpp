#include "apps/player/command_line.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string_view>

#include "apps/common/exit_codes.hpp"
#include "apps/common/files.hpp"

namespace depixel {
namespace {

constexpr std::string_view kDescription =
    "Plays pixel art as smooth vector pictures, and shows how they are made.";
constexpr std::string_view kFooter =
    "Press ? in the window for all keys. Drop files on the window to open them.\n"
    "Exit codes: 0 done, 1 failed, 2 wrong usage.";

/// \return what is wrong with the name; empty if nothing is.
std::string ends_in_png(const std::string& name) {
  return lower_ending(name) == ".png" ? "" : fmt::format("\"{}\" does not end in .png", name);
}

void add_test_flags(CLI::App& app, PlayerArguments& arguments) {
  auto* frames = app.add_option("--frames", arguments.frames,
                                "Show so many frames, each once, and exit; settings are not saved")
                     ->type_name("COUNT")
                     ->check(CLI::Range(1, 1'000'000));
  app.add_option("--screenshot", arguments.screenshot, "Then save what the window shows, as PNG")
      ->type_name("FILE")
      ->check(ends_in_png)
      ->needs(frames);
  app.add_flag("--hide-ui", arguments.hide_ui, "Nothing but the picture in the window");
  app.add_flag("--no-config", arguments.no_config, "Neither use nor save settings");
  app.add_flag("--stats", arguments.print_stats,
               "At the end, frame times and counts as JSON on standard output");
  app.add_flag("--check-incremental", arguments.check_incremental, std::string(kCheckIncrementalHelp));
}

}  // namespace

bool wants_no_config(int argc, char** argv) {
  return std::any_of(argv, argv + argc,
                     [](const char* text) { return std::string_view(text) == "--no-config"; });
}

std::variant<PlayerArguments, int> parse_player_command_line(int argc, char** argv, Options& options) {
  PlayerArguments arguments;
  CLI::App app{std::string(kDescription), "depixel-player"};
  app.footer(std::string(kFooter));
  app.set_version_flag("--version", "depixel-player " DEPIXEL_VERSION);
  app.add_option("IN", arguments.inputs,
                 "PNG, BMP, JPEG, GIF or Y4M files, folders, numbered patterns, - for standard input")
      ->type_name("");
  add_scale_flag(app, "-s,--scale", arguments.scale,
                 "Output pixels to an input pixel; as large as fits unless given");
  add_size_flag(app, "--size", arguments.window_size, "Size of the window", kMinWindowSide);
  add_choice_flag(app, "--stage", "Show a step on the way instead of the result", stage_view_names(),
                  [&](int index) { arguments.stage = static_cast<StageView>(index); });
  add_option_flags(app, options);
  add_test_flags(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    app.exit(help_or_version);
    return kExitDone;
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "depixel-player: {}; see depixel-player --help.\n", error.what());
    return kExitUsage;
  }
  return arguments;
}

}  // namespace depixel
