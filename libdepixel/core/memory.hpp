#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace depixel {

/// Memory that vectors hold, in bytes; what their elements hold in turn is not counted.
template <typename... Values>
std::size_t held_bytes(const std::vector<Values>&... vectors) {
  return (std::size_t{0} + ... + (vectors.capacity() * sizeof(Values)));
}

/// Whether bytes are all 0. Fast: most rows of marks are.
inline bool are_zero(const std::uint8_t* bytes, std::size_t count) {
  return count == 0 || (bytes[0] == 0 && std::memcmp(bytes, bytes + 1, count - 1) == 0);
}

}  // namespace depixel
