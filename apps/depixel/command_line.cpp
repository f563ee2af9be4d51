#include "apps/depixel/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

#include "apps/common/limits.hpp"
#include "apps/depixel/exit_codes.hpp"
#include "apps/depixel/option_flags.hpp"

namespace depixel {
namespace {

constexpr double kMinScale = 1.0 / kMaxSide, kMaxScale = kMaxSide;

constexpr std::string_view kDescription =
    "Turns pixel art into smooth vector pictures, drawn at any size or written as SVG.";
constexpr std::string_view kFooter =
    "A sequence is a folder, an animated GIF, a numbered pattern such as frame_%04d.png, or several INs; OUT "
    "is then a\n"
    "folder, where pictures keep their input's names. An SVG has the size of its input and may be scaled "
    "freely.\n"
    "Exit codes: 0 done, 1 failed, 2 wrong usage.";

/// "640x480"; none unless both are a possible side of a picture.
std::optional<OutputSize> parse_size(std::string_view text) {
  const auto cross = text.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  const auto width = parse_count(text.substr(0, cross)), height = parse_count(text.substr(cross + 1));
  const auto possible = [](std::optional<int> side) { return side && *side >= 1 && *side <= kMaxSide; };
  if (!possible(width) || !possible(height)) return std::nullopt;
  return OutputSize{*width, *height};
}

void add_size_flags(CLI::App& app, Arguments& arguments) {
  const auto parse_scale = [&arguments](const std::string& text) {
    arguments.scale = parse_number(text);
    if (!arguments.scale || *arguments.scale < kMinScale || *arguments.scale > kMaxScale) {
      throw CLI::ValidationError("--scale",
                                 fmt::format("\"{}\" is not a number above 0 and up to {}", text, kMaxScale));
    }
  };
  const auto parse_size_text = [&arguments](const std::string& text) {
    arguments.size = parse_size(text);
    if (!arguments.size) {
      throw CLI::ValidationError(
          "--size",
          fmt::format("\"{}\" is not a size like 1280x960 with sides from 1 to {}", text, kMaxSide));
    }
  };
  auto* scale = app.add_option_function<std::string>("-s,--scale", parse_scale,
                                                     "Output pixels to an input pixel; may be fractional")
                    ->type_name("SCALE")
                    ->default_str("4, or 16 with --stage");
  app.add_option_function<std::string>("--size", parse_size_text,
                                       "Output size; the picture is stretched to fill it")
      ->type_name("WxH")
      ->excludes(scale);
}

void add_output_flags(CLI::App& app, Arguments& arguments) {
  static constexpr std::array<std::string_view, 2> kFormatNames{"svg", "png"};
  app.add_option("-o,--output", arguments.output, "A .svg or .png file, - for standard output, or a folder")
      ->type_name("OUT")
      ->required();
  add_size_flags(app, arguments);
  add_choice_flag(app, "--stage", "Draw a step on the way instead of the result", stage_view_names(),
                  [&](int index) { arguments.stage = static_cast<StageView>(index); });
  add_choice_flag(app, "--format", "Kind of picture, where OUT does not tell; png unless given", kFormatNames,
                  [&](int index) { arguments.format = static_cast<Format>(index); });
}

void add_report_flags(CLI::App& app, Arguments& arguments) {
  app.add_flag("--verify", arguments.verify, "Fail if a pixel lost the colour at its centre");
  const std::string stats_help =
      "Counts and times, as a table on standard error or (=json) on standard output";
  app.add_flag("--stats{table}", stats_help)->each([&](const std::string& form) {
    if (form != "table" && form != "json") throw CLI::ValidationError("only =json may follow");
    arguments.stats = form == "json" ? StatsForm::json : StatsForm::table;
  });
  app.add_flag("--quiet", arguments.quiet, "No progress and no reports, only errors");
}

}  // namespace

std::variant<Arguments, int> parse_command_line(int argc, char** argv) {
  Arguments arguments;
  CLI::App app{std::string(kDescription), "depixel"};
  app.footer(std::string(kFooter));
  app.set_version_flag("--version", "depixel " DEPIXEL_VERSION);
  app.add_option("IN", arguments.inputs,
                 "PNG, BMP, JPEG or GIF files, folders, numbered patterns, - for standard input")
      ->type_name("")
      ->required();
  add_output_flags(app, arguments);
  add_option_flags(app, arguments.options);
  add_report_flags(app, arguments);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    app.exit(help_or_version);
    return kExitDone;
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "depixel: {}; see depixel --help.\n", error.what());
    return kExitUsage;
  }
  return arguments;
}

}  // namespace depixel
