#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "apps/common/option_flags.hpp"
#include "apps/headless/context_kind.hpp"
#include "libdepixel/core/options.hpp"
#include "libdepixel/core/tolerances.hpp"
#include "libdepixel/views/stage_view.hpp"

namespace depixel {

enum class Format { svg, png };
enum class Backend { cpu, gl };
enum class StatsForm { none, table, json };

/// What the command line asks for; every value is in its range.
struct Arguments {
  std::vector<std::string> inputs;
  std::string output;
  std::optional<double> scale;  ///< not together with size
  std::optional<OutputSize> size;
  Options options;
  std::optional<StageView> stage;
  std::optional<Format> format;
  double svg_tolerance_px = kSvgTolerance;
  Backend backend = Backend::cpu;
  std::optional<ContextKind> context;  ///< with Backend::gl only; none: whichever can be had
  bool verify = false;
  bool check_incremental = false;
  StatsForm stats = StatsForm::none;
  bool quiet = false;
};

/// Reads the command line. Help and version are printed here, and so is what is wrong with it, as one
/// sentence. \return the arguments, or the exit code to end with.
std::variant<Arguments, int> parse_command_line(int argc, char** argv);

}  // namespace depixel
