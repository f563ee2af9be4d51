#include "apps/common/inputs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <system_error>

#include "apps/common/files.hpp"
#include "apps/common/natural_order.hpp"

namespace depixel {
namespace {

namespace fs = std::filesystem;

using Files = std::vector<fs::path>;

bool has_picture_ending(const fs::path& path) {
  constexpr std::array<std::string_view, 6> kEndings{".png", ".bmp", ".jpg", ".jpeg", ".gif", ".y4m"};
  return std::find(kEndings.begin(), kEndings.end(), lower_ending(path)) != kEndings.end();
}

/// A name with a number in it, as printf writes it with %d or %0Nd.
struct NumberedName {
  std::string prefix, suffix;
  int digits = 0;

  bool matches(std::string_view name) const {
    if (name.size() <= prefix.size() + suffix.size() || !name.starts_with(prefix) || !name.ends_with(suffix))
      return false;
    const std::string_view number = name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
    if (number.find_first_not_of("0123456789") != std::string_view::npos) return false;
    const auto length = static_cast<int>(number.size());
    return length == std::max(digits, 1) || (length > digits && number.front() != '0');
  }
};

std::optional<NumberedName> parse_numbered_name(std::string_view name) {
  const auto percent = name.find('%');
  const auto letter = name.find_first_not_of("0123456789", percent + 1);
  if (percent == std::string_view::npos || letter == std::string_view::npos || name[letter] != 'd')
    return std::nullopt;
  NumberedName numbered{std::string(name.substr(0, percent)), std::string(name.substr(letter + 1)), 0};
  const std::string_view width = name.substr(percent + 1, letter - percent - 1);
  if (!width.empty()) {
    const auto result = std::from_chars(width.data(), width.data() + width.size(), numbered.digits);
    if (result.ec != std::errc{} || width.front() != '0') return std::nullopt;
  }
  return numbered;
}

/// The files in a folder whose names are wanted, sorted naturally.
tl::expected<Files, Error> list_folder(const fs::path& folder,
                                       const std::function<bool(const fs::path&)>& wanted) {
  Files files;
  std::error_code error, ignored;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const fs::path name = it->path().filename();
    if (name.native().front() != '.' && wanted(name) && !it->is_directory(ignored))
      files.push_back(it->path());
  }
  if (error) {
    return tl::unexpected(Error{fmt::format("{} cannot be read: {}.", folder.string(), error.message())});
  }
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return naturally_before(a.filename().native(), b.filename().native());
  });
  return files;
}

tl::expected<Files, Error> find_in_folder(const fs::path& folder) {
  auto files = list_folder(folder, has_picture_ending);
  if (files && files->empty()) {
    return tl::unexpected(
        Error{fmt::format("{} holds no pictures: no .png, .bmp, .jpg, .gif or .y4m.", folder.string())});
  }
  return files;
}

tl::expected<Files, Error> find_numbered(const fs::path& pattern, const NumberedName& name) {
  const fs::path folder = pattern.has_parent_path() ? pattern.parent_path() : ".";
  auto files = list_folder(folder, [&](const fs::path& file) { return name.matches(file.native()); });
  if (files && files->empty()) {
    return tl::unexpected(Error{fmt::format("No file is numbered as {} says.", pattern.string())});
  }
  return files;
}

}  // namespace

tl::expected<Inputs, Error> find_inputs(const std::vector<std::string>& arguments) {
  Inputs inputs;
  for (const fs::path argument : arguments) {
    if (argument.empty()) return tl::unexpected(Error{"An input's name is empty."});
    std::error_code ignored;
    const bool folder = fs::is_directory(argument, ignored);
    const auto numbered =
        fs::exists(argument, ignored) ? std::nullopt : parse_numbered_name(argument.filename().native());
    tl::expected<Files, Error> files = Files{argument};
    if (folder) files = find_in_folder(argument);
    if (numbered) files = find_numbered(argument, *numbered);
    if (!files) return tl::unexpected(files.error());
    inputs.files.insert(inputs.files.end(), files->begin(), files->end());
    inputs.sequence |= folder || numbered.has_value();
  }
  inputs.sequence |= inputs.files.size() > 1;
  return inputs;
}

}  // namespace depixel
