#include "libdepixel/incremental/stale_crossings.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace depixel {
namespace {

/// A block's window holds the blocks from this far before to this far behind it, along either axis.
constexpr int kBefore = 3, kBehind = 4;

bool is_end(std::uint8_t neighbours) {
  return std::popcount(neighbours) != 2;
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

const std::vector<int>& StaleCrossings::find(const SimilarityGraph& frozen, const RowSpans& changed,
                                             RuleSet rules, std::vector<std::uint8_t>& neighbours) {
  const Lattice& lattice = frozen.lattice;
  for (const int block : stale_) is_stale_[block] = 0;
  for (const int pixel : visited_) is_visited_[pixel] = 0;
  stale_.clear();
  visited_.clear();
  changed_pixels_.clear();
  if (static_cast<int>(is_stale_.size()) != lattice.size()) {
    is_stale_.assign(lattice.size(), 0);
    is_visited_.assign(lattice.size(), 0);
  }
  if (rules.has(Rule::crossings_by_windows)) find_by_windows(frozen, changed);
  for (int y = 0; y < lattice.height(); ++y) {
    // A pixel's links lie in the blocks of its own row and of the one above.
    if (!changed.is_empty(y) || !changed.is_empty(y - 1)) {
      renew_row(frozen, y, rules.has(Rule::crossings_by_curves), neighbours);
    }
  }
  for (const int pixel : changed_pixels_) follow_curves(frozen, pixel, neighbours);
  return stale_;
}

void StaleCrossings::add(const SimilarityGraph& frozen, int block) {
  if (is_stale_[block] != 0 || !frozen.is_crossing(block)) return;
  is_stale_[block] = 1;
  stale_.push_back(block);
}

void StaleCrossings::find_by_windows(const SimilarityGraph& frozen, const RowSpans& changed) {
  const Lattice& lattice = frozen.lattice;
  for (int y = 0; y < lattice.height(); ++y) {
    Span reached;
    for (int other = y - kBefore; other <= y + kBehind; ++other) {
      if (!changed.is_empty(other)) reached = united({reached, changed[other], Span{}});
    }
    if (reached.is_empty()) continue;
    const int from = std::max(0, reached.from - kBehind),
              to = std::min(lattice.width(), reached.to + kBefore);
    const std::uint8_t* row = frozen.links.data() + lattice.pixel(0, y);
    for (int x = from; x < to; ++x) {
      if ((row[x] & kBothDiagonals) == kBothDiagonals) add(frozen, lattice.pixel(x, y));
    }
  }
}

/// Brings a row of neighbours up to date, and keeps the pixels where they differ.
void StaleCrossings::renew_row(const SimilarityGraph& frozen, int y, bool follows,
                               std::vector<std::uint8_t>& neighbours) {
  const int first = frozen.lattice.pixel(0, y), width = frozen.lattice.width();
  const std::uint8_t* row = neighbours.data() + first;
  before_.assign(row, row + width);
  find_neighbours(frozen, y, y + 1, neighbours);
  if (!follows) return;
  const Span span = differing_part(row, before_.data(), width);
  for (int x = span.from; x < span.to; ++x) {
    if (row[x] != before_[x]) changed_pixels_.push_back(first + x);
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
