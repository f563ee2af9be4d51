#include "libdepixel/stages/pixel_marks.hpp"

#include <array>
#include <bit>

#include "libdepixel/core/simd.hpp"

namespace depixel {
namespace {

/// Sets all other marks to none.
void mark_thin_lines(const SimilarityGraph& graph, int y, int from, int to, std::vector<PixelMarks>& marks) {
  PixelMarks* row = marks.data() + graph.lattice.pixel(0, y);
  const auto beyond = load_vector<Byte16>(row + to);  // is written over
  find_neighbours(graph, y, from, to, marks);
  for (int x = from; x < to; x += sizeof(Byte16)) {
    const auto links = load_vector<Byte16>(row + x);
    const Byte16 but_one = links & (links - 1), but_two = but_one & (but_one - 1);
    const Byte16 triangles = links & ((links << 1) | (links >> 7));
    store_vector(row + x, reinterpret_cast<Byte16>((but_two | triangles) == 0) & kThinLine);
  }
  store_vector(row + to, beyond);
}

/// Pixels that a stroke is wide at most, and the length from which on one is a bar.
constexpr int kWidestStroke = 3, kShortestBar = 3;
/// How far text reaches from a bar, along either axis.
constexpr int kTextReach = 4;

/// What a pixel is of strokes across an axis. \param across, along  index offsets along the axis and the
/// other.
PixelMarks stroke_marks(const Rgba* pixel, int across, int along) {
  int before = 1, after = 1;
  while (before <= kWidestStroke && pixel[-before * across] == *pixel) ++before;
  while (after <= kWidestStroke && pixel[after * across] == *pixel) ++after;
  const bool is_stroke =
      before + after - 1 <= kWidestStroke && pixel[-before * across] == pixel[after * across];
  if (!is_stroke) return 0;
  const auto has_same = [&](int offset) {
    for (int i = -before; i <= after; ++i) {
      if (pixel[offset + i * across] != pixel[i * across]) return false;
    }
    return true;
  };
  int length = 1;
  for (const int step : {along, -along}) {
    for (int i = 1; i < kShortestBar && has_same(i * step); ++i) ++length;
  }
  return length >= kShortestBar ? kStroke | kBar : kStroke;
}

bool is_near_bar(const SimilarityGraph& graph, const std::vector<PixelMarks>& marks, int pixel) {
  const int stride = graph.lattice.stride();
  for (int y = -kTextReach; y <= kTextReach; ++y) {
    for (int i = pixel + y * stride - kTextReach, end = i + 2 * kTextReach; i <= end; ++i) {
      if ((marks[i] & kBar) != 0 && graph.pixels[i] == graph.pixels[pixel]) return true;
    }
  }
  return false;
}

}  // namespace

void mark_lines(const SimilarityGraph& graph, bool text_safe, int y, int from, int to,
                std::vector<PixelMarks>& marks) {
  mark_thin_lines(graph, y, from, to, marks);
  if (!text_safe) return;
  const int first = graph.lattice.pixel(0, y), stride = graph.lattice.stride();
  for (int i = first + from; i < first + to; ++i) {
    const Rgba* pixel = graph.pixels.data() + i;
    marks[i] |= stroke_marks(pixel, 1, stride) | stroke_marks(pixel, stride, 1);
  }
}

void mark_text(const SimilarityGraph& graph, int y, int from, int to, std::vector<PixelMarks>& marks) {
  const int first = graph.lattice.pixel(0, y);
  for (int i = first + from; i < first + to; ++i) {
    if ((marks[i] & kStroke) != 0 && is_near_bar(graph, marks, i)) marks[i] |= kText;
  }
}

void find_pixel_marks(const SimilarityGraph& graph, bool text_safe, std::vector<PixelMarks>& marks) {
  const Lattice& lattice = graph.lattice;
  marks.assign(lattice.size() + sizeof(Byte16), 0);
  for (int y = 0; y < lattice.height(); ++y) mark_lines(graph, text_safe, y, 0, lattice.width(), marks);
  if (!text_safe) return;
  for (int y = 0; y < lattice.height(); ++y) mark_text(graph, y, 0, lattice.width(), marks);
}

}  // namespace depixel
