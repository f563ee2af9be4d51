#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "libdepixel/core/error.hpp"

namespace depixel {

/// A stream of the C library, closed at the end of its life, except for standard input.
struct CloseStream {
  void operator()(std::FILE* stream) const {
    if (stream != stdin) std::fclose(stream);
  }
};
using Stream = std::unique_ptr<std::FILE, CloseStream>;

/// Opens a file for reading, or standard input where the path is "-".
tl::expected<Stream, Error> open_stream(const std::filesystem::path& path);

/// Reads what is left of a stream. Refuses more than kMaxFileBytes. \param path  named in errors.
tl::expected<std::vector<std::uint8_t>, Error> read_rest(std::FILE* stream,
                                                         const std::filesystem::path& path);

/// Reads a file whole, or standard input where the path is "-". Refuses more than kMaxFileBytes.
tl::expected<std::vector<std::uint8_t>, Error> read_file(const std::filesystem::path& path);

/// Writes a file whole or not at all: to a temporary name in the same folder, which is renamed at the end.
/// A symbolic link is followed; what exists but is no regular file is refused.
tl::expected<void, Error> write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// Writes to standard output.
tl::expected<void, Error> write_standard_output(std::span<const std::uint8_t> bytes);

/// A name's ending with its dot, in small letters; empty if it has none.
std::string lower_ending(const std::filesystem::path& path);

/// Completes a decoder's sentence with the name of the file at its beginning.
tl::unexpected<Error> about_file(const std::filesystem::path& path, const Error& error);

/// The bytes of a text.
inline std::span<const std::uint8_t> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace depixel
