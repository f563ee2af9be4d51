#pragma once

#include <string>

#include "tests/apps/process.hpp"
#include "tests/retroarch/retroarch_run.hpp"

namespace depixel::test {

/// Lets the test core play a script. The picture fills a part of the screen, whatever the core says of its
/// shape. \param folder  for the script; paths in it are relative to this.
///
/// Width and height are the picture's, in screen pixels.
RetroArchRan play(const TemporaryFolder& folder, const std::string& script, int width, int height,
                  RetroArchRun run);

}  // namespace depixel::test
