#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "libdepixel/core/error.hpp"

namespace depixel {

/// Reads a file whole, or standard input where the path is "-". Refuses more than kMaxFileBytes.
tl::expected<std::vector<std::uint8_t>, Error> read_file(const std::filesystem::path& path);

/// Writes a file whole or not at all: to a temporary name in the same folder, which is renamed at the end.
/// A symbolic link is followed; what exists but is no regular file is refused.
tl::expected<void, Error> write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// Writes to standard output.
tl::expected<void, Error> write_standard_output(std::span<const std::uint8_t> bytes);

/// The bytes of a text.
inline std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace depixel
