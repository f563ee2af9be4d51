#include "libdepixel/svg/svg_writer.hpp"
#include "libdepixel/views/stage_view.hpp"

namespace depixel {
namespace {

void append_cells(const StageDrawing& drawing, SvgDocument& document) {
  const Lattice& lattice = drawing.fill.lattice;
  std::vector<glm::ivec2> polygon;
  for (int y = 0; y < lattice.height(); ++y) {
    for (int x = 0; x < lattice.width(); ++x) {
      const int pixel = lattice.pixel(x, y);
      find_cell_polygon(drawing.graph, *drawing.cells, pixel, polygon);
      SvgPathData& path = document.path(drawing.fill.colours[pixel]);
      path.move_to(polygon.front());
      for (std::size_t i = 1; i < polygon.size(); ++i) path.line_to(polygon[i]);
      path.close();
    }
  }
}

void append_attribute(std::string& out, std::string_view name, double value) {
  out.append(" ").append(name).append("=\"");
  append_svg_number(out, svg_thousandths(value));
  out += '"';
}

/// Strokes of one colour and width that follow one another are one path; those that join, one line of it.
void append_strokes(const std::vector<Stroke>& strokes, std::string& out) {
  for (std::size_t i = 0; i < strokes.size();) {
    const Stroke& first = strokes[i];
    out.append("<path fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\"");
    append_svg_paint(out, "stroke", first.colour);
    append_attribute(out, "stroke-width", first.width_px);
    out.append(" d=\"");
    SvgPathData path(out);
    for (bool joined = false; i < strokes.size(); ++i) {
      const Stroke& s = strokes[i];
      if (s.colour != first.colour || s.width_px != first.width_px) break;
      if (!joined || strokes[i - 1].p3 != s.p0) path.move_to(s.p0);
      path.curve_to(s.p1, s.p2, s.p3);
      joined = true;
    }
    path.end();
    out.append("\"/>\n");
  }
}

void append_circle(const Circle& circle, std::string& out) {
  out.append("<circle");
  append_attribute(out, "cx", double(circle.centre.x) / kSubpixels);
  append_attribute(out, "cy", double(circle.centre.y) / kSubpixels);
  append_attribute(out, "r", circle.radius_px);
  if (circle.ring_px > 0) {
    out.append(" fill=\"none\"");
    append_svg_paint(out, "stroke", circle.colour);
    append_attribute(out, "stroke-width", circle.ring_px);
  } else {
    append_svg_paint(out, "fill", circle.colour);
  }
  out.append("/>\n");
}

}  // namespace

std::string write_stage_svg(const StageDrawing& drawing) {
  const Lattice& lattice = drawing.fill.lattice;
  SvgDocument document(lattice);
  if (drawing.cells) {
    append_cells(drawing, document);
  } else {
    append_components(drawing.fill, drawing.graph, 0, document);
  }
  append_strokes(drawing.strokes, document.overlay());
  for (const Circle& circle : drawing.circles) append_circle(circle, document.overlay());
  return document.finish();
}

}  // namespace depixel
