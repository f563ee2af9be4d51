#include "apps/player/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>

#include "apps/common/files.hpp"
#include "apps/common/limits.hpp"

namespace depixel {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Names = std::span<const std::string_view>;

constexpr std::array<std::string_view, 3> kAspectNames{"square", "8:7", "4:3"};
constexpr std::array<std::string_view, 2> kRawNames{"nearest", "bilinear"};
constexpr double kMinSpeed = 1.0 / 64, kMaxSpeed = 64;

/// Writes values to an object; Reader has the same functions, so that one list of fields serves both.
struct Writer {
  Json& object;

  template <typename Value>
  void value(std::string_view name, const Value& value) {
    object[std::string(name)] = value;
  }
  template <typename Number>
  void number(std::string_view name, const Number& number, Number minimum, Number maximum) {
    value(name, std::clamp(number, minimum, maximum));  // what a window has become may be beyond
  }
  template <typename Get, typename Set>
  void choice(std::string_view name, Names names, Get get, Set) {
    value(name, names[static_cast<std::size_t>(get())]);
  }
};

/// Reads values from an object. What is wrong is thrown as an exception, as nlohmann::json does.
struct Reader {
  const Json& object;

  template <typename Value>
  void value(std::string_view name, Value& value) {
    if (const auto found = object.find(std::string(name)); found != object.end()) found->get_to(value);
  }
  template <typename Number>
  void number(std::string_view name, Number& number, Number minimum, Number maximum) {
    value(name, number);
    if (!(number >= minimum && number <= maximum)) throw std::out_of_range(std::string(name));
  }
  template <typename Get, typename Set>
  void choice(std::string_view name, Names names, Get get, Set set) {
    std::string text(names[static_cast<std::size_t>(get())]);
    value(name, text);
    const auto found = std::find(names.begin(), names.end(), text);
    if (found == names.end()) throw std::out_of_range(std::string(name));
    set(static_cast<int>(found - names.begin()));
  }
};

template <typename Visitor, typename Enum>
void choose(Visitor& visitor, std::string_view name, Names names, Enum& value) {
  visitor.choice(
      name, names, [&] { return static_cast<int>(value); },
      [&](int index) { value = static_cast<Enum>(index); });
}

template <typename Visitor>
void visit(Visitor visitor, WindowSettings& window) {
  visitor.number("width", window.width, kMinWindowSide, kMaxSide);
  visitor.number("height", window.height, kMinWindowSide, kMaxSide);
  visitor.value("has_position", window.has_position);
  visitor.number("x", window.x, -kMaxSide, kMaxSide);
  visitor.number("y", window.y, -kMaxSide, kMaxSide);
}

template <typename Visitor>
void visit(Visitor visitor, LookSettings& look) {
  choose(visitor, "pixel_aspect", kAspectNames, look.aspect);
  visitor.value("whole_scales", look.whole_scales);
  visitor.value("panels", look.panels);
  visitor.value("outline", look.outline);
  visitor.value("split", look.split);
  visitor.number("divider", look.divider, 0.0, 1.0);
  choose(visitor, "raw", kRawNames, look.raw);
}

template <typename Visitor>
void visit(Visitor visitor, PlaySettings& play) {
  visitor.number("speed", play.speed, kMinSpeed, kMaxSpeed);
  visitor.value("loop", play.loop);
}

/// Visits one option; there is an overload for each kind of option.
template <typename Visitor>
struct OptionVisitor {
  Visitor& visitor;
  Options& options;
  std::string_view name;

  void operator()(const ChoiceOption& option) const {
    visitor.choice(
        name, option.names, [&] { return option.get(options); },
        [&](int index) { option.set(options, index); });
  }
  void operator()(const SwitchOption& option) const { visitor.value(name, options.*option.value); }
  void operator()(const NumberOption& option) const { number(option); }
  void operator()(const CountOption& option) const { number(option); }

  template <typename Option>
  void number(const Option& option) const {
    visitor.number(name, options.*option.value, option.minimum, option.maximum);
  }
};

template <typename Visitor>
void visit(Visitor visitor, Options& options) {
  for (const OptionInfo& option : option_table()) {
    std::visit(OptionVisitor<Visitor>{visitor, options, option.name}, option.kind);
  }
}

template <typename Part>
Json written(Part part) {
  Json object = Json::object();
  visit(Writer{object}, part);
  return object;
}

template <typename Part>
void read(const Json& file, const char* name, Part& part) {
  const auto found = file.find(name);
  if (found == file.end()) return;
  if (!found->is_object()) throw std::out_of_range(name);
  visit(Reader{*found}, part);
}

}  // namespace

std::string settings_text(const Settings& settings) {
  const Json file{{"window", written(settings.window)},
                  {"look", written(settings.look)},
                  {"play", written(settings.play)},
                  {"options", written(settings.options)},
                  {"last_folder", settings.last_folder}};
  // Names of folders may be no UTF-8.
  return file.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

tl::expected<Settings, Error> parse_settings(std::string_view text) {
  Settings settings;
  try {
    const Json file = Json::parse(text);
    if (!file.is_object()) return tl::unexpected(Error{"it is not a JSON object"});
    read(file, "window", settings.window);
    read(file, "look", settings.look);
    read(file, "play", settings.play);
    read(file, "options", settings.options);
    Reader{file}.value("last_folder", settings.last_folder);
  } catch (const Json::parse_error&) {
    return tl::unexpected(Error{"it is not JSON"});
  } catch (const Json::exception&) {
    return tl::unexpected(Error{"a value is of a wrong kind"});
  } catch (const std::out_of_range& error) {
    return tl::unexpected(Error{fmt::format("\"{}\" is out of range", error.what())});
  }
  return settings;
}

std::optional<fs::path> settings_path() {
  const auto variable = [](const char* name) -> std::optional<fs::path> {
    const char* value = std::getenv(name);
    if (value == nullptr || *value == '\0') return std::nullopt;
    return fs::path(value);
  };
  const fs::path file = fs::path("depixel") / "player.json";
  if (const auto config = variable("XDG_CONFIG_HOME")) return *config / file;
  if (const auto home = variable("HOME")) return *home / ".config" / file;
  return std::nullopt;
}

tl::expected<Settings, Error> load_settings(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return Settings{};
  const auto bytes = read_file(file);
  if (!bytes) return tl::unexpected(bytes.error());
  auto settings = parse_settings({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
  if (settings) return settings;
  return tl::unexpected(Error{
      fmt::format("The settings in {} are not used because {}.", file.string(), settings.error().message)});
}

tl::expected<void, Error> save_settings(const Settings& settings, const fs::path& file) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) {
    return tl::unexpected(Error{
        fmt::format("The folder {} cannot be made: {}.", file.parent_path().string(), error.message())});
  }
  return write_file(file, bytes_of(settings_text(settings)));
}

}  // namespace depixel
