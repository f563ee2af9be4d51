#pragma once

#include "apps/depixel/command_line.hpp"

namespace depixel {

/// Reads, vectorizes and writes all frames. What goes wrong is told on standard error, as one sentence.
/// \return the exit code to end with.
int convert(const Arguments& arguments);

}  // namespace depixel
