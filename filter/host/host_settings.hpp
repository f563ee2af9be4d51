#pragma once

#include <functional>
#include <optional>
#include <string>

#include "libdepixel/core/options.hpp"

namespace depixel {

/// What draws: the processor; OpenGL; or OpenGL where it is a graphics card's, and the processor elsewhere.
enum class HostBackend { automatic, cpu, gl };

/// What a user can choose in a preset.
struct HostSettings {
  static constexpr double kMinScale = 1, kMaxScale = 16;

  double scale = 4;  ///< output pixels to a source pixel
  HostBackend backend = HostBackend::automatic;
  Options options;
};

/// The text of a setting, or none where the preset has no such key.
using SettingText = std::function<std::optional<std::string>(const std::string& key)>;
/// Told a sentence for the user.
using Warn = std::function<void(const std::string&)>;

/// Reads the keys "scale", "backend", and every name of the option table with _ for -. A value that makes no
/// sense is warned of, and the default stays.
HostSettings read_host_settings(const SettingText& text_of, const Warn& warn);

/// The key of an option.
std::string setting_key(const OptionInfo& option);

}  // namespace depixel
