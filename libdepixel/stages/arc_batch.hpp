#pragma once

#include <cstdint>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/stages/arcs.hpp"

namespace depixel {

/// How a node of an arc takes part in smoothing and fitting.
enum class NodeRole : std::uint8_t {
  free,   ///< moves
  held,   ///< stays put; the curve runs on smoothly
  sharp,  ///< stays put, and the spline is broken here: knot and control point coincide
};

/// Some arcs laid out for vector code: coordinates in arrays of their own, and round every arc kGhosts
/// entries on each side that repeat a closed one's other end. All lengths are source
/// pixels; positions are displacements from each node's own lattice corner, so that equal shapes have equal
/// bits wherever they lie.
struct ArcBatch {
  static constexpr int kGhosts = 2;
  /// No node strays farther from its corner along an axis: half a pixel less a little more than the clearance
  /// of centres.
  static constexpr float kReach = 0.4370f;

  struct Member {
    int first = 0;  ///< entry of its first node
    int count = 0;  ///< nodes
    bool closed = false;
    bool interpolated = false;  ///< the spline goes through the nodes instead of near them
    int rounds = 0;             ///< of averaging
    int source = 0;             ///< for the caller: where its results go
    int last() const { return first + count - 1; }
    int step_count() const { return closed ? count : count - 1; }
  };

  std::vector<Member> members;
  int size = 0;  ///< entries in use, ghosts included

  // Arrays have room for whole vectors beyond the last entry.
  std::vector<ShapeWord> word;        ///< what the arc is like at the node
  std::vector<float> x, y;            ///< nodes, later control points of the spline
  std::vector<float> rest_x, rest_y;  ///< where smoothing would have them stay
  std::vector<float> step_x, step_y;  ///< lattice step that leaves the node
  std::vector<float> mobility;        ///< 1 where the node is free, else 0
  std::vector<float> held;            ///< 1 where the node is held, else 0
  std::vector<float> bends1,
      bends2;                     ///< 1 where bending counts between neighbours one (two) steps away, else 0
  std::vector<float> smoothness;  ///< 1/6 where the spline is smooth, 0 where it is broken
  std::vector<float> knot_x, knot_y;  ///< the curve's point at the node
  std::vector<NodeRole> role;

  /// Forgets the members.
  void clear() {
    members.clear();
    size = 0;
  }

  /// Makes room for an arc and lays down its words and lattice steps; everything else is for the caller to
  /// fill.
  Member& add(std::span<const ShapeWord> words, ArcKind kind, int source);

  /// Gives a node its role, and what follows from the role alone.
  void set_role(int entry, NodeRole new_role) {
    role[entry] = new_role;
    mobility[entry] = new_role == NodeRole::free ? 1.0f : 0.0f;
    held[entry] = new_role == NodeRole::held ? 1.0f : 0.0f;
    smoothness[entry] = new_role == NodeRole::sharp ? 0.0f : 1.0f / 6.0f;
  }
  /// To be called when all members are placed: bounds x and y by kReach, and finds where bending counts:
  /// round no node that is not free, coarsely between free neighbours only, finely next to no held node.
  void settle();
  /// Repeats the ends of all closed members in their ghosts, in a pair of arrays over the entries.
  void close(std::vector<float>& values_x, std::vector<float>& values_y) const;
  /// Computes the knots of entries from .. to - 1, and of up to seven more: (1 4 1)/6 of the control points
  /// x, y; sharp ones are knots themselves.
  void find_knots(int from, int to);

  std::size_t memory_bytes() const {
    return held_bytes(members, word, x, y, rest_x, rest_y, step_x, step_y, mobility, held, bends1, bends2,
                      smoothness, knot_x, knot_y, role);
  }

  /// Repeats a closed arc's ends in its ghosts. A closed arc has four nodes at least.
  template <typename Value>
  static void close_ghosts(const Member& member, std::vector<Value>& values) {
    for (int g = 0; g < kGhosts; ++g) {
      values[member.first - 1 - g] = values[member.last() - g];
      values[member.last() + 1 + g] = values[member.first + g];
    }
  }
  /// The same for a closed arc; an open one's ghosts are set to a value.
  template <typename Value>
  static void fill_ghosts(const Member& member, std::vector<Value>& values, Value beyond_ends) {
    if (member.closed) {
      close_ghosts(member, values);
    } else {
      for (int g = 1; g <= kGhosts; ++g) values[member.first - g] = values[member.last() + g] = beyond_ends;
    }
  }

  /// An index that may have left 0 .. count - 1 by at most count, brought back round.
  static int wrapped(int k, int count) { return k < 0 ? k + count : k >= count ? k - count : k; }
};

}  // namespace depixel
