#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/stages/arc_batch.hpp"
#include "libdepixel/stages/digital_line.hpp"
#include "libdepixel/stages/runs.hpp"

namespace depixel {

/// Finds where an arc has corners, between two long digital straight segments that meet at an angle, breaks
/// the spline there and lays the nodes beside it on the two lines (a part of stage 5 of 6).
///
/// What counts is how far a corner stands out from the chord between points equally far along its two arms.
/// Circles of all sizes look alike by this measure: a digital straight segment on a circle of radius r rises
/// by one step above its chord, so it is about 2 sqrt(2 r) long, and two of them stand out by 4.
///
/// Cost: linear in the arc's nodes where it turns twice to the same side or by a right angle, times the length
/// of arms there. Source: Schapfel, sections 4.7.1 and 7.1.6, asks for knots of higher multiplicity where long
/// straight lines meet; the measure is ours.
class CornerPlacer {
 public:
  /// \param runs   of the arc.
  /// \param batch  the member's x, y, rest_x, rest_y and roles are changed.
  void place(std::span<const ShapeWord> words, const Runs& runs, const ArcBatch::Member& member,
             ArcBatch& batch);

  std::size_t memory_bytes() const { return held_bytes(candidates_, heights_, corners_, pulls_); }

 private:
  struct Corner {
    int node;
    DigitalLine before, after;  ///< its arms, both from the corner on
  };
  /// What lines would have a node move by: the sum over lines, and of their weights.
  struct Pull {
    glm::vec2 move{0};
    float weight = 0;
  };

  void find_candidates(const Runs& runs);
  void add_candidate(int node);
  DigitalLine arm(int node, int direction) const;
  void find_corners();
  void straighten_arms();
  void straighten(const Corner& corner, const DigitalLine& line, int direction, int reach);

  int wrapped(int node) const { return ArcBatch::wrapped(node, member_.count); }

  std::span<const ShapeWord> words_;
  ArcBatch* batch_ = nullptr;
  ArcBatch::Member member_;
  std::vector<int> candidates_;
  std::vector<float> heights_;  ///< by node: squared, of what may be a corner; else 0
  std::vector<Corner> corners_;
  std::vector<Pull> pulls_;  ///< by node
};

}  // namespace depixel
