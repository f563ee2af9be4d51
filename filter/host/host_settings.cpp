#include "filter/host/host_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "filter/option_text.hpp"

namespace depixel {
namespace {

constexpr std::array<std::string_view, 3> kBackendNames{"auto", "cpu", "gl"};

tl::expected<void, Error> set_scale(HostSettings& settings, std::string_view text) {
  const auto scale = parse_number(text);
  if (!scale || *scale < HostSettings::kMinScale || *scale > HostSettings::kMaxScale) {
    return tl::unexpected(Error{fmt::format("\"{}\" is not a number from {} to {}", text,
                                            HostSettings::kMinScale, HostSettings::kMaxScale)});
  }
  settings.scale = *scale;
  return {};
}

tl::expected<void, Error> set_backend(HostSettings& settings, std::string_view text) {
  const auto index = parse_choice(text, kBackendNames);
  if (!index) return tl::unexpected(index.error());
  settings.backend = static_cast<HostBackend>(*index);
  return {};
}

}  // namespace

std::string setting_key(const OptionInfo& option) {
  std::string key(option.name);
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

HostSettings read_host_settings(const SettingText& text_of, const Warn& warn) {
  HostSettings settings;
  const auto read = [&](const std::string& key, const auto& set, const auto& kept) {
    const std::optional<std::string> text = text_of(key);
    if (!text) return;
    if (const auto done = set(*text); !done) {
      warn(fmt::format("The setting {} stays {}: {}.", key, kept(), done.error().message));
    }
  };
  read(
      "scale", [&](std::string_view text) { return set_scale(settings, text); },
      [&] { return fmt::format("{}", settings.scale); });
  read(
      "backend", [&](std::string_view text) { return set_backend(settings, text); },
      [&] { return std::string(kBackendNames[static_cast<std::size_t>(settings.backend)]); });
  for (const OptionInfo& option : option_table()) {
    read(
        setting_key(option),
        [&](std::string_view text) { return set_option(settings.options, option, text); },
        [&] { return option_text(settings.options, option); });
  }
  return settings;
}

}  // namespace depixel
