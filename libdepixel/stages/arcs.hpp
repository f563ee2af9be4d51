#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/core/options.hpp"
#include "libdepixel/stages/contours.hpp"
#include "libdepixel/stages/pixel_marks.hpp"

namespace depixel {

/// What an arc's spline depends on at one of its nodes: the corner's code, the heading of the step that
/// leaves the node (at the end of an open arc: that arrives), on which sides of that step the pixel is thin,
/// and whether one of the two is text's.
class ShapeWord {
 public:
  constexpr ShapeWord() = default;
  /// \param left, right  marks of the pixels on the step's sides; see PixelMarks.
  constexpr ShapeWord(CornerCode code, Direction heading, int left, int right)
      : bits_(static_cast<std::uint16_t>(
            code.bits() | heading << kHeadingShift | (left & kThinLine) << kThinShift |
            (right & kThinLine) << (kThinShift + 1) | ((left | right) & kText) << (kTextShift - 1))) {}

  constexpr CornerCode code() const { return CornerCode(static_cast<std::uint8_t>(bits_ & 127)); }
  constexpr Direction heading() const { return static_cast<Direction>(bits_ >> kHeadingShift & 3); }
  /// 1 where the pixel on the left is thin, plus 2 for the right.
  constexpr int thin_sides() const { return bits_ >> kThinShift & 3; }
  constexpr bool is_text() const { return (bits_ >> kTextShift & 1) != 0; }

  static constexpr int kBits = 12;
  constexpr std::uint16_t bits() const { return bits_; }

  friend constexpr bool operator==(ShapeWord, ShapeWord) = default;

 private:
  static constexpr int kHeadingShift = 7, kThinShift = 9, kTextShift = 11;
  std::uint16_t bits_ = 0;
};
static_assert(sizeof(ShapeWord) == 2);

/// What an arc's spline depends on besides its words.
struct ArcKind {
  bool closed = false;        ///< comes back to its start without a node where the spline is broken
  bool interpolated = false;  ///< the spline goes through the nodes instead of near them
  std::uint8_t rounds = 0;    ///< of averaging; with Smoothing::average only

  friend bool operator==(const ArcKind&, const ArcKind&) = default;
};

/// A part of a contour between two nodes where the spline is broken, both included; or a whole contour
/// without such nodes. Its nodes are entries first .. first + count - 1 of Arcs.
struct Arc {
  int first = 0;
  int count = 0;
  ArcKind kind;
  int place = 0;  ///< SplineTable::place_of() its shape; to be set by whom fits it

  int step_count() const { return kind.closed ? count : count - 1; }
};

/// Arcs of a frame in flat arrays. Neighbouring arcs have entries of their own for the node that they share.
struct Arcs {
  std::vector<int> corner;      ///< of each node
  std::vector<ShapeWord> word;  ///< of each node
  std::vector<Arc> list;
  std::vector<std::uint8_t> continues;  ///< scratch; by node of a contour, two more at either end

  std::span<const ShapeWord> words(const Arc& arc) const {
    return std::span(word).subspan(arc.first, arc.count);
  }
  std::size_t memory_bytes() const { return held_bytes(corner, word, list, continues); }
};

/// Cuts contours into arcs: at junctions of four, and, with Smoothing::energy, at right angles with two arms
/// that run straight for two more steps. Such a node lies on its lattice corner whatever is on either side,
/// so an arc's spline depends on its words and its kind alone. Words of an open arc's ends have no code: all
/// of them lie on their lattice corner. \param marks  by find_pixel_marks(); read with Smoothing::energy
/// only. \param arcs  overwritten; its buffers are reused. Cost: linear in nodes. Source: Schapfel,
/// section 4.7 (figure 57).
void cut_arcs(const CellGraph& cells, const Contours& contours, const std::vector<std::uint8_t>& marks,
              SplineKind kind, Smoothing smoothing, Arcs& arcs);

}  // namespace depixel
