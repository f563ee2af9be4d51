#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "libdepixel/core/options.hpp"
#include "libdepixel/views/stage_view.hpp"

namespace depixel {

enum class Format { svg, png };
enum class StatsForm { none, table, json };

struct OutputSize {
  int width = 0, height = 0;  ///< output pixels
};

/// What the command line asks for; every value is in its range.
struct Arguments {
  std::vector<std::string> inputs;
  std::string output;
  std::optional<double> scale;  ///< not together with size
  std::optional<OutputSize> size;
  Options options;
  std::optional<StageView> stage;
  std::optional<Format> format;
  bool verify = false;
  StatsForm stats = StatsForm::none;
  bool quiet = false;
};

/// Reads the command line. Help and version are printed here, and so is what is wrong with it, as one
/// sentence. \return the arguments, or the exit code to end with.
std::variant<Arguments, int> parse_command_line(int argc, char** argv);

}  // namespace depixel
