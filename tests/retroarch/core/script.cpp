#include "tests/retroarch/core/script.hpp"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "apps/common/files.hpp"
#include "apps/common/frame_source.hpp"
#include "apps/common/inputs.hpp"
#include "tests/retroarch/core/core_frame.hpp"

namespace depixel::test {
namespace {

using Words = std::vector<std::string>;
using Done = tl::expected<void, Error>;

constexpr unsigned kMaxSide = 4096, kMaxTimes = 1'000'000, kMaxPadding = 4096;

tl::unexpected<Error> wrong(std::string message) {
  return tl::unexpected(Error{std::move(message)});
}

std::optional<unsigned> parse_unsigned(std::string_view text, unsigned maximum) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value > maximum) return std::nullopt;
  return value;
}

std::optional<Size> parse_size(std::string_view text) {
  const auto cross = text.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  const auto width = parse_unsigned(text.substr(0, cross), kMaxSide),
             height = parse_unsigned(text.substr(cross + 1), kMaxSide);
  if (width.value_or(0) == 0 || height.value_or(0) == 0) return std::nullopt;
  return Size{*width, *height};
}

/// Carries out the lines of a script, one after the other.
class ScriptReader {
 public:
  explicit ScriptReader(std::filesystem::path folder) : folder_(std::move(folder)) {}

  Done read(const std::string& line);
  const Script& script() const { return script_; }

 private:
  /// A word that begins a line, and what follows it.
  struct Verb {
    std::string_view name, arguments;
    std::size_t fewest, most;
    bool (ScriptReader::*obey)(const Words& arguments);
  };
  static const std::array<Verb, 8> kVerbs;

  // Each returns false where the arguments are not what the verb takes.
  bool format(const Words& arguments);
  bool geometry(const Words& arguments);
  bool padding(const Words& arguments);
  bool show(const Words& arguments);
  bool duplicate(const Words& arguments);
  bool resize(const Words& arguments);
  bool av_info(const Words& arguments);
  bool rotate(const Words& arguments);

  /// Decodes pictures to the end of the script's frames.
  Done decode(const std::string& pictures);
  static std::optional<Geometry> parse_geometry(const Words& arguments);

  std::filesystem::path folder_;
  std::size_t padding_ = 0;
  Script script_;
  Done failure_;  ///< of a verb whose arguments are right
};

const std::array<ScriptReader::Verb, 8> ScriptReader::kVerbs{{
    {"format", "xrgb8888, rgb565 or 0rgb1555, before the first picture", 1, 1, &ScriptReader::format},
    {"geometry", "a size such as 320x240 and perhaps a larger one, before the first picture", 1, 2,
     &ScriptReader::geometry},
    {"padding", "a number of bytes that is a whole number of pixels", 1, 1, &ScriptReader::padding},
    {"show", "pictures and perhaps a number of times", 1, 2, &ScriptReader::show},
    {"duplicate", "perhaps a number of times, after a picture", 0, 1, &ScriptReader::duplicate},
    {"resize", "a size such as 320x240", 1, 1, &ScriptReader::resize},
    {"av_info", "a size such as 320x240 and perhaps a larger one", 1, 2, &ScriptReader::av_info},
    {"rotate", "0, 90, 180 or 270", 1, 1, &ScriptReader::rotate},
}};

Done ScriptReader::read(const std::string& line) {
  std::istringstream stream(line.substr(0, line.find('#')));
  std::string name;
  if (!(stream >> name)) return {};
  Words arguments;
  for (std::string word; stream >> word;) arguments.push_back(word);
  for (const Verb& verb : kVerbs) {
    if (verb.name != name) continue;
    const bool fits = arguments.size() >= verb.fewest && arguments.size() <= verb.most;
    if (!fits || !(this->*verb.obey)(arguments))
      return wrong(fmt::format("{} takes {}.", name, verb.arguments));
    return failure_;
  }
  return wrong(fmt::format("There is no action {}.", name));
}

bool ScriptReader::format(const Words& arguments) {
  constexpr std::array<std::pair<std::string_view, PixelFormat>, 3> kFormats{
      {{"xrgb8888", PixelFormat::xrgb8888},
       {"rgb565", PixelFormat::rgb565},
       {"0rgb1555", PixelFormat::xrgb1555}}};
  for (const auto& [name, format] : kFormats) {
    if (name != arguments[0]) continue;
    script_.format = format;
    return script_.frames.empty();
  }
  return false;
}

std::optional<Geometry> ScriptReader::parse_geometry(const Words& arguments) {
  const auto base = parse_size(arguments.front()), maximum = parse_size(arguments.back());
  if (!base || !maximum || maximum->width < base->width || maximum->height < base->height)
    return std::nullopt;
  return Geometry{*base, *maximum};
}

bool ScriptReader::geometry(const Words& arguments) {
  const auto geometry = parse_geometry(arguments);
  script_.geometry = geometry.value_or(Geometry{});
  return geometry && script_.frames.empty();
}

bool ScriptReader::padding(const Words& arguments) {
  const auto bytes = parse_unsigned(arguments[0], kMaxPadding);
  padding_ = bytes.value_or(0);
  return bytes && padding_ % pixel_bytes(script_.format) == 0;
}

bool ScriptReader::show(const Words& arguments) {
  const auto times = arguments.size() > 1 ? parse_unsigned(arguments[1], kMaxTimes) : 1;
  if (times.value_or(0) == 0) return false;
  const std::size_t first = script_.frames.size();
  failure_ = decode(arguments[0]);
  for (unsigned i = 0; i < *times; ++i) {
    for (std::size_t frame = first; frame < script_.frames.size(); ++frame) {
      script_.actions.emplace_back(ShowFrame{frame});
    }
  }
  return true;
}

Done ScriptReader::decode(const std::string& pictures) {
  auto inputs = find_inputs({(folder_ / pictures).string()});
  if (!inputs) return tl::unexpected(inputs.error());
  FrameSource source(std::move(*inputs));
  for (;;) {
    const auto frame = source.next();
    if (!frame) return tl::unexpected(frame.error());
    if (!*frame) return {};
    script_.frames.push_back(core_frame((*frame)->picture, script_.format, padding_));
  }
}

bool ScriptReader::duplicate(const Words& arguments) {
  const auto times = arguments.empty() ? 1 : parse_unsigned(arguments[0], kMaxTimes);
  if (times.value_or(0) == 0 || script_.frames.empty()) return false;
  script_.actions.insert(script_.actions.end(), *times, Duplicate{});
  return true;
}

bool ScriptReader::resize(const Words& arguments) {
  const auto size = parse_size(arguments[0]);
  if (size) script_.actions.emplace_back(SetGeometry{*size});
  return size.has_value();
}

bool ScriptReader::av_info(const Words& arguments) {
  const auto geometry = parse_geometry(arguments);
  if (geometry) script_.actions.emplace_back(SetAvInfo{*geometry});
  return geometry.has_value();
}

bool ScriptReader::rotate(const Words& arguments) {
  constexpr unsigned kQuarter = 90, kTurns = 4;
  const auto degrees = parse_unsigned(arguments[0], kQuarter * (kTurns - 1));
  if (!degrees || *degrees % kQuarter != 0) return false;
  script_.actions.emplace_back(SetRotation{*degrees / kQuarter});
  return true;
}

}  // namespace

tl::expected<Script, Error> load_script(const std::filesystem::path& file) {
  const auto text = read_file(file);
  if (!text) return tl::unexpected(text.error());
  std::istringstream lines(std::string(text->begin(), text->end()));
  ScriptReader reader(file.parent_path());
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (const Done done = reader.read(line); !done) {
      return wrong(fmt::format("{}, line {}: {}", file.string(), number, done.error().message));
    }
  }
  if (reader.script().frames.empty()) return wrong(fmt::format("{} shows no picture.", file.string()));
  if (reader.script().geometry.base.width == 0)
    return wrong(fmt::format("{} gives no geometry.", file.string()));
  return reader.script();
}

}  // namespace depixel::test
