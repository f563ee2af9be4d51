#pragma once

#include <cstdint>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/core/options.hpp"
#include "libdepixel/stages/arc_batch.hpp"
#include "libdepixel/stages/corners.hpp"
#include "libdepixel/stages/runs.hpp"

namespace depixel {

/// Decides for every node of an arc where it starts, where it would rest and what role it plays, from the
/// runs of equal steps that the arc is made of.
///
/// - Nodes of small text are held where the cell graph has them.
/// - The square end of a one-pixel-wide line is held, so that the line keeps its length.
/// - Slanted one-pixel-wide lines are widened to a width of one pixel (the cell graph makes them 0.71 wide at
///   45 degrees).
/// - A staircase of single steps starts as the line through the middles of its steps, a bulge as a parabola:
///   the low frequencies, which sweeps over neighbours would take long to reach.
class NodePlacer {
 public:
  /// Adds an arc to a batch and places its nodes.
  void add(std::span<const ShapeWord> words, ArcKind kind, const Options& options, int source,
           ArcBatch& batch);

  std::size_t memory_bytes() const { return runs_.memory_bytes() + corners_.memory_bytes(); }

 private:
  void place_at_rest(std::span<const ShapeWord> words);
  void hold_corners();
  void hold_square_ends();
  void hold_square_tips();
  void straighten_stairs();
  void straighten_stair(int run);
  void widen_thin_lines();
  void hold_text(std::span<const ShapeWord> words);

  int entry(int node) const { return member_.first + ArcBatch::wrapped(node, member_.count); }
  int thin_sides(const Run& run) const;

  ArcBatch* batch_ = nullptr;
  ArcBatch::Member member_;
  Runs runs_;
  CornerPlacer corners_;
};

}  // namespace depixel
