#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "libdepixel/core/frame_view.hpp"

namespace depixel::test {

/// A picture that owns its pixels, rows without gaps.
struct Picture {
  int width = 0, height = 0;
  std::vector<Rgba> pixels;

  Picture() = default;
  Picture(int w, int h, Rgba fill = {}) : width(w), height(h), pixels(std::size_t(w) * h, fill) {}

  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
  Rgba& at(int x, int y) { return pixels[std::size_t(y) * width + x]; }
  Rgba at(int x, int y) const { return pixels[std::size_t(y) * width + x]; }

  FrameView view() const { return {bytes(), width, height, 4 * std::ptrdiff_t(width)}; }
  PictureView target() {
    return {const_cast<std::uint8_t*>(bytes()), width, height, 4 * std::ptrdiff_t(width)};
  }

  friend bool operator==(const Picture&, const Picture&) = default;

 private:
  const std::uint8_t* bytes() const { return reinterpret_cast<const std::uint8_t*>(pixels.data()); }
};

/// Copies a picture into another one, at an offset; what falls outside is left out.
inline void paste(Picture& into, const Picture& from, int x0, int y0) {
  for (int y = 0; y < from.height; ++y) {
    for (int x = 0; x < from.width; ++x) {
      if (into.contains(x0 + x, y0 + y)) into.at(x0 + x, y0 + y) = from.at(x, y);
    }
  }
}

/// One of the eight ways to lay a w x h picture on the grid: mirrored left to right or not, then turned
/// clockwise.
struct Symmetry {
  bool mirrored = false;
  int quarter_turns = 0;

  /// Where a point of the picture comes to lie; `size` is the picture's in the point's unit.
  glm::ivec2 operator()(glm::ivec2 p, glm::ivec2 size) const {
    if (mirrored) p.x = size.x - p.x;
    for (int i = 0; i < quarter_turns; ++i) {
      p = {size.y - p.y, p.x};
      size = {size.y, size.x};
    }
    return p;
  }
  glm::ivec2 size(glm::ivec2 s) const { return quarter_turns % 2 == 0 ? s : glm::ivec2(s.y, s.x); }
  /// Pixels are moved by their upper left corners, so their own extent has to be taken off.
  glm::ivec2 pixel(glm::ivec2 p, glm::ivec2 size_px) const { return (*this)(p, size_px - 1); }

  Picture operator()(const Picture& in) const {
    const glm::ivec2 in_size(in.width, in.height), out_size = size(in_size);
    Picture out(out_size.x, out_size.y);
    for (int y = 0; y < in.height; ++y) {
      for (int x = 0; x < in.width; ++x) {
        const glm::ivec2 to = pixel({x, y}, in_size);
        out.at(to.x, to.y) = in.at(x, y);
      }
    }
    return out;
  }
};

constexpr std::array<Symmetry, 8> kSymmetries{
    {{false, 0}, {false, 1}, {false, 2}, {false, 3}, {true, 0}, {true, 1}, {true, 2}, {true, 3}}};

}  // namespace depixel::test
