#pragma once

#include <cstdint>
#include <vector>

#include "libdepixel/incremental/row_spans.hpp"
#include "libdepixel/incremental/rules.hpp"
#include "libdepixel/stages/similarity_graph.hpp"

namespace depixel {

/// Finds the crossings whose votes may have changed. Keeps its buffers.
class StaleCrossings {
 public:
  /// \param frozen      the frozen graph.
  /// \param changed     where its links differ from what they were, by block.
  /// \param neighbours  by find_neighbours(), of the graph as it was; brought up to date.
  /// \return the crossings with a changed link in their 8x8 window (Rule::crossings_by_windows), and those on
  /// a
  ///         curve that ran, or runs, by a pixel whose links changed (Rule::crossings_by_curves); each once.
  ///         Valid until the next call.
  const std::vector<int>& find(const SimilarityGraph& frozen, const RowSpans& changed, RuleSet rules,
                               std::vector<std::uint8_t>& neighbours);

  std::size_t memory_bytes() const { return held_bytes(stale_, is_stale_, visited_, is_visited_, before_); }

 private:
  void add(const SimilarityGraph& frozen, int block);
  void find_by_windows(const SimilarityGraph& frozen, const RowSpans& changed);
  void renew_row(const SimilarityGraph& frozen, int y, bool follows, std::vector<std::uint8_t>& neighbours);
  void follow_curves(const SimilarityGraph& frozen, int pixel, const std::vector<std::uint8_t>& neighbours);

  std::vector<int> stale_;
  std::vector<std::uint8_t> is_stale_;  ///< padded, by block
  std::vector<int> visited_;            ///< pixels of curves that were followed
  std::vector<std::uint8_t> is_visited_;
  std::vector<int> changed_pixels_;
  std::vector<std::uint8_t> before_;
};

}  // namespace depixel
