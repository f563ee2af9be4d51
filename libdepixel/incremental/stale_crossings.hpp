#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "libdepixel/incremental/block_set.hpp"
#include "libdepixel/incremental/rules.hpp"
#include "libdepixel/stages/curve_walk.hpp"
#include "libdepixel/stages/similarity_graph.hpp"

namespace depixel {

/// Finds the crossings whose votes may have changed. Keeps its buffers.
class StaleCrossings {
 public:
  /// \param frozen      the frozen graph.
  /// \param near        blocks that hold, with those beside them, all links that changed.
  /// \param seams       pixels with a link to what was not beside them before.
  /// \param neighbours  by find_neighbours(), of the graph as it was, or was moved; brought up to date.
  /// \return the crossings in these blocks (Rule::crossings_by_windows), and those on a curve that ran, or
  ///         runs, by a pixel whose links changed (Rule::crossings_by_curves), or linked to one
  ///         (Rule::crossings_by_junctions), or by a seam (Rule::crossings_by_seams); each once. Valid until
  ///         the next call.
  const std::vector<int>& find(const SimilarityGraph& frozen, const BlockSet& near,
                               std::span<const int> seams, CurveRule curve_rule, RuleSet rules,
                               std::vector<std::uint8_t>& neighbours);

  std::size_t memory_bytes() const {
    return held_bytes(stale_, is_stale_, visited_, visited_links_, changed_pixels_, before_);
  }

 private:
  void forget(const Lattice& lattice);
  void add(const SimilarityGraph& frozen, int block);
  void find_in_row(const SimilarityGraph& frozen, const BlockSet& near, int y, RuleSet rules,
                   std::vector<std::uint8_t>& neighbours);
  void follow_curves(const SimilarityGraph& frozen, int pixel, const std::vector<std::uint8_t>& neighbours,
                     const CurveWalk& walk);
  bool visit(int pixel, int neighbour);

  std::vector<int> stale_;
  std::vector<std::uint8_t> is_stale_;       ///< padded, by block
  std::vector<int> visited_;                 ///< pixels of curves that were followed
  std::vector<std::uint8_t> visited_links_;  ///< padded; by pixel, a mask of neighbours
  std::vector<int> changed_pixels_;
  std::vector<std::uint8_t> before_;
};

}  // namespace depixel
