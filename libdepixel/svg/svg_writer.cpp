#include "libdepixel/svg/svg_writer.hpp"

#include <limits>

#include "libdepixel/svg/simplify.hpp"
#include "libdepixel/svg/svg_shading.hpp"

namespace depixel {
namespace {

/// A loop's path, which may start in any of its points.
class LoopPath {
 public:
  LoopPath(const Outlines& outlines, const OutlineLoop& loop, SvgGrid grid)
      : pieces_(outlines.pieces.data() + loop.first), count_(loop.count), grid_(grid) {}

  void append_to(SvgPathData& path) const {
    const int start = shortest_start(path.at());
    path.move_to(start_of(start));
    for (int i = 0; i < count_; ++i) {
      const OutlinePiece& piece = pieces_[(start + i) % count_];
      if (piece.segment == OutlinePiece::kBorder) {
        path.line_to(piece.p3);
      } else {
        path.curve_to(piece.p1, piece.p2, piece.p3);
      }
    }
    path.close();
  }

 private:
  glm::ivec2 start_of(int piece) const { return pieces_[(piece + count_ - 1) % count_].p3; }

  /// Where it is short to start: at a point that is, and after a line, which closing the path draws.
  int shortest_start(glm::ivec2 at) const {
    int best = 0, least = std::numeric_limits<int>::max();
    for (int i = 0; i < count_; ++i) {
      const int cost = svg_length(grid_.thousandths(start_of(i)) - at) - length_of_line_before(i);
      if (cost < least) {
        best = i;
        least = cost;
      }
    }
    return best;
  }

  int length_of_line_before(int piece) const {
    const int before = (piece + count_ - 1) % count_;
    const glm::ivec2 from = start_of(before), to = pieces_[before].p3;
    const OutlinePiece& p = pieces_[before];
    if (p.segment != OutlinePiece::kBorder && !is_svg_line(from, p.p1, p.p2, to)) return 0;
    const glm::ivec2 by = grid_.thousandths(to) - grid_.thousandths(from);
    return by.x == 0 ? svg_length(by.y) : by.y == 0 ? svg_length(by.x) : svg_length(by);
  }

  const OutlinePiece* pieces_;
  int count_;
  SvgGrid grid_;
};

}  // namespace

void append_components(const PlanarMap& map, const SimilarityGraph& graph, double tolerance_px,
                       SvgDocument& document) {
  Components components;
  label_components(graph, components);
  Outlines outlines;
  trace_outlines(map, graph, components, outlines);
  const SvgGrid grid = SvgGrid::within(tolerance_px);
  if (tolerance_px > 0) simplify_outlines(map, tolerance_px, grid, outlines);
  std::vector<Rgba> colour(components.count);
  const Lattice& lattice = map.lattice;
  for (int y = 0; y < lattice.height(); ++y) {
    for (int i = lattice.pixel(0, y), end = i + lattice.width(); i < end; ++i) {
      colour[components.label[i]] = map.colours[i];
    }
  }
  const auto append = [&](int component, SvgPathData& path) {
    for (int i = outlines.first_loop[component]; i < outlines.first_loop[component + 1]; ++i) {
      LoopPath(outlines, outlines.loops[i], grid).append_to(path);
    }
  };
  for (int c = 0; c < components.count; ++c) append(c, document.path(colour[c]));
  append_svg_shading(map, components, {grid, append}, document.overlay());
}

std::string write_svg(const PlanarMap& map, const SimilarityGraph& graph, double tolerance_px) {
  SvgDocument document(map.lattice, SvgGrid::within(tolerance_px));
  append_components(map, graph, tolerance_px, document);
  return document.finish();
}

}  // namespace depixel
