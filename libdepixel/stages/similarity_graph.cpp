#include "libdepixel/stages/similarity_graph.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

#include "libdepixel/core/normalized_pixels.hpp"
#include "libdepixel/core/simd.hpp"
#include "libdepixel/stages/components.hpp"

namespace depixel {
namespace {

/// Equal colours of four blocks from `row` on, as BlockLink masks; frozen if asked for: a block of four equal
/// pixels keeps its sides alone. (Equality is transitive, so three equal pixels in a block would be four.)
template <bool kFreeze>
Word4 exact_links(const Rgba* row, int stride) {
  const auto nw = load_vector<Word4>(row), ne = load_vector<Word4>(row + 1);
  const auto sw = load_vector<Word4>(row + stride), se = load_vector<Word4>(row + stride + 1);
  const auto equal = [](Word4 a, Word4 b) -> Word4 { return a == b; };
  const Word4 links = (equal(nw, ne) & kNorthSide) | (equal(nw, sw) & kWestSide) |
                      (equal(nw, se) & kMainDiagonal) | (equal(ne, sw) & kAntiDiagonal);
  if constexpr (!kFreeze) return links;
  constexpr std::uint32_t kAll = kNorthSide | kWestSide | kBothDiagonals;
  return links & ~(equal(links, Word4{} + kAll) & kBothDiagonals);
}

/// A row of blocks, sixteen at a time; may write up to fifteen entries beyond the row, into the padding.
template <bool kFreeze>
void link_exact_row(const Rgba* row, int stride, int count, std::uint8_t* links) {
  constexpr int kAtOnce = sizeof(Byte16);
  for (int x = 0; x < count; x += kAtOnce) {
    const auto four = [&](int k) { return exact_links<kFreeze>(row + x + k * kWordLanes, stride); };
    store_vector(links + x, pack_words(four(0), four(1), four(2), four(3)));
  }
}

void link_similar_row(const Rgba* row, int stride, int count, int max_y, std::uint8_t* links) {
  const auto similar = [max_y](Rgba p, Rgba q) { return similar_yuv(p, q, max_y); };
  for (int x = 0; x < count; ++x) {
    const Rgba nw = row[x], ne = row[x + 1], sw = row[x + stride], se = row[x + stride + 1];
    links[x] = static_cast<std::uint8_t>(kNorthSide * similar(nw, ne) | kWestSide * similar(nw, sw) |
                                         kMainDiagonal * similar(nw, se) | kAntiDiagonal * similar(ne, sw));
  }
}

/// Links a part of a row of blocks, and cuts the links that would leave the frame.
template <typename LinkRow>
void link_part(const SimilarityGraph& graph, int y, int from, int to, LinkRow link_row,
               std::vector<std::uint8_t>& all_links) {
  constexpr int kBeyond = sizeof(Byte16) - 1;  // entries that may be written beyond the part
  const Lattice& lattice = graph.lattice;
  const int width = lattice.width(), first = lattice.pixel(0, y);
  std::uint8_t* links = all_links.data() + first;
  link_row(graph.pixels.data() + first + from, lattice.stride(), to - from, links + from);
  if (to + kBeyond >= width) {
    links[width - 1] &= kWestSide;
    std::fill_n(links + width, kBeyond, std::uint8_t{0});
  }
  if (y + 1 < lattice.height()) return;
  for (int x = from; x < std::min(to + kBeyond, width); ++x) links[x] &= kNorthSide;
}

template <typename LinkRow>
void link_all(const SimilarityGraph& graph, LinkRow link_row, std::vector<std::uint8_t>& links) {
  const Lattice& lattice = graph.lattice;
  for (int y = 0; y < lattice.height(); ++y) link_part(graph, y, 0, lattice.width(), link_row, links);
}

void freeze_merged(SimilarityGraph& graph) {
  const Lattice& lattice = graph.lattice;
  for (int y = 0; y < lattice.height(); ++y) {
    for (int i = lattice.pixel(0, y), end = i + lattice.width(); i < end; ++i) {
      if (graph.side_count(i) >= 3) graph.links[i] &= static_cast<std::uint8_t>(~kBothDiagonals);
    }
  }
}

/// Joins two components of valence <= 2 throughout across a diagonal when their colours are near.
void connect_line_components(SimilarityGraph& graph) {
  const Lattice& lattice = graph.lattice;
  Components components;
  label_components(graph, components);
  std::vector<std::uint8_t> is_line(components.count, 1);
  for (int y = 0; y < lattice.height(); ++y) {
    for (int x = 0; x < lattice.width(); ++x) {
      const int p = lattice.pixel(x, y);
      if (std::popcount(graph.neighbours(p)) > 2) is_line[components.label[p]] = 0;
    }
  }
  const auto joins = [&](int p, int q) {
    const int a = components.label[p], b = components.label[q];
    return a != b && is_line[a] && is_line[b] && near_yuv(graph.pixels[p], graph.pixels[q]);
  };
  for (int y = 0; y + 1 < lattice.height(); ++y) {
    for (int x = 0; x + 1 < lattice.width(); ++x) {
      const int block = lattice.pixel(x, y), below = block + lattice.stride();
      if (joins(block, below + 1)) graph.links[block] |= kMainDiagonal;
      if (joins(block + 1, below)) graph.links[block] |= kAntiDiagonal;
    }
  }
}

}  // namespace

std::uint8_t SimilarityGraph::neighbours(int pixel) const {
  const int stride = lattice.stride();
  const auto bit = [&](int block, int link) { return (links[block] & link) != 0 ? 1 : 0; };
  return static_cast<std::uint8_t>(
      bit(pixel - stride, kWestSide) | bit(pixel - stride, kAntiDiagonal) << 1 | bit(pixel, kNorthSide) << 2 |
      bit(pixel, kMainDiagonal) << 3 | bit(pixel, kWestSide) << 4 | bit(pixel - 1, kAntiDiagonal) << 5 |
      bit(pixel - 1, kNorthSide) << 6 | bit(pixel - stride - 1, kMainDiagonal) << 7);
}

void find_neighbours(const SimilarityGraph& graph, int y, int from, int to,
                     std::vector<std::uint8_t>& masks) {
  const int first = graph.lattice.pixel(0, y);
  const std::uint8_t* here = graph.links.data() + first;
  const std::uint8_t* above = here - graph.lattice.stride();
  for (int x = from; x < to; x += sizeof(Byte16)) {  // may write into the padding
    const auto h = load_vector<Byte16>(here + x), a = load_vector<Byte16>(above + x);
    const auto w = load_vector<Byte16>(here + x - 1), aw = load_vector<Byte16>(above + x - 1);
    const Byte16 mask = ((a >> 1) & 1) | ((a >> 2) & 2) | ((h << 2) & 4) | ((h << 1) & 8) | ((h << 3) & 16) |
                        ((w << 2) & 32) | ((w << 6) & 64) | ((aw << 5) & 128);
    store_vector(masks.data() + first + x, mask);
  }
}

void find_neighbours(const SimilarityGraph& graph, std::vector<std::uint8_t>& masks) {
  masks.resize(graph.lattice.size() + sizeof(Byte16));
  for (int y = 0; y < graph.lattice.height(); ++y) {
    find_neighbours(graph, y, 0, graph.lattice.width(), masks);
  }
}

void take_pixels(const FrameView& frame, int y, int from, int to, SimilarityGraph& graph) {
  take_normalized(frame.pixels + y * frame.pitch + std::ptrdiff_t{sizeof(Rgba)} * from, to - from,
                  graph.pixels.data() + graph.lattice.pixel(from, y));
}

FrameView pixels_of(const SimilarityGraph& graph) {
  const Lattice& lattice = graph.lattice;
  return {reinterpret_cast<const std::uint8_t*>(graph.pixels.data() + lattice.pixel(0, 0)), lattice.width(),
          lattice.height(), std::ptrdiff_t{sizeof(Rgba)} * lattice.stride(), lattice.margin()};
}

std::array<int, 8> neighbour_offsets(const Lattice& lattice) {
  const int s = lattice.stride();
  return {-s, -s + 1, 1, s + 1, s, s - 1, -1, -s - 1};
}

namespace {

void load_frame(const FrameView& frame, SimilarityGraph& graph) {
  assert(frame.width > 0 && frame.height > 0);
  graph.resize(Lattice(frame.width, frame.height, frame.margin));
  for (int y = 0; y < frame.height; ++y) take_pixels(frame, y, 0, frame.width, graph);
}

}  // namespace

void link_exactly(const SimilarityGraph& graph, int y, int from, int to, std::vector<std::uint8_t>& links) {
  link_part(graph, y, from, to, link_exact_row<true>, links);
}

void build_raw_similarity_graph(const FrameView& frame, const LinkCriteria& criteria,
                                SimilarityGraph& graph) {
  load_frame(frame, graph);
  if (criteria.similarity == Similarity::exact) {
    link_all(graph, link_exact_row<false>, graph.links);
  } else {
    const auto link_row = [&](const Rgba* row, int stride, int count, std::uint8_t* links) {
      link_similar_row(row, stride, count, criteria.merge_luma, links);
    };
    link_all(graph, link_row, graph.links);
  }
  if (criteria.connect_lines) connect_line_components(graph);
}

void build_similarity_graph(const FrameView& frame, const LinkCriteria& criteria, SimilarityGraph& graph) {
  if (criteria.similarity == Similarity::exact && !criteria.connect_lines) {
    load_frame(frame, graph);
    link_all(graph, link_exact_row<true>, graph.links);
    return;
  }
  build_raw_similarity_graph(frame, criteria, graph);
  freeze_merged(graph);
}

}  // namespace depixel
