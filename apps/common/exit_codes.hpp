#pragma once

namespace depixel {

/// How the program ends.
enum ExitCode { kExitDone = 0, kExitFailed = 1, kExitUsage = 2 };

}  // namespace depixel
