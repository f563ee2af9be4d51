#include "filter/option_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <variant>

namespace depixel {
namespace {

template <typename Number>
std::optional<Number> parse_whole(std::string_view text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

/// Sets an option of each kind.
struct Setter {
  Options& options;
  std::string_view text;
  using Result = tl::expected<void, Error>;

  Result operator()(const ChoiceOption& choice) const {
    const auto index = parse_choice(text, choice.names);
    if (!index) return tl::unexpected(index.error());
    choice.set(options, *index);
    return {};
  }
  Result operator()(const SwitchOption& option) const {
    if (text != "true" && text != "false") {
      return tl::unexpected(Error{fmt::format("\"{}\" is neither true nor false", text)});
    }
    options.*option.value = text == "true";
    return {};
  }
  Result operator()(const NumberOption& option) const {
    return set_number(option, parse_number(text), "number");
  }
  Result operator()(const CountOption& option) const {
    return set_number(option, parse_count(text), "whole number");
  }

  template <typename Option, typename Value>
  Result set_number(const Option& option, Value value, std::string_view kind) const {
    if (!value || *value < option.minimum || *value > option.maximum) {
      return tl::unexpected(
          Error{fmt::format("\"{}\" is not a {} from {} to {}", text, kind, option.minimum, option.maximum)});
    }
    options.*option.value = *value;
    return {};
  }
};

/// Writes an option of each kind.
struct Writer {
  const Options& options;

  std::string operator()(const ChoiceOption& choice) const {
    return std::string(choice.names[static_cast<std::size_t>(choice.get(options))]);
  }
  std::string operator()(const SwitchOption& option) const {
    return options.*option.value ? "true" : "false";
  }
  std::string operator()(const NumberOption& option) const {
    return fmt::format("{}", options.*option.value);
  }
  std::string operator()(const CountOption& option) const { return fmt::format("{}", options.*option.value); }
};

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const auto value = parse_whole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> parse_count(std::string_view text) {
  return parse_whole<int>(text);
}

tl::expected<void, Error> set_option(Options& options, const OptionInfo& option, std::string_view text) {
  return std::visit(Setter{options, text}, option.kind);
}

std::string option_text(const Options& options, const OptionInfo& option) {
  return std::visit(Writer{options}, option.kind);
}

tl::expected<int, Error> parse_choice(std::string_view text, std::span<const std::string_view> names) {
  const auto name = std::find(names.begin(), names.end(), text);
  if (name == names.end()) {
    return tl::unexpected(Error{fmt::format("\"{}\" is not one of {}", text, fmt::join(names, ", "))});
  }
  return static_cast<int>(name - names.begin());
}

}  // namespace depixel
