#pragma once

#include <cstdint>
#include <vector>

#include "libdepixel/incremental/block_moves.hpp"
#include "libdepixel/incremental/stale_crossings.hpp"
#include "libdepixel/stages/crossings.hpp"

namespace depixel {

/// How much of a frame must differ before all of it is taken to be new: as a part of its pixels, and of small
/// frames all.
inline bool is_most(const Lattice& lattice, double part, std::size_t count) {
  constexpr int kFewestPixels = 1024;
  const int pixels = lattice.width() * lattice.height();
  return pixels >= kFewestPixels && static_cast<double>(count) > part * pixels;
}

/// The resolved similarity graph of successive frames: links that may differ from those before are made anew,
/// and crossings whose votes may. What is known of the frame before is moved as its blocks were.
class IncrementalGraph {
 public:
  /// Forgets all frames.
  void reset(const Lattice& lattice);

  /// Takes over a frame.
  /// \param blocks  how the frame differs from the one before.
  void update(const FrameView& frame, const Options& options, const BlockMoves& blocks, RuleSet rules);

  const SimilarityGraph& resolved() const { return graph_; }
  const Lattice& lattice() const { return graph_.lattice; }
  /// Blocks outside which all pixels and resolved links within two pixels are what they were, or were moved
  /// as these blocks were.
  const BlockSet& stale() const { return stale_; }
  /// Whether so many links differ that what was made of them is hardly worth a look.
  bool is_new() const { return is_new_; }
  /// Crossings that were resolved.
  int crossings() const { return resolved_crossings_; }

  std::size_t memory_bytes() const {
    return graph_.memory_bytes() + frozen_.memory_bytes() + growing_.memory_bytes() + near_.memory_bytes() +
           stale_.memory_bytes() + stale_crossings_.memory_bytes() + crossings_.memory_bytes() +
           held_bytes(seams_, before_, moved_);
  }

 private:
  void move(const BlockMoves& blocks);
  void find_near(const BlockMoves& blocks, RuleSet rules);
  void take_changed(const FrameView& frame, const BlockMoves& blocks);
  void relink();
  void find_seams(const BlockMoves& blocks, CurveRule curve_rule);
  void resolve_all(const CrossingVotes& votes);
  void resolve_some(const CrossingVotes& votes, const BlockMoves& blocks, RuleSet rules);
  void thaw();

  SimilarityGraph graph_;   ///< resolved
  SimilarityGraph frozen_;  ///< its links alone, before crossings are resolved
  BlockSet growing_;        ///< blocks that make those beside them near
  BlockSet near_;           ///< these, and those beside them
  BlockSet stale_;
  std::vector<int> seams_;  ///< pixels that are linked across one
  StaleCrossings stale_crossings_;
  CrossingScratch crossings_;
  bool is_new_ = false;
  int resolved_crossings_ = 0;
  std::vector<std::uint8_t> before_;  ///< scratch: links of the stale crossings
  std::vector<std::uint8_t> moved_;   ///< scratch
};

}  // namespace depixel
