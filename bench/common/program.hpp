#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

namespace depixel::bench {

/// The whole of a benchmark's main().
/// \param add_options  called with the program's CLI::App and its settings, as they are by default.
/// \param work         called with the settings that the command line says.
/// \return the exit code: 2 for wrong usage, 1 where work() throws, which is told on standard error.
template <typename Settings, typename AddOptions, typename Work>
int run_program(const char* name, int argc, char** argv, AddOptions add_options, Work work) {
  try {
    CLI::App app;
    app.name(name);
    Settings settings;
    add_options(app, settings);
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      return app.exit(error) == 0 ? 0 : 2;
    }
    work(settings);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return 1;
  }
}

}  // namespace depixel::bench
