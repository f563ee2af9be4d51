#include "libdepixel/stages/accurate_cells.hpp"

#include <optional>

namespace depixel {
namespace {

constexpr int kQuarter = kSubpixels / 4, kEighth = kSubpixels / 8, kSixteenth = kSubpixels / 16;

/// Where the nodes of cells lie, in subpixels.
class CellNodes {
 public:
  CellNodes(const SimilarityGraph& graph, CellShape shape)
      : graph_(graph), accurate_(shape == CellShape::accurate), step_(graph.lattice.step_offsets()) {}

  /// The node at a lattice corner that the edge in a direction leaves from.
  glm::ivec2 corner_node(int corner, Direction d) const {
    const glm::ivec2 at = graph_.lattice.corner_position(corner) * kSubpixels;
    const int diagonals = graph_.links[corner] & kBothDiagonals;
    if (diagonals != 0) {
      const auto pairing = diagonals == kMainDiagonal ? CornerCode::kNorthEast : CornerCode::kNorthWest;
      return at + CornerCode(0, pairing, true).node_quarters(d) * kQuarter;
    }
    return accurate_ && !on_border(corner) ? at + junction_offset(corner) : at;
  }

  /// Where the boundary bends in the middle of the lattice edge that leaves a corner; nothing if it is
  /// straight.
  std::optional<glm::ivec2> bend(int corner, Direction d) const {
    if (!accurate_) return std::nullopt;
    const bool forwards = d == kEast || d == kSouth;
    const glm::ivec2 at = forwards ? edge_middle(corner, d) : edge_middle(corner + step_[d], opposite(d));
    if (2 * at == corner_node(corner, d) + corner_node(corner + step_[d], opposite(d))) return std::nullopt;
    return at;
  }

 private:
  bool on_border(int corner) const {
    const glm::ivec2 at = graph_.lattice.corner_position(corner);
    return at.x == 0 || at.y == 0 || at.x == graph_.lattice.width() || at.y == graph_.lattice.height();
  }

  /// True where a link crosses the lattice edge that leaves a corner in a direction.
  bool is_linked(int corner, Direction d) const {
    switch (d) {
      case kNorth:
        return graph_.links[corner] & kNorthSide;
      case kEast:
        return graph_.links[corner + 1] & kWestSide;
      case kSouth:
        return graph_.links[corner + step_[kSouth]] & kNorthSide;
      default:
        return graph_.links[corner] & kWestSide;
    }
  }

  /// Where the boundary crosses the middle of the lattice edge that leaves a corner to the east or south. A
  /// pixel's diagonal half-link pushes it by (3 - 2 sqrt 2) / 2 = 0.086 pixels, unless one of the other
  /// pixel's pushes back.
  glm::ivec2 edge_middle(int corner, Direction d) const {
    const int to = corner + step_[d];
    const glm::ivec2 middle =
        (graph_.lattice.corner_position(corner) + graph_.lattice.corner_position(to)) * (kSubpixels / 2);
    if (is_linked(corner, d)) return middle;
    const int of_left = d == kEast ? kAntiDiagonal : kMainDiagonal, of_right = kBothDiagonals - of_left;
    const auto reaches = [&](int near, int far) {
      return (graph_.links[corner] & near) != 0 || (graph_.links[to] & far) != 0 ? 1 : 0;
    };
    const int push = reaches(of_left, of_right) - reaches(of_right, of_left);
    return middle + kStep[turned(d, 1)] * (push * kSixteenth);
  }

  /// The point where the four cells of a block without diagonal links meet: half-links along one side push it
  /// away by 1/8 pixel, along two neighbouring sides by 0.06 (there two junctions lie 0.12 pixels apart).
  glm::ivec2 junction_offset(int corner) const {
    glm::ivec2 away(0, 0);
    int linked = 0;
    for (const Direction d : kDirections) {
      if (!is_linked(corner, d)) continue;
      away -= kStep[d];
      ++linked;
    }
    return linked == 1 ? away * kEighth : linked == 2 ? away * kSixteenth : glm::ivec2(0, 0);
  }

  const SimilarityGraph& graph_;
  bool accurate_;
  std::array<int, 4> step_;
};

class CellMapBuilder {
 public:
  CellMapBuilder(const SimilarityGraph& graph, CellShape shape, PlanarMap& map)
      : graph_(graph),
        nodes_(graph, shape),
        map_(map),
        step_(graph.lattice.step_offsets()),
        left_(graph.lattice.left_offsets()) {}

  void build() {
    const Lattice& lattice = graph_.lattice;
    map_.lattice = lattice;
    map_.colours = graph_.pixels;
    map_.segments.clear();
    for (int y = 0; y <= lattice.height(); ++y) {
      for (int x = 0; x <= lattice.width(); ++x) {
        const int corner = lattice.corner(x, y);
        if (x < lattice.width() && y > 0 && y < lattice.height()) add_edge(corner, kEast);
        if (y < lattice.height() && x > 0 && x < lattice.width()) add_edge(corner, kSouth);
        if (graph_.links[corner] & kBothDiagonals) add_split(corner);
      }
    }
  }

 private:
  void add_line(glm::ivec2 from, glm::ivec2 to, int left, int right) {
    map_.segments.push_back({from, from + (to - from) / 3, to - (to - from) / 3, to, left, right});
  }

  void add_edge(int corner, Direction d) {
    const int left = corner + left_[d], right = corner + left_[turned(d, 1)];
    const glm::ivec2 from = nodes_.corner_node(corner, d);
    const glm::ivec2 to = nodes_.corner_node(corner + step_[d], opposite(d));
    const std::optional<glm::ivec2> bend = nodes_.bend(corner, d);
    if (bend) add_line(from, *bend, left, right);
    add_line(bend.value_or(from), to, left, right);
  }

  /// The short edge that two diagonally linked cells share, from the west node to the east node of a cut
  /// corner.
  void add_split(int corner) {
    const bool is_main = (graph_.links[corner] & kMainDiagonal) != 0;
    const Direction left =
        is_main ? kNorth : kEast;  // the pixels on the left of these edges are the linked ones
    add_line(nodes_.corner_node(corner, kWest), nodes_.corner_node(corner, kEast), corner + left_[left],
             corner + left_[opposite(left)]);
  }

  const SimilarityGraph& graph_;
  CellNodes nodes_;
  PlanarMap& map_;
  std::array<int, 4> step_, left_;
};

}  // namespace

void find_cell_polygon(const SimilarityGraph& graph, CellShape shape, int pixel,
                       std::vector<glm::ivec2>& polygon) {
  const CellNodes nodes(graph, shape);
  const std::array<int, 4> step = graph.lattice.step_offsets();
  polygon.clear();
  int corner = pixel - graph.lattice.stride() - 1;  // the pixel's north-west
  for (const Direction heading : {kEast, kSouth, kWest, kNorth}) {
    const int next = corner + step[heading];
    polygon.push_back(nodes.corner_node(corner, heading));
    if (const auto bend = nodes.bend(corner, heading)) polygon.push_back(*bend);
    const glm::ivec2 arrival = nodes.corner_node(next, opposite(heading));
    const glm::ivec2 leaving = nodes.corner_node(next, turned(heading, 1));
    if (arrival != leaving) polygon.push_back(arrival);
    corner = next;
  }
}

void build_cell_map(const SimilarityGraph& graph, CellShape shape, PlanarMap& map) {
  CellMapBuilder(graph, shape, map).build();
}

}  // namespace depixel
