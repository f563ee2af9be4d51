#include "apps/common/input_guard.hpp"

#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <optional>

namespace depixel {
namespace {

using FileId = std::pair<std::uint64_t, std::uint64_t>;

std::optional<FileId> file_id(const std::filesystem::path& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return std::nullopt;
  return FileId(info.st_dev, info.st_ino);
}

/// Of the file that standard input was redirected from; some id that no file has where it is a pipe.
std::optional<FileId> standard_input_id() {
  struct stat info {};
  if (::fstat(STDIN_FILENO, &info) != 0) return std::nullopt;
  return FileId(info.st_dev, info.st_ino);
}

}  // namespace

InputGuard::InputGuard(const std::vector<std::filesystem::path>& inputs) {
  for (const auto& input : inputs) {
    if (const auto id = input == "-" ? standard_input_id() : file_id(input)) inputs_.insert(*id);
  }
}

tl::expected<void, Error> InputGuard::allows(const std::filesystem::path& path) const {
  const auto id = file_id(path);
  if (!id || !inputs_.contains(*id)) return {};
  return tl::unexpected(Error{fmt::format("{} is an input and is not overwritten.", path.string())});
}

}  // namespace depixel
