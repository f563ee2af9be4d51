#include "apps/depixel/outputs.hpp"

#include <fmt/core.h>

#include <optional>
#include <string_view>
#include <system_error>

#include "apps/common/files.hpp"
#include "apps/common/frame_source.hpp"

namespace depixel {
namespace {

namespace fs = std::filesystem;

std::optional<Format> format_by_ending(const fs::path& path) {
  const std::string ending = lower_ending(path);
  if (ending == ".svg") return Format::svg;
  if (ending == ".png") return Format::png;
  return std::nullopt;
}

std::string_view ending(Format format) {
  return format == Format::svg ? ".svg" : ".png";
}

/// Whether the file may hold several frames, which are then numbered.
bool may_be_animated(const fs::path& path) {
  const std::string ending = lower_ending(path);
  return ending == ".gif" || ending == ".y4m";
}

}  // namespace

tl::expected<Outputs, Error> Outputs::plan(const Arguments& arguments, bool sequence) {
  const auto wrong = [](std::string message) { return tl::unexpected(Error{std::move(message)}); };
  std::error_code ignored;
  Outputs outputs;
  outputs.out_ = arguments.output;
  outputs.format_ = arguments.format.value_or(Format::png);

  if (arguments.output == "-") {
    outputs.place_ = Place::standard_output;
    if (sequence) return wrong("a sequence is written to a folder, not to standard output");
    if (arguments.stats == StatsForm::json)
      return wrong("--stats=json and the picture cannot both go to standard output");
    return outputs;
  }
  if (outputs.out_.empty()) return wrong("--output is empty");
  const bool folder = fs::is_directory(outputs.out_, ignored) || !outputs.out_.has_filename();
  const auto by_ending = format_by_ending(outputs.out_);
  if (folder || (sequence && !by_ending)) {
    outputs.place_ = Place::folder;
    return outputs;
  }
  if (sequence)
    return wrong(fmt::format("a sequence is written to a folder, and {} is not one", arguments.output));
  if (!by_ending) return wrong(fmt::format("{} ends neither in .svg nor in .png", arguments.output));
  if (arguments.format.value_or(*by_ending) != *by_ending) {
    return wrong(fmt::format("--format contradicts the ending of {}", arguments.output));
  }
  outputs.format_ = *by_ending;
  return outputs;
}

tl::expected<void, Error> Outputs::prepare(const std::vector<fs::path>& inputs) {
  guard_ = InputGuard(inputs);
  if (place_ == Place::standard_output) return {};

  std::set<fs::path> planned;
  for (const fs::path& input : inputs) {
    if (may_be_animated(input)) continue;
    const fs::path path = path_for(output_name(input));
    if (!planned.insert(path).second) {
      return tl::unexpected(Error{fmt::format("Two inputs would both be written to {}.", path.string())});
    }
    if (auto allowed = guard_.allows(path); !allowed) return allowed;
  }
  if (place_ != Place::folder) return {};
  std::error_code error;
  fs::create_directories(out_, error);
  if (!error) return {};
  return tl::unexpected(
      Error{fmt::format("The folder {} cannot be made: {}.", out_.string(), error.message())});
}

tl::expected<void, Error> Outputs::write(const std::string& name, std::span<const std::uint8_t> file) {
  if (place_ == Place::standard_output) return write_standard_output(file);
  const fs::path path = path_for(name);
  if (auto allowed = guard_.allows(path); !allowed) return allowed;
  if (!written_.insert(path).second) {
    return tl::unexpected(Error{fmt::format("Two inputs would both be written to {}.", path.string())});
  }
  return write_file(path, file);
}

fs::path Outputs::path_for(const std::string& name) const {
  return place_ == Place::folder ? out_ / (name + std::string(ending(format_))) : out_;
}

}  // namespace depixel
