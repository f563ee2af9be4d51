#include "apps/common/option_flags.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <variant>

#include "apps/common/limits.hpp"
#include "filter/option_text.hpp"

namespace depixel {
namespace {

constexpr double kMinScale = 1.0 / kMaxSide, kMaxScale = kMaxSide;

/// "640x480"; none unless both sides are in the range.
std::optional<OutputSize> parse_size(std::string_view text, int min_side) {
  const auto cross = text.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  const auto width = parse_count(text.substr(0, cross)), height = parse_count(text.substr(cross + 1));
  const auto possible = [&](std::optional<int> side) {
    return side && *side >= min_side && *side <= kMaxSide;
  };
  if (!possible(width) || !possible(height)) return std::nullopt;
  return OutputSize{*width, *height};
}

/// What a flag's value is called in the help.
struct TypeName {
  std::string operator()(const ChoiceOption& choice) const {
    return fmt::format("{}", fmt::join(choice.names, "|"));
  }
  std::string operator()(const NumberOption& option) const {
    return range_name(option.minimum, option.maximum);
  }
  std::string operator()(const CountOption& option) const {
    return range_name(option.minimum, option.maximum);
  }
  std::string operator()(const SwitchOption&) const { return ""; }
};

}  // namespace

std::string range_name(double minimum, double maximum) {
  return fmt::format("{}..{}", minimum, maximum);
}

CLI::Option* add_choice_flag(CLI::App& app, const std::string& flag, const std::string& help,
                             std::span<const std::string_view> names,
                             const std::function<void(int)>& choose) {
  const auto parse = [flag, names, choose](const std::string& text) {
    const auto index = parse_choice(text, names);
    if (!index) throw CLI::ValidationError(flag, index.error().message);
    choose(*index);
  };
  return app.add_option_function<std::string>(flag, parse, help)
      ->type_name(fmt::format("{}", fmt::join(names, "|")));
}

CLI::Option* add_scale_flag(CLI::App& app, const std::string& flag, std::optional<double>& into,
                            const std::string& help) {
  const auto parse = [&into](const std::string& text) {
    into = parse_number(text);
    if (!into || *into < kMinScale || *into > kMaxScale) {
      throw CLI::ValidationError("--scale",
                                 fmt::format("\"{}\" is not a number above 0 and up to {}", text, kMaxScale));
    }
  };
  return app
      .add_option_function<std::string>(flag, parse, fmt::format("{}, above 0 and up to {}", help, kMaxScale))
      ->type_name("SCALE");
}

CLI::Option* add_size_flag(CLI::App& app, const std::string& flag, std::optional<OutputSize>& into,
                           const std::string& help, int min_side) {
  const std::string sides = fmt::format("sides from {} to {}", min_side, kMaxSide);
  const auto parse = [&into, min_side, sides](const std::string& text) {
    into = parse_size(text, min_side);
    if (!into) {
      throw CLI::ValidationError("--size",
                                 fmt::format("\"{}\" is not a size like 1280x960 with {}", text, sides));
    }
  };
  return app.add_option_function<std::string>(flag, parse, fmt::format("{}; {}", help, sides))
      ->type_name("WxH");
}

void add_option_flags(CLI::App& app, Options& options) {
  for (const OptionInfo& option : option_table()) {
    const std::string flag = fmt::format("--{}", option.name), help(option.help);
    if (const auto* as_switch = std::get_if<SwitchOption>(&option.kind)) {
      app.add_flag(flag, options.*as_switch->value, help);
      continue;
    }
    const auto set = [flag, &option, &into = options](const std::string& text) {
      if (const auto done = set_option(into, option, text); !done) {
        throw CLI::ValidationError(flag, done.error().message);
      }
    };
    app.add_option_function<std::string>(flag, set, help)
        ->default_str(option_text(options, option))
        ->type_name(std::visit(TypeName{}, option.kind));
  }
}

}  // namespace depixel
