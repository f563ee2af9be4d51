#pragma once

#include <cstddef>
#include <vector>

namespace depixel {

/// Memory that vectors hold, in bytes; what their elements hold in turn is not counted.
template <typename... Values>
std::size_t held_bytes(const std::vector<Values>&... vectors) {
  return (std::size_t{0} + ... + (vectors.capacity() * sizeof(Values)));
}

}  // namespace depixel
