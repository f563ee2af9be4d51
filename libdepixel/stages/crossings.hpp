#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/core/options.hpp"
#include "libdepixel/stages/similarity_graph.hpp"

namespace depixel {

/// Weights of the three heuristics that vote at a crossing.
struct CrossingVotes {
  double curve = 1.0;  ///< times the difference of the two curve lengths, for the longer
  double sparse =
      1.0;  ///< times the difference of the two component sizes in the 8x8 window, for the smaller
  double island = 5.0;                          ///< for a diagonal with an end of valence 1
  CurveRule curve_rule = Options{}.curve_rule;  ///< how curves are followed

  static CrossingVotes of(const Options& options) {
    return {options.curve_weight, options.sparse_weight, options.island_weight, options.curve_rule};
  }
};

/// Component sizes in an 8x8 window, by the window's links: windows of dithers and tiles recur.
struct WindowCacheEntry {
  std::array<std::uint64_t, 8> rows{};  ///< BlockLink masks, eight bytes a row
  int main_size = 0, anti_size = 0;     ///< 0 where the entry is empty
};

/// Buffers that crossings are resolved with; kept from frame to frame.
struct CrossingScratch {
  std::vector<WindowCacheEntry> windows;  ///< direct-mapped
  std::vector<int> crossings;             ///< blocks whose diagonals cross
  std::vector<std::uint8_t> cut;          ///< BlockLink mask to remove, one for each crossing
  std::vector<std::uint8_t> neighbours;   ///< by find_neighbours(), of the frozen graph
  std::vector<int> curve_length;  ///< padded; by block, of the curves through its two diagonals, 0 where not
                                  ///< known; all 0 between calls
  std::vector<int> measured;      ///< entries of curve_length that are not 0

  std::size_t memory_bytes() const {
    return held_bytes(windows, crossings, cut, neighbours, curve_length, measured);
  }
};

/// Resolves every crossing pair of diagonals (stage 2 of 6).
/// \param graph  the frozen similarity graph; read while votes are cast, then cut.
/// \post  No two links cross. Independent of the order in which blocks are visited.
/// \return the number of crossings.
/// Cost: linear in pixels; every long curve is walked once and its length kept, every window is flood-filled
/// with bit operations on 64 pixels at a time. Source: Kopf and Lischinski 2011, section 3.2; Schapfel,
/// sections 4.2 and 7.1.1; see CurveWalk.
int resolve_crossings(SimilarityGraph& graph, const CrossingVotes& votes, CrossingScratch& scratch);

/// Resolves just some of the crossings of a frozen graph.
/// \param blocks   crossings, each once.
/// \param scratch  neighbours must be those of the frozen graph.
/// \param links    padded; set for these blocks only.
void resolve_some_crossings(const SimilarityGraph& frozen, std::span<const int> blocks,
                            const CrossingVotes& votes, CrossingScratch& scratch,
                            std::vector<std::uint8_t>& links);

}  // namespace depixel
