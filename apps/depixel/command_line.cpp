#include "apps/depixel/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

#include "apps/common/exit_codes.hpp"
#include "apps/common/option_flags.hpp"
#include "filter/option_text.hpp"

namespace depixel {
namespace {

constexpr std::string_view kDescription =
    "Turns pixel art into smooth vector pictures, drawn at any size or written as SVG.";
constexpr std::string_view kFooter =
    "A sequence is a folder, an animated GIF, a numbered pattern such as frame_%04d.png, or several INs; OUT "
    "is then a\n"
    "folder, where pictures keep their input's names. An SVG has the size of its input and may be scaled "
    "freely.\n"
    "Exit codes: 0 done, 1 failed, 2 wrong usage.";

void add_size_flags(CLI::App& app, Arguments& arguments) {
  auto* scale =
      add_scale_flag(app, "-s,--scale", arguments.scale, "Output pixels to an input pixel; may be fractional")
          ->default_str("4, or 16 with --stage");
  add_size_flag(app, "--size", arguments.size, "Output size; the picture is stretched to fill it")
      ->excludes(scale);
}

void add_svg_tolerance_flag(CLI::App& app, Arguments& arguments) {
  const std::string flag = "--svg-tolerance";
  const auto parse = [&arguments, flag](const std::string& text) {
    const auto tolerance = parse_number(text);
    if (!tolerance || *tolerance < 0 || *tolerance > kMaxSvgTolerance) {
      throw CLI::ValidationError(flag,
                                 fmt::format("\"{}\" is not a number from 0 to {}", text, kMaxSvgTolerance));
    }
    arguments.svg_tolerance_px = *tolerance;
  };
  app.add_option_function<std::string>(
         flag, parse, "How far an SVG's curves may stray, in input pixels, to make it smaller; 0: not at all")
      ->default_str(fmt::format("{}", kSvgTolerance))
      ->type_name(range_name(0, kMaxSvgTolerance));
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
  add_svg_tolerance_flag(app, arguments);
}

void add_backend_flags(CLI::App& app, Arguments& arguments) {
  static constexpr std::array<std::string_view, 2> kBackendNames{"cpu", "gl"};
  add_choice_flag(app, "--backend", "What draws: the processor, or OpenGL without a display", kBackendNames,
                  [&](int index) { arguments.backend = static_cast<Backend>(index); })
      ->default_str("cpu");
  add_choice_flag(app, "--context", "Where OpenGL comes from; whichever can be had unless given",
                  context_kind_names(),
                  [&](int index) { arguments.context = static_cast<ContextKind>(index); });
  app.callback([&] {
    if (arguments.context && arguments.backend != Backend::gl) {
      throw CLI::ValidationError("--context", "needs --backend gl");
    }
  });
}

void add_report_flags(CLI::App& app, Arguments& arguments) {
  app.add_flag("--verify", arguments.verify, "Fail if a pixel lost the colour at its centre");
  app.add_flag("--check-incremental", arguments.check_incremental, std::string(kCheckIncrementalHelp));
  const std::string stats_help =
      "Counts and times, as a table on standard error or (=json) on standard output";
  app.add_flag("--stats{table}", stats_help)->each([&](const std::string& form) {
    if (form != "table" && form != "json") throw CLI::ValidationError("only =json may follow");
    arguments.stats = form == "json" ? StatsForm::json : StatsForm::table;
  });
  app.add_flag("--quiet", arguments.quiet,
               "No progress and no report of --verify, only errors and what --stats asks for");
}

}  // namespace

std::variant<Arguments, int> parse_command_line(int argc, char** argv) {
  Arguments arguments;
  CLI::App app{std::string(kDescription), "depixel"};
  app.footer(std::string(kFooter));
  app.set_version_flag("--version", "depixel " DEPIXEL_VERSION);
  app.add_option("IN", arguments.inputs,
                 "PNG, BMP, JPEG, GIF or Y4M files, folders, numbered patterns, - for standard input")
      ->type_name("")
      ->required();
  add_output_flags(app, arguments);
  add_option_flags(app, arguments.options);
  add_backend_flags(app, arguments);
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
