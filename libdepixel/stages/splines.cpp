#include "libdepixel/stages/splines.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace depixel {
namespace {

/// Closed contours of fewer nodes are interpolated by the adaptive kind. Source: Schapfel, section 4.6.3.
constexpr int kAdaptiveNodes = 30;

/// Contours are handled in batches of about this many entries, which stay in the first-level cache.
constexpr int kBatchEntries = 512;

bool is_interpolated(SplineKind kind, const Contour& contour) {
  if (kind == SplineKind::adaptive) return contour.closed && contour.count < kAdaptiveNodes;
  return kind == SplineKind::interpolate;
}

/// True for an open contour that runs through junctions of four only: all of its nodes are lattice corners
/// for good.
bool is_pinned(const CellGraph& cells, const Contours& contours, const Contour& contour) {
  if (contour.closed) return false;
  for (int k = contour.first + 1; k < contour.first + contour.count - 1; ++k) {
    if (!cells.is_junction_of_four(contours.corner[k])) return false;
  }
  return true;
}

/// True for a contour round a lone pixel whose four corners are all cut.
bool is_dot(const CellGraph& cells, const Contours& contours, const Contour& contour) {
  if (!contour.closed || contour.count != 4) return false;
  const int* corners = contours.corner.data() + contour.first;
  return std::all_of(corners, corners + 4, [&](int corner) { return cells.corners[corner].is_cut(); });
}

/// What placing, smoothing and fitting make of a dot, of which dithers have thousands: control points on the
/// lattice corners, so the knots are a third of the way from there to the pixel's centre.
void fit_dot(const CellGraph& cells, const Contours& contours, const Contour& contour, Splines& splines) {
  constexpr int kKnot = (kSubpixels + 3) / 6;
  for (int k = contour.first; k < contour.first + contour.count; ++k) {
    const CornerCode code = cells.corners[contours.corner[k]];
    splines.control[k] = glm::ivec2(0);
    splines.knot[k] = code.node_quarters(static_cast<Direction>(contours.heading[k])) * kKnot;
    splines.is_retracted[k] = 0;
  }
}

glm::ivec2 to_subpixels(float x, float y) {
  return {static_cast<int>(std::lrint(x * kSubpixels)), static_cast<int>(std::lrint(y * kSubpixels))};
}

glm::vec2 to_pixels(glm::ivec2 subpixels) {
  return glm::vec2(subpixels) / static_cast<float>(kSubpixels);
}

/// Quick test for a segment of a contour: control points and knots in the strip between the centres on both
/// sides.
bool is_in_strip(const Splines& splines, int segment, Direction heading) {
  constexpr int kHalfWidth = kSubpixels / 2 - kCentreClearance - 2;
  const int axis = kStep[heading].x != 0 ? 1 : 0;
  for (const int node : {segment, segment + 1}) {
    if (std::abs(splines.control[node][axis]) > kHalfWidth ||
        std::abs(splines.knot[node][axis]) > kHalfWidth) {
      return false;
    }
  }
  return true;
}

}  // namespace

void SplineFitter::fit(const SimilarityGraph& graph, const CellGraph& cells, const Contours& contours,
                       SplineKind kind, Smoothing smoothing, Splines& splines) {
  const std::size_t nodes = contours.corner.size();
  splines.control.resize(nodes);
  splines.knot.resize(nodes);
  splines.is_retracted.resize(nodes);
  if (smoothing == Smoothing::energy) find_thin_pixels(graph, thin_);
  placer_.start(cells, contours, thin_);
  batch_.clear();
  for (const Contour& contour : contours.list) {
    if (is_pinned(cells, contours, contour)) {
      std::fill_n(splines.control.begin() + contour.first, contour.count, glm::ivec2(0));
      std::fill_n(splines.knot.begin() + contour.first, contour.count, glm::ivec2(0));
      std::fill_n(splines.is_retracted.begin() + contour.first, contour.count, std::uint8_t{0});
      continue;
    }
    if (smoothing == Smoothing::energy && is_dot(cells, contours, contour)) {
      fit_dot(cells, contours, contour, splines);
      continue;
    }
    placer_.add(contour, smoothing, is_interpolated(kind, contour), batch_);
    if (batch_.size >= kBatchEntries) fit_batch(cells, contours, smoothing, splines);
  }
  fit_batch(cells, contours, smoothing, splines);
  join_t_junctions(cells, contours, splines);
}

void SplineFitter::fit_batch(const CellGraph& cells, const Contours& contours, Smoothing smoothing,
                             Splines& splines) {
  batch_.settle();
  if (smoothing == Smoothing::energy) minimize_energy(batch_, smoothing_);
  interpolate_nodes(batch_, interpolation_);
  if (smoothing == Smoothing::average) average_control_points(batch_, smoothing_);
  corridor_.keep_clear(cells, contours, batch_, retracted_);
  for (const ContourBatch::Member& member : batch_.members) {
    for (int k = 0; k < member.count; ++k) {
      const int i = member.first + k, node = member.source + k;
      splines.control[node] = to_subpixels(batch_.x[i], batch_.y[i]);
      splines.knot[node] = to_subpixels(batch_.knot_x[i], batch_.knot_y[i]);
      splines.is_retracted[node] = retracted_[i];
    }
  }
  batch_.clear();
}

/// Puts the end of every contour that ends at a T-junction on the knot of the contour that goes through. Only
/// the end point moves: tangents at the other end of the segment stay.
void SplineFitter::join_t_junctions(const CellGraph& cells, const Contours& contours, Splines& splines) {
  for (const Contour& contour : contours.list) {
    if (contour.closed) continue;
    const int first = contour.first, last = contour.first + contour.count - 1;
    for (const auto& [end, segment] : {std::pair{first, first}, std::pair{last, last - 1}}) {
      const int corner = contours.corner[end];
      if (!cells.is_t_junction(corner)) continue;
      splines.knot[end] = splines.knot[contours.through[corner]];
      const auto heading = static_cast<Direction>(contours.heading[segment]);
      if (is_in_strip(splines, segment, heading)) continue;
      const glm::vec2 step(kStep[heading]);
      const glm::vec2 a = to_pixels(splines.control[segment]);
      const glm::vec2 b = to_pixels(splines.control[segment + 1]) + step;
      const std::array<glm::vec2, 4> points{to_pixels(splines.knot[segment]), (2.0f * a + b) / 3.0f,
                                            (a + 2.0f * b) / 3.0f,
                                            to_pixels(splines.knot[segment + 1]) + step};
      if (!is_clear(points, heading)) splines.is_retracted[segment] = 1;
    }
  }
}

}  // namespace depixel
