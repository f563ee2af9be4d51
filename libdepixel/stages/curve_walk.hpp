#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "libdepixel/core/lattice.hpp"
#include "libdepixel/core/options.hpp"

namespace depixel {

/// The block in which a diagonal link from a pixel lies, by the neighbour it leads to; -1 for links along
/// sides.
constexpr int diagonal_block(int pixel, int neighbour, int stride) {
  switch (neighbour) {  // clockwise from north
    case 1:
      return pixel - stride;
    case 3:
      return pixel;
    case 5:
      return pixel - 1;
    case 7:
      return pixel - stride - 1;
    default:
      return -1;
  }
}

/// How curves run through the pixels of a frozen graph: at each pixel some of the links go on in each other,
/// two by two. So a link is part of one curve, whichever way that is followed, and a curve has two ends or is
/// closed.
///
/// CurveRule::valence joins the two links of pixels that have no others. CurveRule::continuity joins,
/// besides, links that go on in each other in the straightest way at junctions of three or four: opposite
/// ones, and others that bend by 45 degrees if neither could bend to a third as well. Pixels of areas, which
/// have three others in a square, join nothing then, nor do those of dithers, where junctions of diagonals
/// lie side by side.
///
/// What is joined at a pixel depends on its links and on the links of the pixels it is linked to.
/// Source: Kopf and Lischinski 2011, section 3.2; Schapfel, sections 4.2 and 7.1.1 (figures 68 to 70).
class CurveWalk {
 public:
  /// \param neighbours  by find_neighbours(), of the frozen graph; must outlive the walk.
  CurveWalk(const Lattice& lattice, const std::vector<std::uint8_t>& neighbours, CurveRule rule);

  /// Links that a pixel has at most where curves run on.
  static constexpr int most_links(CurveRule rule) { return rule == CurveRule::valence ? 2 : 4; }

  int offset(int neighbour) const { return offsets_[neighbour]; }

  /// The neighbour that a curve goes on to at a pixel, or -1 where it ends.
  /// \param heading  of the link by which it comes, as the index of a neighbour clockwise from north.
  int next(int pixel, int heading) const {
    const std::uint8_t links = neighbours_[pixel];
    const int onward = (*continuations_)[links][heading];
    return onward < 0 || is_pair(links) || joins_lines(pixel, links) ? onward : -1;
  }

  /// By mask of neighbours and heading: the neighbour to go on to, or -1.
  using Continuations = std::array<std::array<std::int16_t, 8>, 256>;

 private:
  /// Of masks with at least two bits: whether there are no more.
  static bool is_pair(std::uint8_t links) {
    const int but_one = links & (links - 1);
    return (but_one & (but_one - 1)) == 0;
  }
  bool joins_lines(int pixel, std::uint8_t links) const;
  bool is_in_area(int pixel, std::uint8_t links) const;
  bool is_in_dither(int pixel, std::uint8_t links) const;

  const std::vector<std::uint8_t>& neighbours_;
  std::array<int, 8> offsets_;
  const Continuations* continuations_;
};

}  // namespace depixel
