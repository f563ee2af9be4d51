#include "tests/support/svg_tools.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <system_error>

#include "tests/support/test_pictures.hpp"

namespace depixel::test {
namespace {

constexpr double kThousand = 1000;

/// Reads the numbers and letters of a path's data one after the other.
class PathReader {
 public:
  explicit PathReader(std::string_view data) : rest_(data) {}

  SvgPath read() {
    while (!rest_.empty()) {
      if (std::isalpha(static_cast<unsigned char>(rest_.front()))) {
        command_ = rest_.front();
        rest_.remove_prefix(1);
        if (command_ == 'z') close();
      } else if (!step()) {
        return {};
      }
    }
    return path_;
  }

 private:
  bool step() {
    switch (command_) {
      case 'M':
      case 'm':
        move(command_ == 'M' ? vector() : point());
        return true;
      case 'h':
        line(at_ + glm::i64vec2(number(), 0));
        return true;
      case 'v':
        line(at_ + glm::i64vec2(0, number()));
        return true;
      case 'l':
        line(point());
        return true;
      case 'c':
      case 's': {
        const glm::i64vec2 p1 = command_ == 'c' ? point() : cubic_next_, p2 = point();
        cubic(p1, p2, point());
        return true;
      }
      case 'q':
      case 't': {
        const glm::i64vec2 control = command_ == 'q' ? point() : quadratic_next_;
        quadratic(control, point());
        return true;
      }
      default:
        return false;
    }
  }

  void move(glm::i64vec2 to) {
    path_.polygons.emplace_back();
    start_ = to;
    arrive(to);
    command_ = command_ == 'M' ? 'L' : 'l';
  }

  void close() {
    if (at_ != start_) line(start_);
  }

  glm::i64vec2 vector() {
    const std::int64_t x = number(), y = number();
    return {x, y};
  }
  glm::i64vec2 point() { return at_ + vector(); }

  /// A sign or a second decimal point ends a number, and so do spaces.
  std::int64_t number() {
    while (rest_.starts_with(' ')) rest_.remove_prefix(1);
    std::size_t length = rest_.starts_with('-') ? 1 : 0;
    for (bool has_point = false; length < rest_.size(); ++length) {
      const bool is_point = rest_[length] == '.';
      if (is_point ? has_point : std::isdigit(static_cast<unsigned char>(rest_[length])) == 0) break;
      has_point = has_point || is_point;
    }
    const double value = std::strtod(std::string(rest_.substr(0, length)).c_str(), nullptr);
    rest_.remove_prefix(std::max<std::size_t>(1, length));
    return std::llround(value * kThousand);
  }

  void arrive(glm::i64vec2 to) { at_ = cubic_next_ = quadratic_next_ = to; }

  void line(glm::i64vec2 to) {
    path_.area_60 += 30 * cross(at_, to);
    path_.polygons.back().push_back(glm::dvec2(to) / kThousand);
    arrive(to);
  }

  void cubic(glm::i64vec2 p1, glm::i64vec2 p2, glm::i64vec2 p3) {
    path_.area_60 += 3 * area_20(at_, p1, p2, p3);
    append_curve(glm::dvec2(at_) / kThousand, glm::dvec2(p1) / kThousand, glm::dvec2(p2) / kThousand,
                 glm::dvec2(p3) / kThousand, path_.polygons.back());
    arrive(p3);
    cubic_next_ = 2L * p3 - p2;
  }

  void quadratic(glm::i64vec2 control, glm::i64vec2 to) {
    path_.area_60 += 10 * (2 * cross(at_, control) + 2 * cross(control, to) + cross(at_, to));
    const glm::dvec2 p0 = glm::dvec2(at_) / kThousand, q = glm::dvec2(control) / kThousand,
                     p3 = glm::dvec2(to) / kThousand;
    append_curve(p0, (p0 + 2.0 * q) / 3.0, (p3 + 2.0 * q) / 3.0, p3, path_.polygons.back());
    arrive(to);
    quadratic_next_ = 2L * to - control;
  }

  static std::int64_t cross(glm::i64vec2 a, glm::i64vec2 b) { return a.y * b.x - a.x * b.y; }

  std::string_view rest_;
  char command_ = 0;
  glm::i64vec2 start_{0, 0}, at_{0, 0}, cubic_next_{0, 0}, quadratic_next_{0, 0};
  SvgPath path_;
};

/// What an element or those round it say of an attribute.
std::string inherited(pugi::xml_node node, const char* name) {
  while (node && !node.attribute(name)) node = node.parent();
  return node.attribute(name).value();
}

/// A colour with all six digits.
std::string long_colour(const std::string& text) {
  if (text.size() != 4) return text;
  std::string digits = "#";
  for (const char digit : text.substr(1)) digits.append(2, digit);
  return digits;
}

bool is_within(pugi::xml_node node, std::string_view name) {
  while (node && name != node.name()) node = node.parent();
  return static_cast<bool>(node);
}

std::string quoted(const std::filesystem::path& file) {
  return "'" + file.string() + "'";
}

/// A folder of this process, as long as it is needed.
struct ScratchFolder {
  std::filesystem::path path;

  explicit ScratchFolder(const std::string& name)
      : path(std::filesystem::absolute(output_folder()) / (name + "-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
};

}  // namespace

bool is_inside(glm::dvec2 point, const std::vector<Polygon>& polygons) {
  bool inside = false;
  for (const Polygon& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if ((a.y > point.y) == (b.y > point.y)) continue;
      if (a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y) > point.x) inside = !inside;
    }
  }
  return inside;
}

void append_curve(glm::dvec2 p0, glm::dvec2 p1, glm::dvec2 p2, glm::dvec2 p3, Polygon& polygon, int pieces) {
  for (int i = 1; i <= pieces; ++i) {
    const double t = double(i) / pieces, s = 1 - t;
    polygon.push_back(s * s * s * p0 + 3 * s * s * t * p1 + 3 * s * t * t * p2 + t * t * t * p3);
  }
}

std::int64_t area_20(glm::i64vec2 p0, glm::i64vec2 p1, glm::i64vec2 p2, glm::i64vec2 p3) {
  const auto cross = [](glm::i64vec2 a, glm::i64vec2 b) { return a.y * b.x - a.x * b.y; };
  return 6 * cross(p0, p1) + 3 * cross(p0, p2) + cross(p0, p3) + 3 * cross(p1, p2) + 3 * cross(p1, p3) +
         6 * cross(p2, p3);
}

SvgPath parse_path_data(std::string_view data) {
  return PathReader(data).read();
}

std::vector<SvgPath> filled_paths(const pugi::xml_document& document) {
  std::vector<SvgPath> paths;
  for (const pugi::xpath_node& found :
       document.select_nodes("//path[not(@stroke)][not(ancestor::*[@id='shading'])]")) {
    const pugi::xml_node node = found.node();
    SvgPath path = parse_path_data(node.attribute("d").value());
    path.fill = long_colour(inherited(node, "fill"));
    path.in_defs = is_within(node, "defs");
    paths.push_back(std::move(path));
  }
  return paths;
}

Picture draw_with_rsvg(const std::string& svg, int width, int height) {
  const ScratchFolder folder("rsvg");
  const std::filesystem::path in = folder.path / "in.svg", out = folder.path / "out.png";
  std::ofstream(in) << svg;
  const std::string command = "rsvg-convert -w " + std::to_string(width) + " -h " + std::to_string(height) +
                              " -o " + quoted(out) + " " + quoted(in);
  return std::system(command.c_str()) == 0 ? load_picture(out) : Picture{};
}

bool has_chromium() {
  return std::system("command -v chromium >/dev/null") == 0;
}

/// A page shows the documents one below the other; its picture is cut.
std::vector<Picture> draw_with_chromium(const std::vector<SvgToDraw>& documents) {
  const ScratchFolder folder("chromium");
  const std::filesystem::path out = folder.path / "out.png";
  std::ofstream page(folder.path / "page.html");
  page << "<!DOCTYPE html><style>*{margin:0}img{display:block}</style>";
  int width = 0, height = 0;
  for (const SvgToDraw& document : documents) {
    const std::string name = std::to_string(height) + ".svg";
    std::ofstream(folder.path / name) << document.svg;
    page << "<img src=" << name << " width=" << document.width << " height=" << document.height << ">";
    width = std::max(width, document.width);
    height += document.height;
  }
  page.close();
  const std::string command =
      "timeout 100 chromium --headless --no-sandbox --disable-gpu --hide-scrollbars "
      "--force-device-scale-factor=1 --default-background-color=00000000 --user-data-dir=" +
      quoted(folder.path / "profile") + " --window-size=" + std::to_string(width) + "," +
      std::to_string(height) + " --screenshot=" + quoted(out) + " file://" +
      quoted(folder.path / "page.html") + " >/dev/null 2>&1";
  if (std::system(command.c_str()) != 0) return {};
  const Picture all = load_picture(out);
  if (all.width != width || all.height != height) return {};
  std::vector<Picture> pictures;
  int top = 0;
  for (const SvgToDraw& document : documents) {
    pictures.emplace_back(document.width, document.height);
    paste(pictures.back(), all, 0, -top);
    top += document.height;
  }
  return pictures;
}

}  // namespace depixel::test
