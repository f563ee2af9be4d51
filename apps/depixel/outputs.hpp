#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "apps/common/input_guard.hpp"
#include "apps/depixel/command_line.hpp"
#include "libdepixel/core/error.hpp"

namespace depixel {

/// Where pictures go and of which kind they are. Never writes over an input, nor twice to one file.
class Outputs {
 public:
  /// Decides by OUT, its ending and --format. \return what is wrong with the usage, if anything.
  static tl::expected<Outputs, Error> plan(const Arguments& arguments, bool sequence);

  Format format() const { return format_; }
  bool to_standard_output() const { return place_ == Place::standard_output; }

  /// Makes the folder, if there is to be one, and refuses names that would collide, as far as they are known
  /// before the inputs are read (the frames of GIFs and streams are not).
  tl::expected<void, Error> prepare(const std::vector<std::filesystem::path>& inputs);

  /// Writes the picture of the frame of that name.
  tl::expected<void, Error> write(const std::string& name, std::span<const std::uint8_t> file);

 private:
  enum class Place { file, folder, standard_output };

  std::filesystem::path path_for(const std::string& name) const;

  Place place_ = Place::file;
  Format format_ = Format::png;
  std::filesystem::path out_;
  InputGuard guard_;
  std::set<std::filesystem::path> written_;
};

}  // namespace depixel
