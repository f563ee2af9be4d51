#include "libdepixel/incremental/stale_crossings.hpp"

#include <bit>

#include "libdepixel/incremental/byte_rows.hpp"

namespace depixel {

const std::vector<int>& StaleCrossings::find(const SimilarityGraph& frozen, const BlockSet& near,
                                             std::span<const int> seams, CurveRule curve_rule, RuleSet rules,
                                             std::vector<std::uint8_t>& neighbours) {
  forget(frozen.lattice);
  for (int y = 0; y < frozen.lattice.height(); ++y) {
    if (!near.runs(y).empty()) find_in_row(frozen, near, y, rules, neighbours);
  }
  const CurveWalk walk(frozen.lattice, neighbours, curve_rule);
  if (rules.has(Rule::crossings_by_curves)) {
    for (const int pixel : changed_pixels_) follow_curves(frozen, pixel, neighbours, walk);
  }
  if (rules.has(Rule::crossings_by_junctions) && curve_rule == CurveRule::continuity) {
    for (const int pixel : changed_pixels_) {
      for (unsigned links = neighbours[pixel]; links != 0; links &= links - 1) {
        follow_curves(frozen, pixel + walk.offset(std::countr_zero(links)), neighbours, walk);
      }
    }
  }
  if (rules.has(Rule::crossings_by_seams)) {
    for (const int pixel : seams) follow_curves(frozen, pixel, neighbours, walk);
  }
  return stale_;
}

void StaleCrossings::forget(const Lattice& lattice) {
  for (const int block : stale_) is_stale_[block] = 0;
  for (const int pixel : visited_) visited_links_[pixel] = 0;
  stale_.clear();
  visited_.clear();
  changed_pixels_.clear();
  if (static_cast<int>(is_stale_.size()) == lattice.size()) return;
  is_stale_.assign(lattice.size(), 0);
  visited_links_.assign(lattice.size(), 0);
}

void StaleCrossings::add(const SimilarityGraph& frozen, int block) {
  if (is_stale_[block] != 0 || !frozen.is_crossing(block)) return;
  is_stale_[block] = 1;
  stale_.push_back(block);
}

/// Adds the crossings of a row of pixels, brings its neighbours up to date, and keeps the pixels where they
/// differ.
void StaleCrossings::find_in_row(const SimilarityGraph& frozen, const BlockSet& near, int y, RuleSet rules,
                                 std::vector<std::uint8_t>& neighbours) {
  const int first = frozen.lattice.pixel(0, y);
  const std::uint8_t *links = frozen.links.data() + first, *masks = neighbours.data() + first;
  for (const BlockSet::Run run : near.runs(y)) {
    const int from = run.from, count = run.to - run.from;
    before_.assign(masks + from, masks + run.to + sizeof(Byte16));
    find_neighbours(frozen, y, from, from + count, neighbours);
    for_each_difference(masks + from, before_.data(), count,
                        [&](int x) { changed_pixels_.push_back(first + from + x); });
    if (!rules.has(Rule::crossings_by_windows)) continue;
    for_each_with_bits(links + from, count, kBothDiagonals, [&](int x) { add(frozen, first + from + x); });
  }
}

/// Follows the curves on from a pixel, in every direction, to their ends. What was part of a curve with the
/// pixel before is still linked to it, or to another pixel whose links changed.
void StaleCrossings::follow_curves(const SimilarityGraph& frozen, int pixel,
                                   const std::vector<std::uint8_t>& neighbours, const CurveWalk& walk) {
  for (unsigned links = neighbours[pixel]; links != 0; links &= links - 1) {
    int at = pixel;
    for (int heading = std::countr_zero(links); heading >= 0 && visit(at, heading);) {
      const int block = diagonal_block(at, heading, frozen.lattice.stride());
      if (block >= 0 && (frozen.links[block] & kBothDiagonals) == kBothDiagonals) add(frozen, block);
      at += walk.offset(heading);
      visit(at, heading ^ 4);  // it need not be followed from its other end
      heading = walk.next(at, heading);
    }
  }
}

/// \return whether a link was not visited before.
bool StaleCrossings::visit(int pixel, int neighbour) {
  const auto link = static_cast<std::uint8_t>(1 << neighbour);
  if ((visited_links_[pixel] & link) != 0) return false;
  if (visited_links_[pixel] == 0) visited_.push_back(pixel);
  visited_links_[pixel] |= link;
  return true;
}

}  // namespace depixel
