#include "libdepixel/stages/crossings.hpp"

#include <array>
#include <bit>
#include <cstring>

#include "libdepixel/core/simd.hpp"
#include "libdepixel/stages/curve_walk.hpp"

namespace depixel {
namespace {

/// Neighbours, clockwise from north.
constexpr int kSouthEast = 3, kSouthWest = 5;

/// Number of links in a mask of neighbours; a table, as not all processors count bits.
int valence(std::uint8_t neighbours) {
  static constexpr auto kCounts = [] {
    std::array<std::uint8_t, 256> counts{};
    for (unsigned mask = 0; mask < 256; ++mask) counts[mask] = static_cast<std::uint8_t>(std::popcount(mask));
    return counts;
  }();
  return kCounts[neighbours];
}

/// Lengths, in links, of the curves that cross.
class CurveLengths {
 public:
  CurveLengths(const SimilarityGraph& graph, CurveRule rule, CrossingScratch& scratch)
      : graph_(graph),
        walk_(graph.lattice, scratch.neighbours, rule),
        length_(scratch.curve_length),
        measured_(scratch.measured) {
    const std::size_t diagonals = 2 * static_cast<std::size_t>(graph.lattice.size());
    if (length_.size() != diagonals) length_.assign(diagonals, 0);
    measured_.clear();
  }
  CurveLengths(const CurveLengths&) = delete;
  CurveLengths& operator=(const CurveLengths&) = delete;
  /// Forgets all lengths.
  ~CurveLengths() {
    for (const int diagonal : measured_) length_[diagonal] = 0;
  }

  /// Length of the curve through a diagonal link, from one of its pixels; walked once if it is long, then
  /// remembered at all its diagonals that cross others.
  int through(int pixel, int heading) {
    const int known = length_[diagonal(pixel, heading)];
    if (known != 0) return known;
    int total = 0;
    const bool closed = follow(pixel, heading, [&](int, int) { ++total; });
    const int other = pixel + walk_.offset(heading), back = heading ^ 4;
    const int onward = closed ? -1 : walk_.next(pixel, back);
    if (onward >= 0) follow(pixel, onward, [&](int, int) { ++total; });
    if (total < kLongCurve) return total;
    const auto remember = [&](int at, int on) { note(at, on, total); };
    follow(pixel, heading, remember);
    if (!closed) follow(other, back, remember);
    return total;
  }

 private:
  /// Shorter curves are sooner walked again than remembered.
  static constexpr int kLongCurve = 8;

  /// Follows a curve from a pixel to its end or back to the link that it starts with.
  /// \param visit  called with each link: the pixel it leaves, and its heading. \return whether it is closed.
  template <typename Visit>
  bool follow(int pixel, int heading, Visit visit) const {
    int at = pixel, on = heading;
    do {
      visit(at, on);
      at += walk_.offset(on);
      on = walk_.next(at, on);
    } while (on >= 0 && (at != pixel || on != heading));
    return on >= 0;
  }

  void note(int pixel, int heading, int length) {
    const int block = diagonal_block(pixel, heading, graph_.lattice.stride());
    if (block < 0 || (graph_.links[block] & kBothDiagonals) != kBothDiagonals) return;
    const int noted = diagonal(pixel, heading);
    length_[noted] = length;
    measured_.push_back(noted);
  }

  /// Index of a diagonal link's length.
  int diagonal(int pixel, int heading) const {
    const int is_main = heading >> 1 & 1;  // towards south-east and north-west
    return 2 * diagonal_block(pixel, heading, graph_.lattice.stride()) + is_main;
  }

  const SimilarityGraph& graph_;
  CurveWalk walk_;
  std::vector<int>&length_, &measured_;
};

static_assert(std::endian::native == std::endian::little, "rows of links are read as little-endian words");

/// A set of pixels of an 8x8 window: bit 8 * row + column.
using Window = std::uint64_t;

/// The links of the 8x8 window centred on a block that stay inside it, by the pixel they leave to the east,
/// south, south-east, and (from the north-east pixel) south-west.
struct WindowLinks {
  Window east, south, south_east, south_west;
};

/// Entries of the cache of windows; a power of two.
constexpr std::size_t kCachedWindows = 512;

constexpr Window kColumn = 0x0101010101010101;
constexpr Window kAllButLastColumn = ~(kColumn << 7);
constexpr Window kAllButLastRow = ~Window{0} >> 8;

/// The BlockLink masks of the 8x8 window centred on a block, eight bytes a row.
std::array<Window, 8> window_rows(const SimilarityGraph& graph, int block) {
  const int stride = graph.lattice.stride();
  std::array<Window, 8> rows;
  const std::uint8_t* first = graph.links.data() + block - 3 * stride - 3;
  for (Window& row : rows) {
    std::memcpy(&row, first, sizeof row);
    first += stride;
  }
  return rows;
}

/// Compared two rows at a time: arrays would be compared by a call.
bool are_equal(const std::array<Window, 8>& a, const std::array<Window, 8>& b) {
  Byte16 differing{};
  for (int row = 0; row < 8; row += 2) {
    differing |= load_vector<Byte16>(&a[row]) ^ load_vector<Byte16>(&b[row]);
  }
  return is_zero(differing);
}

/// Two rows are mixed in side by side: each multiplication waits for the one before.
Window hash_of(const std::array<Window, 8>& rows) {
  constexpr Window kScramble = 0x9e3779b97f4a7c15;
  Window even = 0, odd = 0;
  for (int row = 0; row < 8; row += 2) {
    even = (even ^ rows[row]) * kScramble;
    odd = (odd ^ rows[row + 1]) * kScramble;
  }
  return (even ^ std::rotl(odd, 32)) * kScramble;
}

WindowLinks window_links(const std::array<Window, 8>& rows) {
  std::array<Window, 4> links{};  // by bit of BlockLink
  for (int row = 0; row < 8; row += 2) {
    const auto two_rows = load_vector<Byte16>(&rows[row]);
    for (int bit = 0; bit < 4; ++bit) links[bit] |= Window{gather_bits(two_rows, bit)} << 8 * row;
  }
  return {links[0] & kAllButLastColumn, links[1] & kAllButLastRow,
          links[2] & kAllButLastColumn & kAllButLastRow, links[3] & kAllButLastColumn & kAllButLastRow};
}

/// Two sets of pixels that are flooded together.
using WindowPair = std::uint64_t __attribute__((vector_size(16)));

/// Pixels connected to each of two seeds inside the window.
WindowPair flood(const WindowLinks& links, WindowPair seeds) {
  for (WindowPair filled = seeds;; seeds = filled) {
    filled |= (filled & links.east) << 1 | (filled >> 1 & links.east);
    filled |= (filled & links.south) << 8 | (filled >> 8 & links.south);
    filled |= (filled & links.south_east) << 9 | (filled >> 9 & links.south_east);
    filled |= (filled >> 1 & links.south_west) << 8 | (filled >> 8 & links.south_west) << 1;
    const WindowPair grown = filled ^ seeds;
    if ((grown[0] | grown[1]) == 0) return filled;
  }
}

/// Sizes of the two components that cross at a block, in the window round it; from the cache if the same
/// window was seen before.
const WindowCacheEntry& component_sizes(const SimilarityGraph& graph, int block,
                                        std::vector<WindowCacheEntry>& cache) {
  constexpr Window kNorthWest = Window{1} << (8 * 3 + 3), kNorthEast = kNorthWest << 1;
  const std::array<Window, 8> rows = window_rows(graph, block);
  WindowCacheEntry& entry = cache[hash_of(rows) >> 32 & (cache.size() - 1)];
  if (entry.main_size == 0 || !are_equal(entry.rows, rows)) {
    const WindowPair components = flood(window_links(rows), WindowPair{kNorthWest, kNorthEast});
    entry = {rows, std::popcount(components[0]), std::popcount(components[1])};
  }
  return entry;
}

/// Calls visit(block) for every crossing, in raster order; looks at eight blocks at a glance.
template <typename Visit>
void for_each_crossing(const SimilarityGraph& graph, Visit visit) {
  const int size = graph.lattice.size();
  for (int i = 0; i + 8 <= size; i += 8) {
    Window bytes;
    std::memcpy(&bytes, graph.links.data() + i, sizeof bytes);
    if ((bytes >> 2 & bytes >> 3 & kColumn) == 0) continue;
    for (int block = i; block < i + 8; ++block) {
      if ((graph.links[block] & kBothDiagonals) == kBothDiagonals && graph.is_crossing(block)) visit(block);
    }
  }
}

/// What is cut at each of the crossings in `scratch`, by votes on the frozen graph.
void cast_votes(const SimilarityGraph& frozen, const CrossingVotes& votes, CrossingScratch& scratch) {
  const int stride = frozen.lattice.stride();
  scratch.cut.resize(scratch.crossings.size());
  scratch.windows.resize(kCachedWindows);
  const auto valence_of = [&](int pixel) { return valence(scratch.neighbours[pixel]); };
  CurveLengths curves(frozen, votes.curve_rule, scratch);
  for (std::size_t c = 0; c < scratch.crossings.size(); ++c) {
    const int nw = scratch.crossings[c], ne = nw + 1, sw = nw + stride, se = sw + 1;
    const WindowCacheEntry& sizes = component_sizes(frozen, nw, scratch.windows);
    const int nw_valence = valence_of(nw), se_valence = valence_of(se);
    const int ne_valence = valence_of(ne), sw_valence = valence_of(sw);
    const int main_length = curves.through(nw, kSouthEast), anti_length = curves.through(ne, kSouthWest);
    const int main_island = nw_valence == 1 || se_valence == 1 ? 1 : 0;
    const int anti_island = ne_valence == 1 || sw_valence == 1 ? 1 : 0;
    const double for_main = votes.curve * (main_length - anti_length) +
                            votes.sparse * (sizes.anti_size - sizes.main_size) +
                            votes.island * (main_island - anti_island);
    scratch.cut[c] = for_main > 0 ? kAntiDiagonal : for_main < 0 ? kMainDiagonal : kBothDiagonals;
  }
}

}  // namespace

int resolve_crossings(SimilarityGraph& graph, const CrossingVotes& votes, CrossingScratch& scratch) {
  find_neighbours(graph, scratch.neighbours);
  scratch.crossings.clear();
  for_each_crossing(graph, [&](int block) { scratch.crossings.push_back(block); });
  if (scratch.crossings.empty()) return 0;
  cast_votes(graph, votes, scratch);
  for (std::size_t c = 0; c < scratch.crossings.size(); ++c) {
    graph.links[scratch.crossings[c]] &= static_cast<std::uint8_t>(~scratch.cut[c]);
  }
  return static_cast<int>(scratch.crossings.size());
}

void resolve_some_crossings(const SimilarityGraph& frozen, std::span<const int> blocks,
                            const CrossingVotes& votes, CrossingScratch& scratch,
                            std::vector<std::uint8_t>& links) {
  if (blocks.empty()) return;
  scratch.crossings.assign(blocks.begin(), blocks.end());
  cast_votes(frozen, votes, scratch);
  for (std::size_t c = 0; c < scratch.crossings.size(); ++c) {
    const int block = scratch.crossings[c];
    links[block] = frozen.links[block] & static_cast<std::uint8_t>(~scratch.cut[c]);
  }
}

}  // namespace depixel
