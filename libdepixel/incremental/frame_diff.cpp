#include "libdepixel/incremental/frame_diff.hpp"

#include <cstring>

#include "libdepixel/core/normalized_pixels.hpp"

namespace depixel {
namespace {

Rgba pixel_at(const std::uint8_t* row, int x) {
  Rgba pixel;
  std::memcpy(&pixel, row + sizeof(Rgba) * x, sizeof pixel);
  return normalized(pixel);
}

/// Whether four pixels of a frame are the known ones.
bool are_known(const std::uint8_t* row, const Rgba* known, int x) {
  const Word4 differing = load_normalized(row + sizeof(Rgba) * x) ^ load_vector<Word4>(known + x);
  std::array<std::uint64_t, 2> halves;
  std::memcpy(halves.data(), &differing, sizeof differing);
  return (halves[0] | halves[1]) == 0;
}

Span changed_part(const std::uint8_t* row, const Rgba* known, int width) {
  int from = 0;
  while (from + kWordLanes <= width && are_known(row, known, from)) from += kWordLanes;
  while (from < width && pixel_at(row, from) == known[from]) ++from;
  if (from == width) return {};
  int to = width;
  while (to - kWordLanes >= from && are_known(row, known, to - kWordLanes)) to -= kWordLanes;
  while (pixel_at(row, to - 1) == known[to - 1]) --to;
  return {from, to};
}

/// Copies a part of a row. \return how many pixels differed.
int take_over(const std::uint8_t* row, Rgba* known, Span span) {
  int x = span.from;
  Word4 counts{};
  for (; x + kWordLanes <= span.to; x += kWordLanes) {
    const Word4 four = load_normalized(row + sizeof(Rgba) * x);
    counts -= reinterpret_cast<Word4>(four != load_vector<Word4>(known + x));
    store_vector(known + x, four);
  }
  auto count = static_cast<int>(counts[0] + counts[1] + counts[2] + counts[3]);
  for (; x < span.to; ++x) {
    count += pixel_at(row, x) == known[x] ? 0 : 1;
    known[x] = pixel_at(row, x);
  }
  return count;
}

}  // namespace

void find_changed_pixels(const FrameView& frame, const SimilarityGraph& graph, RowSpans& changed) {
  changed.reset(frame.height);
  for (int y = 0; y < frame.height; ++y) {
    const std::uint8_t* row = frame.pixels + y * frame.pitch;
    const Rgba* known = graph.pixels.data() + graph.lattice.pixel(0, y);
    if (std::memcmp(row, known, sizeof(Rgba) * frame.width) == 0) continue;
    changed.set(y, changed_part(row, known, frame.width));
  }
}

int take_changed_pixels(const FrameView& frame, const RowSpans& changed, SimilarityGraph& graph) {
  int count = 0;
  for (int y = 0; y < frame.height; ++y) {
    if (changed.is_empty(y)) continue;
    count += take_over(frame.pixels + y * frame.pitch, graph.pixels.data() + graph.lattice.pixel(0, y),
                       changed[y]);
  }
  return count;
}

}  // namespace depixel
