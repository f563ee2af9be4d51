#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "libdepixel/core/color.hpp"

namespace depixel {

/// The `d` attribute of an SVG path, in relative coordinates of 1/1000 pixel.
///
/// Points are rounded before differences are taken, so paths that share a point on the map share it in the
/// file too.
class SvgPathData {
 public:
  explicit SvgPathData(std::string& out) : out_(out) {}

  void move_to(glm::ivec2 to_subpixels);
  void line_to(glm::ivec2 to_subpixels);
  /// A cubic curve; written as a line where its control points lie on its chord's thirds.
  void curve_to(glm::ivec2 p1_subpixels, glm::ivec2 p2_subpixels, glm::ivec2 to_subpixels);
  void close() { command('z'); }

 private:
  void command(char letter);
  void number(int thousandths);

  std::string& out_;
  glm::ivec2 exact_{0, 0};  ///< the current point, in subpixels
  glm::ivec2 at_{0, 0};     ///< the current point as written, in thousandths
  char last_ = 0;           ///< a command's letter is written only where it changes
  bool needs_space_ = false;
};

/// A length in pixels as a whole number of thousandths.
int svg_thousandths(double pixels);
/// Appends a whole or decimal number given in thousandths: 1500 is "1.5", -250 is "-.25".
void append_svg_number(std::string& out, int thousandths);
/// Appends the attributes that paint with a colour: ` fill="#rrggbb"`, and ` fill-opacity` where it is not
/// opaque. \param what  "fill" or "stroke".
void append_svg_paint(std::string& out, std::string_view what, Rgba colour);

/// Gathers shapes that partition a picture, and drawings on top of it, to an SVG document in source pixels.
///
/// Renderers let the background through where shapes meet. So opaque shapes are defined once and drawn twice:
/// without anti-aliasing, which leaves no gaps, and with it, on top. Where there is anything else than opaque
/// shapes, a mask keeps the first drawing off the silhouette's pixels, which the second one alone then gives
/// their coverage. Translucent shapes are drawn once.
class SvgDocument {
 public:
  SvgDocument(int width_px, int height_px) : width_(width_px), height_(height_px) {}

  /// A shape, by its path data. Shapes that meet turn the same way round, holes the other way.
  void add_shape(Rgba colour, std::string_view path_data);
  /// Elements on top of all shapes.
  std::string& overlay() { return overlay_; }

  std::string finish() const;

 private:
  struct Shape {
    Rgba colour;
    std::size_t data_bytes;
  };

  int width_, height_;
  std::vector<Shape> opaque_;
  std::string opaque_data_;  ///< the shapes' path data, one after the other
  std::string translucent_;  ///< elements
  std::string beside_data_;  ///< path data of all that is not opaque
  std::string overlay_;
};

}  // namespace depixel
