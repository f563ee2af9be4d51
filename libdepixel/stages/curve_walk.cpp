#include "libdepixel/stages/curve_walk.hpp"

#include <bit>

#include "libdepixel/stages/similarity_graph.hpp"

namespace depixel {
namespace {

/// Neighbours along sides, and those across corners.
constexpr unsigned kSideLinks = 0b0101'0101, kDiagonalLinks = 0b1010'1010;

constexpr bool has(unsigned links, int neighbour) {
  return (links >> (neighbour & 7) & 1) != 0;
}

/// The link that leads on most nearly in the direction `heading`, bending by 45 degrees at most; -1 if there
/// is none, or if it could bend either way.
constexpr int straightest(unsigned links, int heading) {
  if (has(links, heading)) return heading & 7;
  const bool left = has(links, heading - 1), right = has(links, heading + 1);
  return left == right ? -1 : (heading + (left ? -1 : 1)) & 7;
}

/// The link that one by which a curve comes goes on in.
constexpr int continuation(unsigned links, int heading, CurveRule rule) {
  const int valence = std::popcount(links), back = (heading + 4) & 7;
  if (!has(links, back)) return -1;
  if (valence == 2) return std::countr_zero(links & ~(1U << back));
  if (valence < 2 || valence > CurveWalk::most_links(rule)) return -1;
  const int onward = straightest(links, heading);
  return onward >= 0 && straightest(links, onward + 4) == back ? onward : -1;
}

constexpr CurveWalk::Continuations continuations(CurveRule rule) {
  CurveWalk::Continuations table{};
  for (unsigned links = 0; links < table.size(); ++links) {
    for (int heading = 0; heading < 8; ++heading) {
      table[links][heading] = static_cast<std::int16_t>(continuation(links, heading, rule));
    }
  }
  return table;
}

constexpr CurveWalk::Continuations kByValence = continuations(CurveRule::valence),
                                   kByContinuity = continuations(CurveRule::continuity);

}  // namespace

CurveWalk::CurveWalk(const Lattice& lattice, const std::vector<std::uint8_t>& neighbours, CurveRule rule)
    : neighbours_(neighbours),
      offsets_(neighbour_offsets(lattice)),
      continuations_(rule == CurveRule::continuity ? &kByContinuity : &kByValence) {}

bool CurveWalk::joins_lines(int pixel, std::uint8_t links) const {
  return !is_in_area(pixel, links) && !is_in_dither(pixel, links);
}

/// Whether two sides of a square that meet at the pixel are links, and a third one is, too.
bool CurveWalk::is_in_area(int pixel, std::uint8_t links) const {
  for (int side = 0; side < 8; side += 2) {
    const int other = (side + 2) & 7;
    if (!has(links, side) || !has(links, other)) continue;
    if (has(neighbours_[pixel + offsets_[side]], other) || has(neighbours_[pixel + offsets_[other]], side)) {
      return true;
    }
  }
  return false;
}

bool CurveWalk::is_in_dither(int pixel, std::uint8_t links) const {
  if ((links & kSideLinks) != 0) return false;
  for (unsigned left = links & kDiagonalLinks; left != 0; left &= left - 1) {
    const std::uint8_t around = neighbours_[pixel + offsets_[std::countr_zero(left)]];
    if ((around & kSideLinks) == 0 && std::popcount(around) > 2) return true;
  }
  return false;
}

}  // namespace depixel
