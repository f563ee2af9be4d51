#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "libdepixel/core/options.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): the library has it so
class App;
class Option;
}  // namespace CLI

namespace depixel {

/// A size in output pixels.
struct OutputSize {
  int width = 0, height = 0;
};

/// What programs say of --check-incremental.
inline constexpr std::string_view kCheckIncrementalHelp =
    "Compare every frame with one made from scratch; for finding errors";

/// Adds a flag for every row of the option table; parsing then writes to `options`, which must outlive the
/// app.
void add_option_flags(CLI::App& app, Options& options);

/// Adds a flag that takes one of some names, which must outlive the app.
/// \param choose  is told the index of the name that is given.
CLI::Option* add_choice_flag(CLI::App& app, const std::string& flag, const std::string& help,
                             std::span<const std::string_view> names, const std::function<void(int)>& choose);

/// Adds a flag that takes output pixels to an input pixel, above 0 and up to kMaxSide.
/// \param into  is written to by parsing and must outlive the app.
CLI::Option* add_scale_flag(CLI::App& app, const std::string& flag, std::optional<double>& into,
                            const std::string& help);

/// Adds a flag that takes a size such as 1280x960, with sides from min_side to kMaxSide.
/// \param into  is written to by parsing and must outlive the app.
CLI::Option* add_size_flag(CLI::App& app, const std::string& flag, std::optional<OutputSize>& into,
                           const std::string& help, int min_side = 1);

/// How the help writes the range of a flag's number: "0..255".
std::string range_name(double minimum, double maximum);

}  // namespace depixel
