#pragma once

#include <cstdint>
#include <deque>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "libdepixel/core/color.hpp"
#include "libdepixel/core/lattice.hpp"
#include "libdepixel/svg/svg_grid.hpp"

namespace depixel {

/// The `d` attribute of an SVG path, in relative coordinates, as short as it can be said without loss: lines
/// that go on in the same direction are one, curves that are smooth or quadratic are written as such, and
/// what need not be said is left out.
///
/// Points are rounded before differences are taken, so paths that share a point on the map share it in the
/// file too.
class SvgPathData {
 public:
  explicit SvgPathData(std::string& out, SvgGrid grid = {}) : out_(out), grid_(grid) {}

  void move_to(glm::ivec2 to_subpixels);
  void line_to(glm::ivec2 to_subpixels);
  /// A cubic curve; written as a line where its control points lie on its chord's thirds, and as a quadratic
  /// curve where they lie on two thirds of the ways to one point, as exactly as rounding to subpixels allows.
  void curve_to(glm::ivec2 p1_subpixels, glm::ivec2 p2_subpixels, glm::ivec2 to_subpixels);
  /// Draws a line back to where the path started; one that was drawn already is taken back.
  void close();
  /// Ends a path that stays open.
  void end() { write_line(); }
  /// Where it is, in thousandths.
  glm::ivec2 at() const { return at_; }

 private:
  void write_line();
  void write_cubic(glm::ivec2 p1, glm::ivec2 p2);
  void write_quadratic(glm::ivec2 control);
  void command(char letter);
  void number(int thousandths);
  void vector(glm::ivec2 by);

  std::string& out_;
  SvgGrid grid_;
  glm::ivec2 exact_{0, 0};  ///< the current point, in subpixels
  // As written, in thousandths:
  glm::ivec2 start_{0, 0}, at_{0, 0};  ///< of the closed path, and the current point
  glm::ivec2 line_{0, 0};              ///< the line that leads to the current point, not written yet
  glm::ivec2 cubic_next_{0, 0};        ///< where a smooth cubic curve has its first control point
  glm::ivec2 quadratic_next_{0, 0};    ///< where a smooth quadratic curve has its control point
  char last_ = 0;                      ///< a command's letter is written only where it changes
  bool after_number_ = false;          ///< the text ends in a number,
  bool after_fraction_ = false;        ///< and that has a decimal point
};

/// A length in pixels as a whole number of thousandths.
int svg_thousandths(double pixels);
/// Appends a whole or decimal number given in thousandths: 1500 is "1.5", -250 is "-.25".
void append_svg_number(std::string& out, int thousandths);
/// How many characters a number takes, a sign or a separator included.
int svg_length(int thousandths);
inline int svg_length(glm::ivec2 thousandths) {
  return svg_length(thousandths.x) + svg_length(thousandths.y);
}
/// Whether a cubic curve is a line at even speed, as near as rounding to subpixels allows.
bool is_svg_line(glm::ivec2 p0, glm::ivec2 p1, glm::ivec2 p2, glm::ivec2 p3);
/// The control point of the quadratic curve that a cubic one is, as near as rounding to subpixels allows.
std::optional<glm::ivec2> svg_quadratic_control(glm::ivec2 p0, glm::ivec2 p1, glm::ivec2 p2, glm::ivec2 p3);
/// Appends the attributes that paint with a colour: ` fill="#rrggbb"`, and ` fill-opacity` where it is not
/// opaque. \param what  "fill" or "stroke".
void append_svg_paint(std::string& out, std::string_view what, Rgba colour);

/// Gathers shapes that partition a picture, and drawings on top of it, to an SVG document in source pixels.
/// Shapes of one colour are one path, by the nonzero rule.
///
/// Renderers let the background through where shapes meet. So opaque shapes are defined once and drawn twice:
/// without anti-aliasing, which leaves no gaps, and with it, on top. Where there is anything else than opaque
/// shapes, a mask keeps the first drawing off the silhouette's pixels, which the second one alone then gives
/// their coverage. Translucent shapes are drawn once.
class SvgDocument {
 public:
  /// Of what a lattice shows; its margin lies outside of the document.
  explicit SvgDocument(const Lattice& lattice, SvgGrid grid = {})
      : width_(lattice.shown_width()),
        height_(lattice.shown_height()),
        margin_(lattice.margin()),
        grid_(grid) {}

  /// The path to which shapes of a colour are added; valid as long as the document. All shapes turn the same
  /// way round, holes the other way.
  SvgPathData& path(Rgba colour);
  /// Elements on top of all shapes.
  std::string& overlay() { return overlay_; }

  std::string finish() const;

 private:
  struct Shapes {
    Rgba colour;
    std::string data;
    SvgPathData path;

    Shapes(Rgba painted, SvgGrid grid) : colour(painted), path(data, grid) {}
    Shapes(const Shapes&) = delete;
    Shapes& operator=(const Shapes&) = delete;
  };

  int width_, height_, margin_;
  SvgGrid grid_;
  std::deque<Shapes> shapes_;  ///< in the order in which colours first come
  std::unordered_map<std::uint32_t, Shapes*> of_colour_;
  std::string overlay_;
};

}  // namespace depixel
