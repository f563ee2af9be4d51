#include "libdepixel/stages/outlines.hpp"

namespace depixel {
namespace {

class OutlineTracer {
 public:
  OutlineTracer(const PlanarMap& map, const SimilarityGraph& graph, const Components& components,
                Outlines& outlines)
      : map_(map),
        graph_(graph),
        components_(components),
        outlines_(outlines),
        step_(map.lattice.step_offsets()),
        left_(map.lattice.left_offsets()) {}

  void trace_all() {
    const Lattice& lattice = map_.lattice;
    outlines_.pieces.clear();
    outlines_.unsorted.clear();
    outlines_.traced.assign(lattice.size(), 0);
    outlines_.edge_segment.assign(2 * lattice.size(), kInvisible);
    enter_segments();
    enter_border();
    for (int y = 0; y <= lattice.height(); ++y) {
      for (int corner = lattice.corner(0, y), end = corner + lattice.width(); corner <= end; ++corner) {
        for (const Direction heading : kDirections) {
          if (starts_loop(corner, heading)) trace_loop(corner, heading);
        }
      }
    }
    sort_loops();
  }

 private:
  static constexpr int kInvisible = -2;

  /// Every lattice edge belongs to its western or northern corner, which has one to the east and one to the
  /// south.
  int& edge(int corner, Direction heading) {
    const int owner = heading == kWest || heading == kNorth ? corner + step_[heading] : corner;
    return outlines_.edge_segment[2 * owner + (heading == kNorth || heading == kSouth ? 1 : 0)];
  }

  /// A segment runs along the lattice edge between the pixels on its two sides.
  void enter_segments() {
    for (int i = 0; i < static_cast<int>(map_.segments.size()); ++i) {
      const Segment& s = map_.segments[i];
      for (const Direction d : kDirections) {
        if (s.right - s.left == left_[turned(d, 1)] - left_[d]) edge(s.left - left_[d], d) = i;
      }
    }
  }

  void enter_border() {
    const Lattice& lattice = map_.lattice;
    for (int x = 0; x < lattice.width(); ++x) {
      for (const int y : {0, lattice.height()}) edge(lattice.corner(x, y), kEast) = OutlinePiece::kBorder;
    }
    for (int y = 0; y < lattice.height(); ++y) {
      for (const int x : {0, lattice.width()}) edge(lattice.corner(x, y), kSouth) = OutlinePiece::kBorder;
    }
  }

  int left_component(int corner, Direction heading) const {
    return components_.label[corner + left_[heading]];
  }

  bool starts_loop(int corner, Direction heading) {
    return edge(corner, heading) != kInvisible && (outlines_.traced[corner] >> heading & 1) == 0 &&
           left_component(corner, heading) >= 0;
  }

  void trace_loop(const int start, const Direction start_heading) {
    const int first = static_cast<int>(outlines_.pieces.size());
    int corner = start;
    Direction heading = start_heading;
    Direction last_heading = heading;
    do {
      outlines_.traced[corner] |= static_cast<std::uint8_t>(1 << heading);
      const bool continues = static_cast<int>(outlines_.pieces.size()) > first && heading == last_heading;
      append(corner, heading, continues);
      last_heading = heading;
      corner += step_[heading];
      heading = onwards(corner, heading);
    } while (corner != start || heading != start_heading);
    const int count = static_cast<int>(outlines_.pieces.size()) - first;
    outlines_.unsorted.push_back({left_component(start, start_heading), first, count});
  }

  /// Where the outline that arrives with a heading leaves: at a cut corner along the diagonal link, else
  /// along the next visible edge on the left, which bounds the pixels on the left.
  Direction onwards(int corner, Direction heading) {
    const Direction arrival = opposite(heading);
    const int diagonals = graph_.links[corner] & kBothDiagonals;
    if (diagonals != 0) {
      const auto pairing = diagonals == kMainDiagonal ? CornerCode::kNorthEast : CornerCode::kNorthWest;
      return CornerCode(0, pairing, true).partner(arrival);
    }
    Direction next = turned(arrival, 1);
    while (edge(corner, next) == kInvisible) next = turned(next, 1);
    return next;
  }

  /// \param continues  the piece before it has the same heading, so that lines along the border can be
  /// joined.
  void append(int corner, Direction heading, bool continues) {
    const int segment = edge(corner, heading);
    if (segment == OutlinePiece::kBorder) {
      const glm::ivec2 to = map_.lattice.corner_position(corner + step_[heading]) * kSubpixels;
      if (continues && outlines_.pieces.back().segment == segment) outlines_.pieces.pop_back();
      outlines_.pieces.push_back({to, to, to, segment});
      return;
    }
    const Segment& s = map_.segments[segment];
    if (s.left == corner + left_[heading]) {
      outlines_.pieces.push_back({s.p1, s.p2, s.p3, segment});
    } else {
      outlines_.pieces.push_back({s.p2, s.p1, s.p0, segment});
    }
  }

  /// Counting sort by component; stable, so loops stay in raster order.
  void sort_loops() {
    std::vector<int>& first = outlines_.first_loop;
    first.assign(components_.count + 1, 0);
    for (const OutlineLoop& loop : outlines_.unsorted) ++first[loop.component];
    for (int c = 1; c <= components_.count; ++c) first[c] += first[c - 1];
    outlines_.loops.resize(outlines_.unsorted.size());
    for (std::size_t i = outlines_.unsorted.size(); i-- > 0;) {
      const OutlineLoop& loop = outlines_.unsorted[i];
      outlines_.loops[--first[loop.component]] = loop;
    }
  }

  const PlanarMap& map_;
  const SimilarityGraph& graph_;
  const Components& components_;
  Outlines& outlines_;
  std::array<int, 4> step_, left_;
};

}  // namespace

void trace_outlines(const PlanarMap& map, const SimilarityGraph& graph, const Components& components,
                    Outlines& outlines) {
  OutlineTracer(map, graph, components, outlines).trace_all();
}

}  // namespace depixel
