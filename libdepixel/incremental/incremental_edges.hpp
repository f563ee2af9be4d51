#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "libdepixel/incremental/block_moves.hpp"
#include "libdepixel/incremental/map_comparison.hpp"
#include "libdepixel/incremental/move_votes.hpp"
#include "libdepixel/incremental/rules.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"

namespace depixel {

/// The curves of successive frames, by lattice edge, and which of them are others than those of the frame
/// before, moved as its blocks were.
///
/// A frame starts by start() or reset(). Its contours are traced by trace_stale() or trace_all(), and get
/// their curves by fit().
class IncrementalEdges {
 public:
  /// Forgets all frames.
  void reset(const Lattice& lattice);
  /// Whether the table has so many shapes that frames should be forgotten with it.
  bool has_many_shapes() const { return table_.places() > place_limit_; }

  /// What is of the last frame becomes that of the frame before.
  void start(const BlockMoves& blocks);

  /// Traces the contours again that pass through some corners. The others are those before, moved.
  /// \param codes_before  of these corners, in the same order.
  void trace_stale(const CellGraph& cells, const std::vector<PixelMarks>& marks, std::span<const int> stale,
                   std::span<const CornerCode> codes_before, const Options& options, const BlockMoves& blocks,
                   RuleSet rules);
  /// Traces all contours; nothing is told of what differs.
  void trace_all(const CellGraph& cells, const std::vector<PixelMarks>& marks, const Options& options);
  /// Gives what was traced its curves, and joins it at T-junctions.
  void fit(const CellGraph& cells, const Options& options, RuleSet rules, Workers& workers);
  const EdgeMap& edges() const { return edges_; }
  const SplineTable& table() const { return table_; }
  /// Curves of the frame before, by edge_slot().
  const std::vector<int>& before() const { return before_; }
  /// After trace_stale(), edges whose curves may differ from those before, moved as their blocks were, each
  /// once.
  std::span<const SetCurve> set() const { return set_; }
  MoveVotes& votes() { return votes_; }

  /// Visible edges.
  int segments() const { return segments_; }
  /// Of what was traced.
  const Contours& contours() const { return contours_; }
  const Arcs& arcs() const { return arcs_; }
  int fitted_shapes() const { return fitted_shapes_; }

  std::size_t memory_bytes() const;

 private:
  void forget_set();
  void move(const BlockMoves& blocks);
  void remove(const CellGraph& cells, std::span<const int> stale, std::span<const CornerCode> codes_before);
  void join(const CellGraph& cells, RuleSet rules);
  void set_curve(int slot, int number);

  SplineTable table_{true};
  std::size_t place_limit_ = 0;  ///< with more places, the table is to be made anew
  EdgeMap edges_;
  std::vector<int> before_;
  std::vector<SetCurve> set_;
  std::vector<std::uint8_t> is_slot_set_;  ///< by slot
  int segments_ = 0;
  bool is_settled_ = false;  ///< before_ is what the edges are now, but for what was set since
  bool is_all_ = false;      ///< all contours were traced
  bool is_first_ = false;    ///< no frame was known before

  Contours contours_;
  Arcs arcs_;
  MoveVotes votes_;
  int fitted_shapes_ = 0;
};

}  // namespace depixel
