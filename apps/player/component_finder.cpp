#include "apps/player/component_finder.hpp"

#include <algorithm>
#include <cmath>

#include "libdepixel/core/tolerances.hpp"

namespace depixel {
namespace {

/// Lines that a curve is tested as; a pointer is no finer.
constexpr int kLines = 8;

/// Whether a ray from the point to the right crosses the line: upwards or downwards, one end included.
bool crosses(glm::dvec2 point, glm::dvec2 a, glm::dvec2 b) {
  if ((a.y > point.y) == (b.y > point.y)) return false;
  return point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y);
}

glm::dvec2 on_curve(glm::dvec2 p0, const OutlinePiece& piece, double t) {
  const double s = 1 - t;
  return s * s * s * p0 + 3 * s * s * t * glm::dvec2(piece.p1) + 3 * s * t * t * glm::dvec2(piece.p2) +
         t * t * t * glm::dvec2(piece.p3);
}

}  // namespace

void ComponentFinder::take(const PlanarMap& map, const SimilarityGraph& graph, std::uint64_t version) {
  if (version_ == version) return;
  version_ = version;
  lattice_ = map.lattice;
  colours_ = map.colours;
  label_components(graph, components_);
  trace_outlines(map, graph, components_, outlines_);
  for (OutlinePiece& piece : outlines_.pieces) {
    for (glm::ivec2* point : {&piece.p1, &piece.p2, &piece.p3}) *point -= lattice_.margin() * kSubpixels;
  }
  sizes_px_.assign(components_.size.size(), 0);
  for (int y = 0; y < lattice_.shown_height(); ++y) {
    for (int x = 0; x < lattice_.shown_width(); ++x) ++sizes_px_[components_.label[shown_pixel(x, y)]];
  }
}

int ComponentFinder::shown_pixel(int x, int y) const {
  return lattice_.pixel(x + lattice_.margin(), y + lattice_.margin());
}

std::optional<FoundComponent> ComponentFinder::at(glm::dvec2 point) const {
  const glm::ivec2 pixel(static_cast<int>(std::floor(point.x)), static_cast<int>(std::floor(point.y)));
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= lattice_.shown_width() || pixel.y >= lattice_.shown_height()) {
    return std::nullopt;
  }
  // Curves stray from their pixels by less than one, so that the shape belongs to this pixel or a neighbour.
  int found = shown_pixel(pixel.x, pixel.y);
  for (int y = std::max(0, pixel.y - 1); y <= std::min(lattice_.shown_height() - 1, pixel.y + 1); ++y) {
    for (int x = std::max(0, pixel.x - 1); x <= std::min(lattice_.shown_width() - 1, pixel.x + 1); ++x) {
      if (holds(components_.label[shown_pixel(x, y)], point * double(kSubpixels))) {
        found = shown_pixel(x, y);
      }
    }
  }
  const int component = components_.label[found];
  return FoundComponent{component, colours_[found], sizes_px_[component]};
}

bool ComponentFinder::holds(int component, glm::dvec2 point) const {
  bool inside = false;
  for (const OutlineLoop& loop : loops(component)) {
    const auto all = pieces(loop);
    glm::dvec2 start = all.back().p3;
    for (const OutlinePiece& piece : all) {
      glm::dvec2 from = start;
      for (int i = 1; i <= kLines; ++i) {
        const glm::dvec2 to = on_curve(start, piece, double(i) / kLines);
        inside ^= crosses(point, from, to);
        from = to;
      }
      start = piece.p3;
    }
  }
  return inside;
}

std::span<const OutlineLoop> ComponentFinder::loops(int component) const {
  const int first = outlines_.first_loop[component];
  return std::span(outlines_.loops).subspan(first, outlines_.first_loop[component + 1] - first);
}

std::span<const OutlinePiece> ComponentFinder::pieces(const OutlineLoop& loop) const {
  return std::span(outlines_.pieces).subspan(loop.first, loop.count);
}

}  // namespace depixel
