#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <string_view>

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
/// without anti-aliasing, which leaves no gaps, and with it, on top. Translucent shapes are drawn once.
class SvgDocument {
 public:
  SvgDocument(int width_px, int height_px) : width_(width_px), height_(height_px) {}

  /// Opens a shape, to be followed by its path data; nullptr for transparent shapes, which are not drawn.
  std::string* begin_shape(Rgba colour);
  /// Ends the shape that was opened.
  void end_shape(std::string* shape) { shape->append("\"/>\n"); }
  /// Elements on top of all shapes.
  std::string& overlay() { return overlay_; }

  std::string finish() const;

 private:
  int width_, height_;
  std::string opaque_, translucent_, overlay_;
};

}  // namespace depixel
