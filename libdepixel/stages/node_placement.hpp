#pragma once

#include <cstdint>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/core/options.hpp"
#include "libdepixel/stages/contour_batch.hpp"

namespace depixel {

/// Marks the pixels of one-pixel-wide lines: valence of at most 2 in the resolved graph, the two links not
/// part of a triangle. `thin` is padded, 1 where a pixel is thin.
void find_thin_pixels(const SimilarityGraph& graph, std::vector<std::uint8_t>& thin);

/// Decides for every node of a contour where it starts, where it would rest and what role it plays, from the
/// runs of equal steps that the contour is made of.
///
/// - A right angle whose arms both run straight for two more steps is a corner: put back on the lattice,
/// sharp.
/// - The square end of a one-pixel-wide line is held, so that the line keeps its length.
/// - Slanted one-pixel-wide lines are widened to a width of one pixel (the cell graph makes 45 degrees 0.71
/// wide).
/// - A staircase of single steps starts as the line through the middles of its steps, a bulge as a parabola:
/// the low
///   frequencies, which sweeps over neighbours would take long to reach.
class NodePlacer {
 public:
  /// Starts on a frame; what is passed must outlive the calls of add().
  /// \param thin  by find_thin_pixels(); read with Smoothing::energy only.
  void start(const CellGraph& cells, const Contours& contours, const std::vector<std::uint8_t>& thin) {
    cells_ = &cells;
    contours_ = &contours;
    thin_ = &thin;
    left_ = cells.lattice.left_offsets();
  }

  /// Adds a contour to a batch and places its nodes.
  /// \param interpolated  the spline will go through the nodes instead of near them.
  void add(const Contour& contour, Smoothing smoothing, bool interpolated, ContourBatch& batch);

  std::size_t memory_bytes() const { return held_bytes(runs_, thin_sides_); }

 private:
  /// A maximal sequence of equal steps; a junction of four divides it.
  struct Run {
    int start;   ///< node of its first step, counted from the contour's first node
    int length;  ///< steps
    Direction heading;
    int turn_in,
        turn_out;  ///< at its ends: 1 to the right, -1 to the left, 0 at an open end or junction of four
  };

  void find_runs(const Contour& contour);
  void place_at_rest(const Contour& contour);
  void find_thin_sides(const Contour& contour);
  void restore_corners(int minimum_arm, bool sharp);
  void hold_square_ends();
  void straighten_stairs();
  void straighten_stair(int run);
  void widen_thin_lines();

  int entry(int node) const { return member_.first + (node >= member_.count ? node - member_.count : node); }
  /// The run `offset` runs on, or nullptr beyond the end of an open contour.
  const Run* neighbour(int run, int offset) const;
  bool is_thin(const Run& run, int side) const;

  const CellGraph* cells_ = nullptr;
  const Contours* contours_ = nullptr;
  const std::vector<std::uint8_t>* thin_ = nullptr;
  std::array<int, 4> left_{};
  ContourBatch* batch_ = nullptr;
  ContourBatch::Member member_;
  std::vector<Run> runs_;
  std::vector<std::uint8_t>
      thin_sides_;  ///< by step: 1 where the pixel on the left is thin, plus 2 for the right
  bool has_thin_sides_ = false;
};

}  // namespace depixel
