#include "libdepixel/incremental/stale_crossings.hpp"

#include <array>
#include <bit>

#include "libdepixel/incremental/byte_rows.hpp"

namespace depixel {
namespace {

/// Whether a pixel has not just two neighbours.
bool is_end(std::uint8_t neighbours) {
  const int but_one = neighbours & (neighbours - 1);
  return but_one == 0 || (but_one & (but_one - 1)) != 0;
}

/// The block in which a diagonal link from a pixel lies; -1 for links along sides.
int diagonal_block(int pixel, int neighbour, int stride) {
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

}  // namespace

const std::vector<int>& StaleCrossings::find(const SimilarityGraph& frozen, const BlockSet& near,
                                             std::span<const int> seams, RuleSet rules,
                                             std::vector<std::uint8_t>& neighbours) {
  forget(frozen.lattice);
  for (int y = 0; y < frozen.lattice.height(); ++y) {
    if (!near.runs(y).empty()) find_in_row(frozen, near, y, rules, neighbours);
  }
  if (rules.has(Rule::crossings_by_curves)) {
    for (const int pixel : changed_pixels_) follow_curves(frozen, pixel, neighbours);
  }
  if (rules.has(Rule::crossings_by_seams)) {
    for (const int pixel : seams) follow_curves(frozen, pixel, neighbours);
  }
  return stale_;
}

void StaleCrossings::forget(const Lattice& lattice) {
  for (const int block : stale_) is_stale_[block] = 0;
  for (const int pixel : visited_) is_visited_[pixel] = 0;
  stale_.clear();
  visited_.clear();
  changed_pixels_.clear();
  if (static_cast<int>(is_stale_.size()) == lattice.size()) return;
  is_stale_.assign(lattice.size(), 0);
  is_visited_.assign(lattice.size(), 0);
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
                                   const std::vector<std::uint8_t>& neighbours) {
  const int stride = frozen.lattice.stride();
  const std::array<int, 8> offsets = neighbour_offsets(frozen.lattice);
  for (unsigned links = neighbours[pixel]; links != 0; links &= links - 1) {
    int at = pixel, neighbour = std::countr_zero(links);
    for (;;) {
      const int block = diagonal_block(at, neighbour, stride);
      if (block >= 0 && (frozen.links[block] & kBothDiagonals) == kBothDiagonals) add(frozen, block);
      at += offsets[neighbour];
      if (is_end(neighbours[at]) || is_visited_[at] != 0) break;
      is_visited_[at] = 1;
      visited_.push_back(at);
      const auto back = static_cast<unsigned>(1 << ((neighbour + 4) & 7));
      neighbour = std::countr_zero(neighbours[at] & ~back);
    }
  }
}

}  // namespace depixel
