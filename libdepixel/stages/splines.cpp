#include "libdepixel/stages/splines.hpp"

#include <algorithm>
#include <cstdlib>

namespace depixel {
namespace {

/// Arcs are handled in batches of about this many entries, which stay in the first-level cache.
constexpr int kBatchEntries = 512;

void retract(EdgeCurve& curve, bool southwards) {
  curve.p1 = curve.p2 = southwards ? glm::i16vec2(0, kSubpixels / 2) : glm::i16vec2(kSubpixels / 2, 0);
}

glm::vec2 to_pixels(glm::i16vec2 subpixels) {
  return glm::vec2(subpixels) / static_cast<float>(kSubpixels);
}

/// Quick test for a curve along an edge: all its points in the strip between the centres on both sides.
bool is_in_strip(const EdgeCurve& curve, bool southwards) {
  constexpr int kHalfWidth = kSubpixels / 2 - kCentreClearance - 2;
  const int across = southwards ? 0 : 1;
  return std::abs(curve.p0[across]) <= kHalfWidth && std::abs(curve.p1[across]) <= kHalfWidth &&
         std::abs(curve.p2[across]) <= kHalfWidth && std::abs(curve.p3[across]) <= kHalfWidth;
}

}  // namespace

void SplineFitter::fit(std::span<const ArcShape> shapes, const Options& options) {
  batch_.clear();
  std::size_t first = 0;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    placer_.add(shapes[i].words, shapes[i].kind, options, static_cast<int>(i - first), batch_);
    if (batch_.size < kBatchEntries) continue;
    fit_batch(shapes.subspan(first), options);
    first = i + 1;
  }
  fit_batch(shapes.subspan(first), options);
}

void SplineFitter::fit_batch(std::span<const ArcShape> shapes, const Options& options) {
  if (batch_.members.empty()) return;
  batch_.settle();
  if (options.smoothing == Smoothing::energy) minimize_energy(batch_, smoothing_);
  interpolate_nodes(batch_, interpolation_);
  if (options.smoothing == Smoothing::average) average_control_points(batch_, smoothing_);
  corridor_.keep_clear(batch_, retracted_);
  curves_.compute(batch_, retracted_);
  for (const ArcBatch::Member& member : batch_.members) {
    const ArcShape& shape = shapes[member.source];
    for (int k = 0; k < member.step_count(); ++k) {
      shape.curves[k] = curves_.curve(member.first + k);
      shape.tiles[k] = curves_.tiles(member.first + k);
    }
  }
  batch_.clear();
}

EdgeCurve join(const EdgeCurve& curve, bool southwards, glm::i16vec2 p0, glm::i16vec2 p3) {
  EdgeCurve joined{p0, curve.p1, curve.p2, p3};
  if (is_in_strip(joined, southwards)) return joined;
  const std::array<glm::vec2, 4> points{to_pixels(joined.p0), to_pixels(joined.p1), to_pixels(joined.p2),
                                        to_pixels(joined.p3)};
  if (!is_clear(points, southwards ? kSouth : kEast)) retract(joined, southwards);
  return joined;
}

}  // namespace depixel
