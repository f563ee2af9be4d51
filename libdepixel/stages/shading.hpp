#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/core/options.hpp"
#include "libdepixel/stages/cell_graph.hpp"

namespace depixel {

/// Pairs of a block's four pixels, as bits of a mask.
using PairMask = std::uint8_t;
inline constexpr PairMask kNorthPair = 1;  ///< NW - NE
inline constexpr PairMask kEastPair = 2;   ///< NE - SE
inline constexpr PairMask kSouthPair = 4;  ///< SW - SE
inline constexpr PairMask kWestPair = 8;   ///< NW - SW
inline constexpr PairMask kMainPair = 16;  ///< NW - SE
inline constexpr PairMask kAntiPair = 32;  ///< NE - SW

/// A block's pixels, as bits 0 to 3 of a mask name them; and two of them.
enum BlockPixel : std::uint8_t { kNorthWestPixel, kNorthEastPixel, kSouthWestPixel, kSouthEastPixel };
struct PixelPair {
  PairMask bit;
  BlockPixel a, b;
};
/// Those along sides, in the order of the edges between them, then those across.
inline constexpr std::array<PixelPair, 6> kPixelPairs{{{kNorthPair, kNorthWestPixel, kNorthEastPixel},
                                                       {kEastPair, kNorthEastPixel, kSouthEastPixel},
                                                       {kSouthPair, kSouthWestPixel, kSouthEastPixel},
                                                       {kWestPair, kNorthWestPixel, kSouthWestPixel},
                                                       {kMainPair, kNorthWestPixel, kSouthEastPixel},
                                                       {kAntiPair, kNorthEastPixel, kSouthWestPixel}}};
/// Index offsets from a block to its pixels.
constexpr std::array<int, 4> block_pixels(int stride) {
  return {0, 1, stride, stride + 1};
}
/// Calls visit(block, pair, a, b) for each pair of every block of a lattice; a and b are its pixels.
template <typename Visit>
void for_each_pixel_pair(const Lattice& lattice, Visit visit) {
  const std::array<int, 4> offset = block_pixels(lattice.stride());
  for (int y = 0; y <= lattice.height(); ++y) {
    for (int block = lattice.corner(0, y), end = block + lattice.width(); block <= end; ++block) {
      for (const PixelPair& pair : kPixelPairs) {
        visit(block, pair, block + offset[pair.a], block + offset[pair.b]);
      }
    }
  }
}

/// How colours run inside the regions of a planar map, where they are not even.
///
/// Between the centres of a block's four pixels, a region has a mixture of the shades of those that blend
/// with it: the block's pixels of the region's own colour, and all that are paired with one of them. Each
/// weighs the more the nearer it is; at its own centre, all. Pixels on the far side of a sharp contour are no
/// pair, so nothing leaks across it. A contour between pixels that are a pair is *soft*: the colours on its
/// sides run into each other.
struct Shading {
  /// A block's pairs, and whether any of its pixels is shaded.
  static constexpr std::uint8_t kShaded = 64;

  ShadingKind kind = ShadingKind::none;  ///< as asked for; pixels do not depend on it, vector files do
  bool any = false;                      ///< some block is shaded
  std::vector<Rgba>
      shades;  ///< padded, by pixel: its colour at its centre; empty where the options have no shading
  std::vector<std::uint8_t>
      blocks;  ///< padded, by block: kShaded and its pairs, or 0: all regions have their colour

  /// Whether anything is shaded in a pixel's square.
  bool is_shaded(int pixel, int stride) const {
    return (blocks[pixel - stride - 1] | blocks[pixel - stride] | blocks[pixel - 1] | blocks[pixel]) != 0;
  }

  friend bool operator==(const Shading&, const Shading&) = default;

  std::size_t memory_bytes() const { return held_bytes(shades, blocks); }
};

/// The pixels of a block that blend with those of a set, itself among them.
std::uint8_t blending_pixels(PairMask pairs, int pixels);

/// Finds how colours run inside regions (of stage 3, read by rasterisers only).
/// Pairs are pixels of one component, side by side or linked across a diagonal, and, up to a distance of
/// colours, those that a soft contour divides. \param graph  resolved. \param cells  of the graph. Cost:
/// linear in pixels; little where regions are even. Source: Kopf and Lischinski 2011, section 3.5; Schapfel,
/// sections 4.8, 7.1.2 and 7.1.3.
void build_shading(const SimilarityGraph& graph, const CellGraph& cells, const Options& options,
                   Shading& shading);

}  // namespace depixel
