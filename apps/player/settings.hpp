#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "apps/player/view_control.hpp"
#include "libdepixel/core/error.hpp"
#include "libdepixel/core/options.hpp"

namespace depixel {

/// What the raw frame beside the filtered one is drawn with.
enum class RawSampling { nearest, bilinear };

/// Shortest side of a window, in screen coordinates; the longest is kMaxSide.
constexpr int kMinWindowSide = 64;

/// The window, in screen coordinates.
struct WindowSettings {
  int width = 1280, height = 800;
  bool has_position = false;  ///< else the window system chooses
  int x = 0, y = 0;
};

/// How the picture is shown.
struct LookSettings {
  PixelAspect aspect = PixelAspect::square;
  bool whole_scales = false;
  bool panels = true;
  bool outline = true;  ///< of the component under the pointer
  bool split = false;
  double divider = 0.5;  ///< of the visible picture's width
  RawSampling raw = RawSampling::nearest;
};

struct PlaySettings {
  double speed = 1;
  bool loop = true;
};

/// Everything that is remembered from one run to the next.
struct Settings {
  WindowSettings window;
  LookSettings look;
  PlaySettings play;
  Options options;
  std::string last_folder;  ///< from which something was opened; empty at first
};

std::string settings_text(const Settings& settings);
/// Reads what settings_text() wrote; what is missing keeps its default, what is not known is passed over.
/// \return an error if the text is no JSON, or a value has a wrong type or is out of range.
tl::expected<Settings, Error> parse_settings(std::string_view text);

/// $XDG_CONFIG_HOME/depixel/player.json, by default in ~/.config; none if there is no home either.
std::optional<std::filesystem::path> settings_path();

/// Defaults if there is no file. The error names the file.
tl::expected<Settings, Error> load_settings(const std::filesystem::path& file);
/// Makes the folder if need be and replaces the file whole.
tl::expected<void, Error> save_settings(const Settings& settings, const std::filesystem::path& file);

}  // namespace depixel
