#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/stages/components.hpp"
#include "libdepixel/stages/similarity_graph.hpp"

namespace depixel {

/// How visible edges pass through a lattice corner, in one byte: which of its four edges are visible (bits 0
/// to 3, by Direction), how they are paired (two bits) and whether the corner is cut (the block has a
/// diagonal link, so the cell corner is split in two nodes).
class CornerCode {
 public:
  enum Pairing : std::uint8_t { kOpposite = 0, kNorthEast = 1, kNorthWest = 2 };

  constexpr CornerCode() = default;
  constexpr explicit CornerCode(std::uint8_t bits) : bits_(bits) {}
  constexpr CornerCode(int visible_edges, Pairing pairing, bool cut)
      : bits_(static_cast<std::uint8_t>(visible_edges | pairing << 4 | (cut ? kCutBit : 0))) {}

  constexpr std::uint8_t bits() const { return bits_; }
  constexpr int visible_edges() const { return bits_ & 15; }
  constexpr bool is_visible(Direction d) const { return bits_ >> d & 1; }
  constexpr Pairing pairing() const { return static_cast<Pairing>(bits_ >> 4 & 3); }
  constexpr bool is_cut() const { return bits_ & kCutBit; }
  /// True where four visible edges meet in one point.
  constexpr bool is_junction_of_four() const { return (bits_ & (kCutBit | 15)) == 15; }
  /// The direction that an edge is joined to: with kOpposite N-S and E-W, with kNorthEast N-E and S-W, with
  /// kNorthWest N-W and S-E.
  constexpr Direction partner(Direction d) const {
    constexpr std::array<std::array<Direction, 4>, 3> kPartner{
        {{kSouth, kWest, kNorth, kEast}, {kEast, kNorth, kWest, kSouth}, {kWest, kSouth, kEast, kNorth}}};
    return kPartner[pairing()][d];
  }
  /// True where an edge is visible and the edge it is paired with is not: a contour ends here.
  constexpr bool ends(Direction d) const { return is_visible(d) && !is_visible(partner(d)); }

  /// Where the node that an edge leaves from lies, in quarter pixels from the lattice corner.
  /// Source: spec, "Cells (figure 32)".
  constexpr glm::ivec2 node_quarters(Direction d) const {
    if (!is_cut()) return {0, 0};
    return kStep[d] + kStep[partner(d)];
  }

  static constexpr std::uint8_t kCutBit = 0x40;

 private:
  std::uint8_t bits_ = 0;
};

/// The simplified cell graph: every lattice corner's code, and every pixel's own colour as drawn.
struct CellGraph {
  Lattice lattice;
  std::vector<CornerCode> corners;  ///< padded, by corner index; 0 where nothing passes
  std::vector<Rgba> colours;        ///< padded, by pixel: what its cell is painted with

  /// True at inner corners where three visible edges meet: one contour ends on another.
  bool is_t_junction(int corner) const {
    const int edges = corners[corner].visible_edges();
    return edges == 7 || edges == 11 || edges == 13 || edges == 14;
  }
  /// True where four visible edges meet in one point.
  bool is_junction_of_four(int corner) const { return corners[corner].is_junction_of_four(); }

  /// Makes room for another size of picture; where it stays, so does all that the arrays hold.
  void resize(const Lattice& size) {
    if (lattice == size && !corners.empty()) return;
    corners.assign(size.size(), CornerCode{});
    colours.assign(size.size(), Rgba{});
    lattice = size;
  }
  std::size_t memory_bytes() const { return held_bytes(corners, colours); }
};

/// Builds the simplified cell graph and finds its visible edges (stage 3 of 6). T-junctions pair their two
/// sharp contours where the third is a shading contour, else the opposite ones; junctions of four pair
/// opposite edges. The picture's border is not among the edges: a contour that reaches it ends there.
/// \param graph       resolved: no two links cross.
/// \param components  labels with colours when cells of one
/// component may differ in colour (merging, connected
///                    lines); nullptr with exact similarity, where linked cells are equal and others differ.
/// Source: Schapfel, sections 4.3 and 4.4; Kopf and Lischinski 2011, section 3.3.
void build_cell_graph(const SimilarityGraph& graph, const Components* components, CellGraph& cells);

/// The two parts of it: the colours of all cells; and the codes of some corners of a row of corners y, of 0
/// .. height: from .. to - 1, of 0 .. width, and maybe of some more. A corner's code depends on the resolved
/// links of its block and of the blocks to its east and south, and on the colours of its four pixels (or
/// their components).
void paint_cells(const SimilarityGraph& graph, const Components* components, CellGraph& cells);
void encode_corners(const SimilarityGraph& graph, const Components* components, int y, int from, int to,
                    CellGraph& cells);

}  // namespace depixel
