#include "libdepixel/svg/svg_writer.hpp"

#include "libdepixel/svg/svg_shading.hpp"

namespace depixel {
namespace {

void append_loop(const Outlines& outlines, const OutlineLoop& loop, SvgPathData& path) {
  const OutlinePiece* pieces = outlines.pieces.data() + loop.first;
  path.move_to(pieces[loop.count - 1].p3);
  for (int i = 0; i < loop.count; ++i) {
    const OutlinePiece& piece = pieces[i];
    if (piece.segment != OutlinePiece::kBorder) {
      path.curve_to(piece.p1, piece.p2, piece.p3);
    } else if (i + 1 < loop.count) {  // closing the path draws the last line
      path.line_to(piece.p3);
    }
  }
  path.close();
}

}  // namespace

void append_components(const PlanarMap& map, const SimilarityGraph& graph, SvgDocument& document) {
  Components components;
  label_components(graph, components);
  Outlines outlines;
  trace_outlines(map, graph, components, outlines);
  std::vector<Rgba> colour(components.count);
  const Lattice& lattice = map.lattice;
  for (int y = 0; y < lattice.height(); ++y) {
    for (int i = lattice.pixel(0, y), end = i + lattice.width(); i < end; ++i) {
      colour[components.label[i]] = map.colours[i];
    }
  }
  std::vector<std::string> data(components.count);
  for (int c = 0; c < components.count; ++c) {
    SvgPathData path(data[c]);
    for (int i = outlines.first_loop[c]; i < outlines.first_loop[c + 1]; ++i) {
      append_loop(outlines, outlines.loops[i], path);
    }
    document.add_shape(colour[c], data[c]);
  }
  append_svg_shading(map, components, data, document.overlay());
}

std::string write_svg(const PlanarMap& map, const SimilarityGraph& graph) {
  SvgDocument document(map.lattice.width(), map.lattice.height());
  append_components(map, graph, document);
  return document.finish();
}

}  // namespace depixel
