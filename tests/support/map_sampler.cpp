#include "tests/support/map_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "libdepixel/core/tolerances.hpp"

namespace depixel::test {
namespace {

constexpr int kLinesPerRow = 64;
constexpr int kChordsPerCurve = 24;

struct Chord {
  glm::dvec2 from, to;  ///< output pixels
  glm::dvec4 left, right;
};

double light_of(double srgb) {
  const double v = srgb / 255;
  return 255 * (v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
}

/// All curves and the straight sides of the frame, cut into chords.
std::vector<Chord> chords_of(const PlanarMap& map, const View& view, bool linear_light) {
  std::vector<Chord> chords;
  const auto to_output = [&](glm::dvec2 p) {
    return glm::dvec2((p.x / kSubpixels - view.origin_x) * view.scale_x,
                      (p.y / kSubpixels - view.origin_y) * view.scale_y);
  };
  const auto colour = [&](int pixel) { return sample_of(map.colours[pixel], linear_light); };
  for (const Segment& s : map.segments) {
    const glm::dvec2 p0(s.p0), p1(s.p1), p2(s.p2), p3(s.p3);
    glm::dvec2 from = to_output(p0);
    for (int i = 1; i <= kChordsPerCurve; ++i) {
      const double t = double(i) / kChordsPerCurve, u = 1 - t;
      const glm::dvec2 to =
          to_output(u * u * u * p0 + 3 * u * u * t * p1 + 3 * u * t * t * p2 + t * t * t * p3);
      chords.push_back({from, to, colour(s.left), colour(s.right)});
      from = to;
    }
  }
  const int width = map.lattice.width();
  for (int y = 0; y < map.lattice.height(); ++y) {
    for (const int x : {0, width}) {
      const glm::dvec2 top(x * double(kSubpixels), y * double(kSubpixels)), bottom(top.x, top.y + kSubpixels);
      const glm::dvec4 inside = colour(map.lattice.pixel(x == 0 ? 0 : width - 1, y));
      // Going down, the left side lies to the east.
      chords.push_back({to_output(top), to_output(bottom), x == 0 ? inside : glm::dvec4(0),
                        x == 0 ? glm::dvec4(0) : inside});
    }
  }
  return chords;
}

struct Crossing {
  double x;
  glm::dvec4 change;  ///< from west to east
};

/// Adds a line's colours to a row of pixels.
void integrate(std::vector<Crossing>& crossings, int width, glm::dvec4* row) {
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
  glm::dvec4 colour(0);
  double x = 0;
  const auto advance_to = [&](double end) {
    for (end = std::clamp(end, 0.0, double(width)); x < end;) {
      const auto column = static_cast<int>(x);
      const double next = std::min(end, column + 1.0);
      row[column] += colour * ((next - x) / kLinesPerRow);
      x = next;
    }
  };
  for (const Crossing& crossing : crossings) {
    advance_to(crossing.x);
    colour += crossing.change;
  }
  advance_to(width);
}

}  // namespace

glm::dvec4 sample_of(Rgba c, bool linear_light) {
  const double alpha = c.a / 255.0;
  const auto level = [&](int v) { return alpha * (linear_light ? light_of(v) : v); };
  return {level(c.r), level(c.g), level(c.b), c.a};
}

std::vector<glm::dvec4> sampled(const PlanarMap& map, const View& view, bool linear_light, int width,
                                int height) {
  std::vector<std::vector<Crossing>> lines(std::size_t(height) * kLinesPerRow);
  for (const Chord& chord : chords_of(map, view, linear_light)) {
    const bool down = chord.from.y < chord.to.y;
    const glm::dvec2 top = down ? chord.from : chord.to, bottom = down ? chord.to : chord.from;
    const auto line_from = [&](double y) {
      return static_cast<int>(std::clamp(std::ceil(y * kLinesPerRow - 0.5), 0.0, double(lines.size())));
    };
    for (int line = line_from(top.y), end = line_from(bottom.y); line < end; ++line) {
      const double y = (line + 0.5) / kLinesPerRow;
      const double x = top.x + (bottom.x - top.x) * (y - top.y) / (bottom.y - top.y);
      lines[line].push_back({x, down ? chord.left - chord.right : chord.right - chord.left});
    }
  }
  std::vector<glm::dvec4> picture(std::size_t(width) * height, glm::dvec4(0));
  for (std::size_t line = 0; line < lines.size(); ++line) {
    integrate(lines[line], width, picture.data() + line / kLinesPerRow * width);
  }
  return picture;
}

}  // namespace depixel::test
