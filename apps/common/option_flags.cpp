#include "apps/common/option_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <variant>

#include "apps/common/limits.hpp"

namespace depixel {
namespace {

constexpr double kMinScale = 1.0 / kMaxSide, kMaxScale = kMaxSide;

template <typename Number>
std::optional<Number> parse_whole(std::string_view text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

/// "640x480"; none unless both are a possible side of a picture.
std::optional<OutputSize> parse_size(std::string_view text) {
  const auto cross = text.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  const auto width = parse_count(text.substr(0, cross)), height = parse_count(text.substr(cross + 1));
  const auto possible = [](std::optional<int> side) { return side && *side >= 1 && *side <= kMaxSide; };
  if (!possible(width) || !possible(height)) return std::nullopt;
  return OutputSize{*width, *height};
}

/// Adds the flag of one row; there is an overload for each kind of option.
struct FlagAdder {
  CLI::App& app;
  Options& options;
  std::string flag, help;

  void operator()(const ChoiceOption& choice) const {
    const auto set = [choice, &into = options](int index) { choice.set(into, index); };
    add_choice_flag(app, flag, help, choice.names, set)
        ->default_str(std::string(choice.names[static_cast<std::size_t>(choice.get(options))]));
  }

  void operator()(const SwitchOption& option) const { app.add_flag(flag, options.*option.value, help); }

  void operator()(const NumberOption& option) const { add_number(option, parse_number, "NUMBER"); }
  void operator()(const CountOption& option) const { add_number(option, parse_count, "COUNT"); }

  template <typename Option, typename Parse>
  void add_number(const Option& option, Parse parse, const char* type) const {
    const auto set = [name = flag, option, parse, &into = options](const std::string& text) {
      const auto value = parse(text);
      if (!value || *value < option.minimum || *value > option.maximum) {
        throw CLI::ValidationError(
            name, fmt::format("\"{}\" is not a number from {} to {}", text, option.minimum, option.maximum));
      }
      into.*option.value = *value;
    };
    app.add_option_function<std::string>(flag, set, help)
        ->default_str(fmt::format("{}", options.*option.value))
        ->type_name(type);
  }
};

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const auto value = parse_whole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> parse_count(std::string_view text) {
  return parse_whole<int>(text);
}

CLI::Option* add_choice_flag(CLI::App& app, const std::string& flag, const std::string& help,
                             std::span<const std::string_view> names,
                             const std::function<void(int)>& choose) {
  const auto parse = [flag, names, choose](const std::string& text) {
    const auto name = std::find(names.begin(), names.end(), text);
    if (name == names.end()) {
      throw CLI::ValidationError(flag, fmt::format("\"{}\" is not one of {}", text, fmt::join(names, ", ")));
    }
    choose(static_cast<int>(name - names.begin()));
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
  return app.add_option_function<std::string>(flag, parse, help)->type_name("SCALE");
}

CLI::Option* add_size_flag(CLI::App& app, const std::string& flag, std::optional<OutputSize>& into,
                           const std::string& help) {
  const auto parse = [&into](const std::string& text) {
    into = parse_size(text);
    if (!into) {
      throw CLI::ValidationError(
          "--size",
          fmt::format("\"{}\" is not a size like 1280x960 with sides from 1 to {}", text, kMaxSide));
    }
  };
  return app.add_option_function<std::string>(flag, parse, help)->type_name("WxH");
}

void add_option_flags(CLI::App& app, Options& options) {
  for (const OptionInfo& option : option_table()) {
    std::visit(FlagAdder{app, options, fmt::format("--{}", option.name), std::string(option.help)},
               option.kind);
  }
}

}  // namespace depixel
