#include "tests/support/map_segments.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "libdepixel/core/tolerances.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"

namespace depixel::test {
namespace {

/// Runs the other way when that comes first.
FreeSegment canonical(const FreeSegment& s) {
  const auto& p = s.points;
  const auto& side = s.side_pixels;
  const FreeSegment back{{p[6], p[7], p[4], p[5], p[2], p[3], p[0], p[1]},
                         {side[2], side[3], side[0], side[1]},
                         {s.side_colours[1], s.side_colours[0]}};
  return std::min(s, back);
}

}  // namespace

PlanarMap vectorized(const Picture& picture, const Options& options) {
  Vectorizer vectorizer;
  return vectorizer.vectorize(picture.view(), options);
}

std::ostream& operator<<(std::ostream& out, const FreeSegment& s) {
  for (int i = 0; i < 8; i += 2) {
    out << '(' << s.points[i] / double(kSubpixels) << ", " << s.points[i + 1] / double(kSubpixels) << ") ";
  }
  return out << "left " << s.side_pixels[0] << ',' << s.side_pixels[1] << " right " << s.side_pixels[2] << ','
             << s.side_pixels[3];
}

std::vector<FreeSegment> free_segments(const PlanarMap& map, const Symmetry& symmetry, glm::ivec2 shift_px) {
  const glm::ivec2 size_px(map.lattice.width(), map.lattice.height());
  std::vector<FreeSegment> list;
  list.reserve(map.segments.size());
  for (const Segment& s : map.segments) {
    FreeSegment f;
    int i = 0;
    for (const glm::ivec2 p : {s.p0, s.p1, s.p2, s.p3}) {
      const glm::ivec2 q = symmetry(p, size_px * kSubpixels) + shift_px * kSubpixels;
      f.points[i++] = q.x;
      f.points[i++] = q.y;
    }
    // A mirror swaps the sides.
    const std::array<int, 2> sides =
        symmetry.mirrored ? std::array{s.right, s.left} : std::array{s.left, s.right};
    for (int k = 0; k < 2; ++k) {
      const glm::ivec2 pixel = symmetry.pixel(map.lattice.pixel_position(sides[k]), size_px) + shift_px;
      f.side_pixels[2 * k] = pixel.x;
      f.side_pixels[2 * k + 1] = pixel.y;
      f.side_colours[k] = rgba_order(map.colours[sides[k]]);
    }
    list.push_back(canonical(f));
  }
  std::sort(list.begin(), list.end());
  return list;
}

std::string difference(const std::vector<FreeSegment>& expected, const std::vector<FreeSegment>& actual) {
  std::ostringstream text;
  const auto show = [&](const char* title, const auto& some, const auto& others) {
    std::vector<FreeSegment> rest;
    std::set_difference(some.begin(), some.end(), others.begin(), others.end(), std::back_inserter(rest));
    for (std::size_t i = 0; i < std::min<std::size_t>(rest.size(), 4); ++i) text << title << rest[i] << '\n';
  };
  show("expected only: ", expected, actual);
  show("actual only:   ", actual, expected);
  return text.str();
}

}  // namespace depixel::test
