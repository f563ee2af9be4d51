#include "tests/support/svg_tools.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

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
        path_.polygons.emplace_back();
        start_ = at_ = {number(), number()};
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
      case 'c': {
        const glm::i64vec2 p1 = point(), p2 = point(), p3 = point();
        curve(p1, p2, p3);
        return true;
      }
      default:
        return false;
    }
  }

  void close() {
    if (at_ != start_) line(start_);
  }

  glm::i64vec2 point() {
    const std::int64_t x = number(), y = number();
    return at_ + glm::i64vec2(x, y);
  }

  std::int64_t number() {
    const std::string text(rest_.substr(0, 16));
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    rest_.remove_prefix(std::max<std::size_t>(1, static_cast<std::size_t>(end - text.c_str())));
    return std::llround(value * kThousand);
  }

  /// Thirds are not whole thousandths; thrice the control points are.
  void line(glm::i64vec2 to) {
    path_.area_20 += 10 * (at_.y * to.x - at_.x * to.y);
    path_.polygons.back().push_back(glm::dvec2(to) / kThousand);
    at_ = to;
  }

  void curve(glm::i64vec2 p1, glm::i64vec2 p2, glm::i64vec2 p3) {
    path_.area_20 += test::area_20(at_, p1, p2, p3);
    append_curve(glm::dvec2(at_) / kThousand, glm::dvec2(p1) / kThousand, glm::dvec2(p2) / kThousand,
                 glm::dvec2(p3) / kThousand, path_.polygons.back());
    at_ = p3;
  }

  std::string_view rest_;
  char command_ = 0;
  glm::i64vec2 start_{0, 0}, at_{0, 0};
  SvgPath path_;
};

std::string quoted(const std::filesystem::path& file) {
  return "'" + file.string() + "'";
}

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

void append_curve(glm::dvec2 p0, glm::dvec2 p1, glm::dvec2 p2, glm::dvec2 p3, Polygon& polygon) {
  constexpr int kPieces = 16;
  for (int i = 1; i <= kPieces; ++i) {
    const double t = double(i) / kPieces, s = 1 - t;
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
  for (const pugi::xpath_node& found : document.select_nodes("//path[@fill!='none'][not(ancestor::*[@id='shading'])]")) {
    const pugi::xml_node node = found.node();
    SvgPath path = parse_path_data(node.attribute("d").value());
    path.fill = node.attribute("fill").value();
    path.in_defs = std::string_view(node.parent().parent().name()) == "defs";
    paths.push_back(std::move(path));
  }
  return paths;
}

Picture draw_with_rsvg(const std::string& svg, int width, int height) {
  const std::filesystem::path folder = output_folder() / ("rsvg-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const std::filesystem::path in = folder / "in.svg", out = folder / "out.png";
  std::ofstream(in) << svg;
  const std::string command = "rsvg-convert -w " + std::to_string(width) + " -h " + std::to_string(height) +
                              " -o " + quoted(out) + " " + quoted(in);
  Picture picture;
  if (std::system(command.c_str()) == 0) picture = load_picture(out);
  std::filesystem::remove_all(folder);
  return picture;
}

}  // namespace depixel::test
