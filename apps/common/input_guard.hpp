#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "libdepixel/core/error.hpp"

namespace depixel {

/// Keeps a program from writing over its inputs. It knows them by device and inode, so that links and other
/// spellings of a path make no difference.
class InputGuard {
 public:
  InputGuard() = default;
  /// \param inputs  files that exist, or not; "-" is the file that standard input is redirected from.
  explicit InputGuard(const std::vector<std::filesystem::path>& inputs);

  /// \return an error if writing to the path would replace an input.
  tl::expected<void, Error> allows(const std::filesystem::path& path) const;

 private:
  using FileId = std::pair<std::uint64_t, std::uint64_t>;  ///< device and inode
  std::set<FileId> inputs_;
};

}  // namespace depixel
