#pragma once

#include <fmt/core.h>

#include <string_view>

#include "libdepixel/core/error.hpp"

namespace depixel {

/// An error, with the name of the frame that it is about.
inline Error about_frame(std::string_view name, const Error& error) {
  return {fmt::format("Frame {}: {}", name, error.message)};
}

}  // namespace depixel
