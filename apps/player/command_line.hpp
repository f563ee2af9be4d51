#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "apps/common/option_flags.hpp"
#include "apps/player/settings.hpp"
#include "libdepixel/views/stage_view.hpp"

namespace depixel {

/// What the player's command line asks for; every value is in its range.
struct PlayerArguments {
  std::vector<std::string> inputs;  ///< none: an empty window
  std::optional<double> scale;      ///< none: as large as fits
  std::optional<OutputSize> window_size;
  std::optional<StageView> stage;
  int frames = 0;          ///< to show before the program ends; 0: it is for the user to end
  std::string screenshot;  ///< of the last of those frames; empty: none
  bool hide_ui = false;
  bool no_config = false;
  bool print_stats = false;
  bool check_incremental = false;
};

/// Reads the command line over remembered settings: options that are given replace those of the settings.
/// Help, version and what is wrong are printed here. \return the arguments, or the exit code to end with.
std::variant<PlayerArguments, int> parse_player_command_line(int argc, char** argv, Options& options);

/// Whether the arguments say that nothing is to be remembered; asked for before settings are read.
bool wants_no_config(int argc, char** argv);

}  // namespace depixel
