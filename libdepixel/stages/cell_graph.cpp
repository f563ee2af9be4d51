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

class CellGraphBuilder {
 public:
  CellGraphBuilder(const SimilarityGraph& graph, const Components* components, CellGraph& cells)
      : graph_(graph), components_(components), cells_(cells), left_(graph.lattice.left_offsets()) {}

  void build() {
    paint();
    const Lattice& lattice = graph_.lattice;
    for (int y = 1; y < lattice.height(); ++y) {
      if (components_ == nullptr) {
        encode_exact_row(lattice.corner(1, y), lattice.width() - 1);
      } else {
        encode_row(lattice.corner(1, y), lattice.width() - 1);
      }
      pair_t_junctions(lattice.corner(1, y), lattice.width() - 1);
    }
    encode_border();
  }

 private:
  void paint() {
    const Lattice& lattice = graph_.lattice;
    if (components_ == nullptr) {
      cells_.colours = graph_.pixels;
      return;
    }
    for (int y = 0; y < lattice.height(); ++y) {
      for (int i = lattice.pixel(0, y), end = i + lattice.width(); i < end; ++i) {
        cells_.colours[i] = components_->colour[components_->label[i]];
      }
    }
  }

  static std::uint8_t pairing_bits(int links) {
    constexpr std::uint8_t kMainBits = CornerCode(0, CornerCode::kNorthEast, true).bits();
    constexpr std::uint8_t kAntiBits = CornerCode(0, CornerCode::kNorthWest, true).bits();
    return static_cast<std::uint8_t>(((links & kMainDiagonal) != 0) * kMainBits |
                                     ((links & kAntiDiagonal) != 0) * kAntiBits);
  }

  /// With exact similarity an edge is visible where the link across it is missing. Sixteen corners at a time;
  /// may write into the padding, which is cleared again.
  void encode_exact_row(int first, int count) {
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
    std::fill_n(out + count, sizeof(Byte16) - 1, CornerCode{});
  }

  void encode_row(int first, int count) {
    for (int i = first; i < first + count; ++i) {
      int visible = 0;
      for (const Direction d : kDirections) visible |= differ(i + left_[d], i + left_[turned(d, 1)]) << d;
      cells_.corners[i] =
          CornerCode(static_cast<std::uint8_t>(visible == 0 ? 0 : visible | pairing_bits(graph_.links[i])));
    }
  }

  void pair_t_junctions(int first, int count) {
    for (int i = first; i < first + count; ++i) {
      const CornerCode code = cells_.corners[i];
      const int visible = code.visible_edges();
      if (visible == 0 || code.is_cut()) continue;
      switch (kEdgeCount[visible]) {
        case 2:  // a right angle of merged cells: joined as it is, not cut
          cells_.corners[i] = CornerCode(visible, pair_of_two(visible), false);
          break;
        case 3: {
          Surroundings left;
          for (const Direction d : kDirections) left[d] = cells_.colours[i + left_[d]];
          cells_.corners[i] = CornerCode(visible, pair_t_junction(visible, left), false);
          break;
        }
        default:
          break;
      }
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
  void encode_border() {
    const Lattice& lattice = graph_.lattice;
    const auto encode = [&](int x, int y, Direction inwards) {
      const int i = lattice.corner(x, y);
      const int visible = differ(i + left_[inwards], i + left_[turned(inwards, 1)]) << inwards;
      cells_.corners[i] = CornerCode(visible, CornerCode::kOpposite, false);
    };
    for (int x = 1; x < lattice.width(); ++x) {
      encode(x, 0, kSouth);
      encode(x, lattice.height(), kNorth);
    }
    for (int y = 1; y < lattice.height(); ++y) {
      encode(0, y, kEast);
      encode(lattice.width(), y, kWest);
    }
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

void build_cell_graph(const SimilarityGraph& graph, const Components* components, CellGraph& cells) {
  if (!(cells.lattice == graph.lattice) || cells.corners.empty()) {
    cells.lattice = graph.lattice;
    cells.corners.assign(graph.lattice.size(), CornerCode{});
    cells.colours.assign(graph.lattice.size(), Rgba{});
  }
  CellGraphBuilder(graph, components, cells).build();
}

}  // namespace depixel
