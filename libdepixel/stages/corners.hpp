#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/stages/arc_batch.hpp"
#include "libdepixel/stages/digital_line.hpp"
#include "libdepixel/stages/runs.hpp"

namespace depixel {

/// Breaks an arc's spline at its corners (a part of stage 5 of 6): where two long digital straight segments
/// meet at an angle. The node there goes to where their lines meet, and those beside it go to the lines. The
/// square ends of bars that are two pixels wide are corners, too.
///
/// A corner must stand out from the chord between points equally far away along its arms. Circles of all
/// sizes look alike by that measure: a digital straight segment on a circle of radius r rises by about a step
/// above its chord, so it is about 2 sqrt(2 r) long, and two of them stand out by 4.
///
/// All of it depends on the arc's words alone, and is the same to the bit whatever way the arc runs or is
/// turned. Cost: linear in the nodes where the arc turns twice to the same side or by a right angle, times
/// kLongestArm. Source: Schapfel, sections 4.7.1 and 7.1.6, asks for knots of higher multiplicity where long
/// straight lines meet at an angle; how such places are found is our own.
class CornerPlacer {
 public:
  /// Steps of an arm that are looked at: on longer ones, what is far away would move the corner.
  static constexpr int kLongestArm = 20;

  /// \param words  of the arc, whose runs and member these are.
  /// \param batch  x, y, rest_x, rest_y and roles of the member are changed.
  void place(std::span<const ShapeWord> words, const Runs& runs, const ArcBatch::Member& member,
             ArcBatch& batch);

  std::size_t memory_bytes() const { return held_bytes(candidates_, distances_, corners_, pulls_); }

 private:
  /// A node, and where it is in a run.
  struct Candidate {
    int node, run, offset;
  };
  struct Corner {
    int node;
    DigitalLine before, after;  ///< its arms, both from the corner on
    glm::vec2 meeting;          ///< of their lines, from the node's lattice corner
  };
  /// Where lines would have a node move to: the sum over lines, times their weights.
  struct Pull {
    float move_x = 0, move_y = 0, weight = 0;
  };

  void hold_bar_ends();
  void find_candidates();
  void add_candidate(int run, int offset);
  void add_candidates_between_turns(int run);
  void find_corners();
  float distance(int node) const;
  bool is_middle(int node) const;
  bool is_tip(int node) const;
  void straighten_arms();
  void pull_to(const DigitalLine& line, int node, int direction, int last);
  void apply_pulls();

  bool has_room(int run, int steps, int direction) const;
  DigitalLine arm(const Candidate& candidate, int direction) const;
  Direction step_from(int node, int direction) const;
  int wrapped(int node) const { return ArcBatch::wrapped(node, member_.count); }

  std::span<const ShapeWord> words_;
  const Runs* runs_ = nullptr;
  ArcBatch* batch_ = nullptr;
  ArcBatch::Member member_;
  std::vector<Candidate> candidates_;
  /// By node: squared, from its lattice corner to where its arms meet; kFar where it is no corner.
  std::vector<float> distances_;
  std::vector<Corner> corners_;
  std::vector<Pull> pulls_;  ///< by node
};

}  // namespace depixel
