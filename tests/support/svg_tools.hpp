#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/picture.hpp"

namespace depixel::test {

/// A closed polygon; the last point is not repeated.
using Polygon = std::vector<glm::dvec2>;

/// True where a ray from a point crosses polygons an odd number of times: inside by the even-odd rule.
bool is_inside(glm::dvec2 point, const std::vector<Polygon>& polygons);

/// Appends points on a cubic curve to a polygon, its end included, its start not.
void append_curve(glm::dvec2 p0, glm::dvec2 p1, glm::dvec2 p2, glm::dvec2 p3, Polygon& polygon,
                  int pieces = 16);

/// Twenty times the signed area under a cubic curve, as seen from the origin; summed over a closed path,
/// twenty times the area that lies on its left (y runs down). Exact.
std::int64_t area_20(glm::i64vec2 p0, glm::i64vec2 p1, glm::i64vec2 p2, glm::i64vec2 p3);

/// A path element of an SVG document.
struct SvgPath {
  std::string fill;  ///< "#rrggbb", its own or its group's
  bool in_defs = false;
  std::vector<Polygon> polygons;  ///< source pixels, curves flattened
  std::int64_t area_60 = 0;       ///< sixty times its area, in square thousandths of a pixel; exact
};

/// Reads a path of the commands M m h v l c s q t z, and nothing else; a path without polygons if it holds
/// something else.
SvgPath parse_path_data(std::string_view data);

/// All filled paths of a document, but for those of its shading.
std::vector<SvgPath> filled_paths(const pugi::xml_document& document);

/// Draws an SVG document with rsvg-convert, stretched to a size; an empty picture if that fails.
Picture draw_with_rsvg(const std::string& svg, int width, int height);

/// Whether Chromium is installed, under the name that Debian gives it.
bool has_chromium();

/// An SVG document and the size that it is drawn at.
struct SvgToDraw {
  std::string svg;
  int width = 0, height = 0;
};
/// Draws SVG documents with Chromium, without a display, all in one start of it; no pictures if that fails.
std::vector<Picture> draw_with_chromium(const std::vector<SvgToDraw>& documents);

}  // namespace depixel::test
