#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "apps/common/picture.hpp"
#include "tests/apps/process.hpp"

namespace depixel::test {

/// What RetroArch is to run, without a user and under a display of its own.
struct RetroArchRun {
  std::filesystem::path core = {}, content = {};
  std::filesystem::path filter = {};  ///< a preset; empty: none
  int frames = 30;
  int scale = 4;  ///< of the window: screen pixels to a pixel of the core's base geometry
  bool is_threaded = false;
  std::map<std::string, std::string> settings = {};  ///< more lines of its configuration
  std::vector<std::string> environment = {};         ///< more variables, as NAME=VALUE
};

/// How that ended.
struct RetroArchRan {
  int exit_code = -1;
  std::string log;     ///< all of it
  Picture screenshot;  ///< of the window's contents after the last frame; empty where there is none
  std::string errors;  ///< lines of the log that are errors, but for those that RetroArch always has here
};

/// Runs it, for a minute at most. Files of its own are in a folder of its own.
RetroArchRan run_retroarch(const RetroArchRun& wanted);

}  // namespace depixel::test
