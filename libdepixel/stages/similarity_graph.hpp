#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "libdepixel/core/frame_view.hpp"
#include "libdepixel/core/lattice.hpp"
#include "libdepixel/core/memory.hpp"
#include "libdepixel/core/options.hpp"

namespace depixel {

/// Which links of a block belong to it: its north and west sides and its two diagonals. The south side is the
/// north side of the block below, the east side the west side of the block to the right.
using BlockLink = std::uint8_t;
inline constexpr BlockLink kNorthSide = 1;     ///< NW - NE
inline constexpr BlockLink kWestSide = 2;      ///< NW - SW
inline constexpr BlockLink kMainDiagonal = 4;  ///< NW - SE
inline constexpr BlockLink kAntiDiagonal = 8;  ///< NE - SW
inline constexpr BlockLink kBothDiagonals = kMainDiagonal | kAntiDiagonal;

/// The frame's pixels on a padded lattice, and for each block a mask of BlockLink.
struct SimilarityGraph {
  Lattice lattice;
  std::vector<Rgba> pixels;         ///< padded; alpha 0 normalised, padding transparent
  std::vector<std::uint8_t> links;  ///< padded; BlockLink mask of each block, padding unlinked

  /// Links between a block's sides: how many of its four sides are links.
  int side_count(int block) const {
    const auto bit = [&](int b, int link) { return (links[b] & link) != 0; };
    return bit(block, kNorthSide) + bit(block, kWestSide) + bit(block + lattice.stride(), kNorthSide) +
           bit(block + 1, kWestSide);
  }
  /// True where two diagonals cross and the block is not one piece by its sides.
  bool is_crossing(int block) const {
    return (links[block] & kBothDiagonals) == kBothDiagonals && side_count(block) < 3;
  }
  /// The eight neighbours that a pixel is linked to; bits clockwise from north: N NE E SE S SW W NW.
  std::uint8_t neighbours(int pixel) const;

  /// Makes room for another size of picture; where it stays, so does all that the arrays hold.
  void resize(const Lattice& size) {
    if (lattice == size) return;
    pixels.assign(size.size(), Rgba{});
    links.assign(size.size(), 0);
    lattice = size;
  }
  std::size_t memory_bytes() const { return held_bytes(pixels, links); }
};

/// SimilarityGraph::neighbours() of all pixels at once. Entries of the padding mean nothing.
/// \param masks  padded, and a little longer.
void find_neighbours(const SimilarityGraph& graph, std::vector<std::uint8_t>& masks);
/// Just a part of row y, from .. to - 1, and maybe up to fifteen entries more. \param masks  has its size.
void find_neighbours(const SimilarityGraph& graph, int y, int from, int to, std::vector<std::uint8_t>& masks);

/// Index offsets to the eight neighbours, clockwise from north, as in SimilarityGraph::neighbours().
std::array<int, 8> neighbour_offsets(const Lattice& lattice);

/// Which neighbours are linked.
struct LinkCriteria {
  Similarity similarity = Similarity::exact;
  bool connect_lines = false;
  int merge_luma = thousandths(Options{}.merge_luma);  ///< of similar_yuv(), 1/1000 of a level

  static LinkCriteria of(const Options& options) {
    return {options.similarity, options.connect_lines, thousandths(options.merge_luma)};
  }
  static int thousandths(double levels) { return static_cast<int>(std::lround(1000 * levels)); }
};

/// Builds the similarity graph of a frame and freezes it (stage 1 of 6): links all similar neighbours, joins
/// lines if asked to, and drops both diagonals of every block that is one piece through its sides already.
/// \param frame  at least 1x1 pixels.
/// \param graph  overwritten; its buffers are reused.
/// Cost: linear in pixels; no allocation when the size stays (but for connect-lines).
/// Source: Schapfel, section 4.1; Kopf and Lischinski 2011, section 3.2.
void build_similarity_graph(const FrameView& frame, const LinkCriteria& criteria, SimilarityGraph& graph);

/// Takes over a part of row y of a frame's pixels, from .. to - 1, normalized.
/// \param graph  of the frame's size.
void take_pixels(const FrameView& frame, int y, int from, int to, SimilarityGraph& graph);

/// The pixels of a graph as a frame; valid as long as they are.
FrameView pixels_of(const SimilarityGraph& graph);

/// A part of row y of it, from .. to - 1, and maybe up to fifteen blocks more, for exact similarity and
/// without connect-lines: a block's links depend on its four pixels alone. \param graph  its pixels are read.
/// \param links  padded; only the row's entries are written.
void link_exactly(const SimilarityGraph& graph, int y, int from, int to, std::vector<std::uint8_t>& links);

/// The links before freezing, as view 0 of the thesis shows them.
void build_raw_similarity_graph(const FrameView& frame, const LinkCriteria& criteria, SimilarityGraph& graph);

}  // namespace depixel
