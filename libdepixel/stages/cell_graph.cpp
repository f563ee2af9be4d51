#include "libdepixel/stages/cell_graph.hpp"

#include <algorithm>
#include <bit>

#include "libdepixel/core/simd.hpp"

namespace depixel {
namespace {

/// Number of edges in a mask.
constexpr std::array<std::uint8_t, 16> kEdgeCount{0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};

/// Pixels round a corner in the order in which they lie left of the edges to the north, east, south and west.
using Surroundings = std::array<Rgba, 4>;

/// Pairs the edges of a T-junction: the two sharp contours if the third is a shading contour, else the
/// opposite pair.
CornerCode::Pairing pair_t_junction(int visible, const Surroundings& left) {
  int sharp = 0;
  for (const Direction d : kDirections) {
    if ((visible >> d & 1) != 0 && !near_yuv(left[d], left[turned(d, 1)])) sharp |= 1 << d;
  }
  if (kEdgeCount[sharp] == 2) {
    for (const auto pairing : {CornerCode::kNorthEast, CornerCode::kNorthWest}) {
      const CornerCode candidate(sharp, pairing, false);
      const auto first = static_cast<Direction>(std::countr_zero(static_cast<unsigned>(sharp)));
      if (candidate.is_visible(candidate.partner(first))) return pairing;
    }
  }
  return CornerCode::kOpposite;
}

class CornerEncoder {
 public:
  CornerEncoder(const SimilarityGraph& graph, const Components* components, CellGraph& cells)
      : graph_(graph), components_(components), cells_(cells), left_(graph.lattice.left_offsets()) {}

  /// Corners from .. to - 1, of 0 .. width, of a row of corners; maybe some more.
  void encode_row(int y, int from, int to) {
    const Lattice& lattice = graph_.lattice;
    const int width = lattice.width();
    const bool is_border = y == 0 || y == lattice.height();
    if (from == 0) is_border ? clear(0, y) : encode_border(0, y, kEast);
    const int first = std::max(from, 1), end = std::min(to, width);
    if (is_border) {
      for (int x = first; x < end; ++x) encode_border(x, y, y == 0 ? kSouth : kNorth);
    } else if (components_ != nullptr) {
      encode_merged(lattice.corner(first, y), end - first);
    } else if (first < end) {
      to = std::max(to, encode_exact(lattice.corner(first, y), end - first, width - first));
    }
    if (to >= width) is_border ? clear(width, y) : encode_border(width, y, kWest);
  }

 private:
  static std::uint8_t pairing_bits(int links) {
    constexpr std::uint8_t kMainBits = CornerCode(0, CornerCode::kNorthEast, true).bits();
    constexpr std::uint8_t kAntiBits = CornerCode(0, CornerCode::kNorthWest, true).bits();
    return static_cast<std::uint8_t>(((links & kMainDiagonal) != 0) * kMainBits |
                                     ((links & kAntiDiagonal) != 0) * kAntiBits);
  }

  void clear(int x, int y) { cells_.corners[graph_.lattice.corner(x, y)] = CornerCode{}; }

  /// With exact similarity an edge is visible where the link across it is missing. Sixteen corners at a time,
  /// so some more may be encoded; of what lies beyond the row, the first ones are cleared. \param room
  /// corners from the first one to the row's end. \return the column behind the last corner that was written,
  /// counted from the frame's border.
  int encode_exact(int first, int count, int room) {
    const std::uint8_t* here = graph_.links.data() + first;
    const std::uint8_t* below = here + graph_.lattice.stride();
    CornerCode* out = cells_.corners.data() + first;
    for (int x = 0; x < count; x += static_cast<int>(sizeof(Byte16))) {
      const auto links = load_vector<Byte16>(here + x), east = load_vector<Byte16>(here + x + 1);
      const auto south = load_vector<Byte16>(below + x);
      const Byte16 visible = ~((links & kNorthSide) | (east & kWestSide) | ((south & kNorthSide) << 2) |
                               ((links & kWestSide) << 2)) &
                             15;
      // A main diagonal pairs north and east, an antidiagonal north and west; both cut the corner.
      static_assert(CornerCode(0, CornerCode::kNorthEast, true).bits() == 0x50);
      static_assert(CornerCode(0, CornerCode::kNorthWest, true).bits() == 0x60);
      const Byte16 main = links & kMainDiagonal, anti = links & kAntiDiagonal;
      const Byte16 code = visible | (main << 2) | (main << 4) | (anti << 2) | (anti << 3);
      store_vector(out + x, code & reinterpret_cast<Byte16>(visible != 0));
    }
    constexpr int kAtOnce = sizeof(Byte16);
    const int written = (count + kAtOnce - 1) / kAtOnce * kAtOnce;
    if (written > room) std::fill_n(out + room, written - room, CornerCode{});
    pair_t_junctions(first, std::min(written, room));
    return graph_.lattice.corner_position(first).x + written;
  }

  void encode_merged(int first, int count) {
    for (int i = first; i < first + count; ++i) {
      int visible = 0;
      for (const Direction d : kDirections) visible |= differ(i + left_[d], i + left_[turned(d, 1)]) << d;
      cells_.corners[i] =
          CornerCode(static_cast<std::uint8_t>(visible == 0 ? 0 : visible | pairing_bits(graph_.links[i])));
      pair_edges(i);
    }
  }

  /// With exact similarity, all corners that are not cut have their edges paired but T-junctions: those where
  /// one edge is invisible. Looks at sixteen at a glance.
  void pair_t_junctions(int first, int count) {
    const CornerCode* codes = cells_.corners.data() + first;
    for (int x = 0; x < count;
         x += static_cast<int>(sizeof(Byte16))) {  // what lies beyond the row is no such
      const Byte16 invisible = ~load_vector<Byte16>(codes + x) & 15;
      const auto is_one = (invisible != 0) & ((invisible & (invisible - 1)) == 0);
      for (std::uint32_t bits = gather_bits(reinterpret_cast<Byte16>(is_one), 0); bits != 0;
           bits &= bits - 1) {
        pair_edges(first + x + std::countr_zero(bits));
      }
    }
  }

  void pair_edges(int corner) {
    const CornerCode code = cells_.corners[corner];
    const int visible = code.visible_edges();
    if (visible == 0 || code.is_cut()) return;
    if (kEdgeCount[visible] == 2) {  // a right angle of merged cells: joined as it is, not cut
      cells_.corners[corner] = CornerCode(visible, pair_of_two(visible), false);
    } else if (kEdgeCount[visible] == 3) {
      Surroundings left;
      for (const Direction d : kDirections) left[d] = cells_.colours[corner + left_[d]];
      cells_.corners[corner] = CornerCode(visible, pair_t_junction(visible, left), false);
    }
  }

  static CornerCode::Pairing pair_of_two(int visible) {
    const auto first = static_cast<Direction>(std::countr_zero(static_cast<unsigned>(visible)));
    for (const auto pairing : {CornerCode::kOpposite, CornerCode::kNorthEast, CornerCode::kNorthWest}) {
      const CornerCode candidate(visible, pairing, false);
      if (candidate.is_visible(candidate.partner(first))) return pairing;
    }
    return CornerCode::kOpposite;
  }

  /// Corners on the border: only the edge that leads inwards can be visible, and its contour ends there.
  void encode_border(int x, int y, Direction inwards) {
    const int i = graph_.lattice.corner(x, y);
    const int visible = differ(i + left_[inwards], i + left_[turned(inwards, 1)]) << inwards;
    cells_.corners[i] = CornerCode(visible, CornerCode::kOpposite, false);
  }

  int differ(int p, int q) const {
    if (components_ != nullptr) return components_->label[p] != components_->label[q] ? 1 : 0;
    return graph_.pixels[p] == graph_.pixels[q] ? 0 : 1;
  }

  const SimilarityGraph& graph_;
  const Components* components_;
  CellGraph& cells_;
  std::array<int, 4> left_;
};

}  // namespace

void paint_cells(const SimilarityGraph& graph, const Components* components, CellGraph& cells) {
  if (components == nullptr) {
    cells.colours = graph.pixels;
    return;
  }
  const Lattice& lattice = graph.lattice;
  for (int y = 0; y < lattice.height(); ++y) {
    for (int i = lattice.pixel(0, y), end = i + lattice.width(); i < end; ++i) {
      cells.colours[i] = components->colour[components->label[i]];
    }
  }
}

void encode_corners(const SimilarityGraph& graph, const Components* components, int y, int from, int to,
                    CellGraph& cells) {
  CornerEncoder(graph, components, cells).encode_row(y, from, to);
}

void build_cell_graph(const SimilarityGraph& graph, const Components* components, CellGraph& cells) {
  cells.resize(graph.lattice);
  paint_cells(graph, components, cells);
  CornerEncoder encoder(graph, components, cells);
  const Lattice& lattice = graph.lattice;
  for (int y = 0; y <= lattice.height(); ++y) encoder.encode_row(y, 0, lattice.width() + 1);
}

}  // namespace depixel
