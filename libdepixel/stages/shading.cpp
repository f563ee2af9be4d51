#include "libdepixel/stages/shading.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace depixel {
namespace {

constexpr std::span kSidePairs = std::span(kPixelPairs).first<4>();
constexpr const PixelPair &kMain = kPixelPairs[4], &kAnti = kPixelPairs[5];
static_assert(kNorthPair == 1 << kNorth && kEastPair == 1 << kEast && kSouthPair == 1 << kSouth &&
              kWestPair == 1 << kWest);  // a pair of sides is the edge between them

/// Two ways round a block from one end of a diagonal to the other, through a pixel each.
constexpr std::array<std::array<PairMask, 2>, 2> kMainWays{
    {{kNorthPair, kEastPair}, {kWestPair, kSouthPair}}};
constexpr std::array<std::array<PairMask, 2>, 2> kAntiWays{
    {{kNorthPair, kWestPair}, {kEastPair, kSouthPair}}};

constexpr auto kBlending = [] {
  std::array<std::array<std::uint8_t, 16>, 64> blending{};
  for (int pairs = 0; pairs < 64; ++pairs) {
    for (int pixels = 0; pixels < 16; ++pixels) {
      int all = pixels;
      for (const PixelPair& pair : kPixelPairs) {
        if ((pairs & pair.bit) == 0) continue;
        if ((pixels >> pair.a & 1) != 0) all |= 1 << pair.b;
        if ((pixels >> pair.b & 1) != 0) all |= 1 << pair.a;
      }
      blending[pairs][pixels] = static_cast<std::uint8_t>(all);
    }
  }
  return blending;
}();

class ShadingBuilder {
 public:
  ShadingBuilder(const SimilarityGraph& graph, const CellGraph& cells, const Options& options,
                 Shading& shading)
      : graph_(graph),
        cells_(cells),
        softness_(std::llround(options.soft_contours * kYuvUnits)),
        kind_(options.shading),
        is_merged_(options.has_whole_components()),
        is_blurred_(options.shading == ShadingKind::blur),
        has_own_shades_(options.shading != ShadingKind::none),
        shading_(shading),
        offset_(block_pixels(graph.lattice.stride())) {}

  void build() {
    const Lattice& lattice = graph_.lattice;
    shading_.kind = kind_;
    shading_.shades = has_own_shades_ ? graph_.pixels : cells_.colours;
    shading_.blocks.assign(lattice.size(), 0);
    for_each_block([&](int x, int y, std::uint8_t& block) {
      block = find_pairs(lattice.corner(x, y), is_inside(x, lattice.width()), is_inside(y, lattice.height()));
    });
    if (is_blurred_) blur();
    shading_.any = false;
    for_each_block([&](int x, int y, std::uint8_t& block) {
      block = is_shaded(lattice.corner(x, y), block) ? block | Shading::kShaded : 0;
      shading_.any |= block != 0;
    });
  }

 private:
  static constexpr int kYuvUnits = 1000;

  static bool is_inside(int corner, int size) { return corner > 0 && corner < size; }

  template <typename Visit>
  void for_each_block(Visit visit) {
    const Lattice& lattice = graph_.lattice;
    for (int y = 0; y <= lattice.height(); ++y) {
      std::uint8_t* blocks = shading_.blocks.data() + lattice.corner(0, y);
      for (int x = 0; x <= lattice.width(); ++x) visit(x, y, blocks[x]);
    }
  }

  PairMask find_pairs(int block, bool has_columns, bool has_rows) const {
    int pairs = 0;
    const int visible = cells_.corners[block].visible_edges();
    for (const PixelPair& side : kSidePairs) {
      const bool is_level = side.bit == kNorthPair || side.bit == kSouthPair;
      if (!(is_level ? has_columns : has_rows)) continue;  // one of them lies beyond the border
      if ((visible & side.bit) == 0 || is_soft(block, side)) pairs |= side.bit;
    }
    if (has_columns && has_rows) {
      const int links = graph_.links[block];
      if ((links & kMainDiagonal) != 0 || goes_round(pairs, kMainWays, block, kMain)) pairs |= kMainPair;
      if ((links & kAntiDiagonal) != 0 || goes_round(pairs, kAntiWays, block, kAnti)) pairs |= kAntiPair;
    }
    return static_cast<PairMask>(pairs);
  }

  /// Binomial weights, 1 2 1 both ways, of a pixel and those that it is paired with.
  void blur() {
    const Lattice& lattice = graph_.lattice;
    for (int y = 0; y < lattice.height(); ++y) {
      for (int i = lattice.pixel(0, y), end = i + lattice.width(); i < end; ++i)
        shading_.shades[i] = blurred(i);
    }
  }

  Rgba blurred(int pixel) const {
    constexpr int kOwn = 4, kBeside = 2, kAcross = 1;
    std::array<int, 4> sum{};
    int weights = 0;
    const auto add = [&](int other, int weight) {
      const Rgba c = graph_.pixels[other];
      const std::array<int, 4> levels{c.r, c.g, c.b, c.a};
      for (int k = 0; k < 4; ++k) sum[k] += weight * levels[k];
      weights += weight;
    };
    add(pixel, kOwn);
    // Each neighbour, in a block that it shares with the pixel.
    struct Neighbour {
      int block, offset;
      PairMask bit;
      int weight;
    };
    const int stride = graph_.lattice.stride();
    const std::array<Neighbour, 8> around{{{-stride - 1, -stride, kEastPair, kBeside},
                                           {-stride, 1, kSouthPair, kBeside},
                                           {0, stride, kWestPair, kBeside},
                                           {-1, -1, kNorthPair, kBeside},
                                           {-stride - 1, -stride - 1, kMainPair, kAcross},
                                           {-stride, -stride + 1, kAntiPair, kAcross},
                                           {0, stride + 1, kMainPair, kAcross},
                                           {-1, stride - 1, kAntiPair, kAcross}}};
    for (const Neighbour& other : around) {
      if ((shading_.blocks[pixel + other.block] & other.bit) != 0) add(pixel + other.offset, other.weight);
    }
    const auto level = [&](int k) { return static_cast<std::uint8_t>((sum[k] + weights / 2) / weights); };
    return {level(0), level(1), level(2), level(3)};
  }

  Rgba shade(int block, BlockPixel pixel) const { return shading_.shades[block + offset_[pixel]]; }

  bool is_soft(int block, const PixelPair& pair) const {
    return softness_ > 0 && is_within_yuv(shade(block, pair.a), shade(block, pair.b), softness_);
  }

  /// Whether the ends of a diagonal hang together round it: inside their component, or by soft contours if
  /// they are alike themselves.
  bool goes_round(int pairs, const std::array<std::array<PairMask, 2>, 2>& ways, int block,
                  const PixelPair& pair) const {
    const int visible = cells_.corners[block].visible_edges();
    for (const auto& way : ways) {
      const int both = way[0] | way[1];
      if ((pairs & both) != both) continue;
      if ((visible & both) == 0 || is_soft(block, pair)) return true;
    }
    return false;
  }

  bool is_shaded(int block, int pairs) const {
    // With exact similarity and no blur, colours change only where an edge is.
    if (!is_merged_ && !is_blurred_ && cells_.corners[block].visible_edges() == 0) return false;
    for (const BlockPixel pixel : {kNorthWestPixel, kNorthEastPixel, kSouthWestPixel, kSouthEastPixel}) {
      if (shade(block, pixel) != cells_.colours[block + offset_[pixel]]) return true;
    }
    const auto differ = [&](const PixelPair& pair) {
      return (pairs & pair.bit) != 0 && shade(block, pair.a) != shade(block, pair.b);
    };
    return std::any_of(kPixelPairs.begin(), kPixelPairs.end(), differ);
  }

  const SimilarityGraph& graph_;
  const CellGraph& cells_;
  std::int64_t softness_;  ///< in 1/1000 of a level
  ShadingKind kind_;
  bool is_merged_, is_blurred_, has_own_shades_;
  Shading& shading_;
  std::array<int, 4> offset_;
};

}  // namespace

std::uint8_t blending_pixels(PairMask pairs, int pixels) {
  return kBlending[pairs & 63][pixels];
}

void build_shading(const SimilarityGraph& graph, const CellGraph& cells, const Options& options,
                   Shading& shading) {
  if (!options.has_shading()) {
    shading = {};
    return;
  }
  ShadingBuilder(graph, cells, options, shading).build();
}

}  // namespace depixel
