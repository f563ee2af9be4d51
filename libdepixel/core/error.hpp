#pragma once

#include <string>

namespace depixel {

/// Why something could not be done, as one sentence that a user can act on.
struct Error {
  std::string message;
};

}  // namespace depixel
