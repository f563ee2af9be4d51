#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "libdepixel/core/options.hpp"
#include "libdepixel/stages/cell_graph.hpp"
#include "libdepixel/stages/components.hpp"
#include "libdepixel/stages/contours.hpp"
#include "libdepixel/stages/crossings.hpp"
#include "libdepixel/stages/planar_map.hpp"
#include "libdepixel/stages/similarity_graph.hpp"
#include "libdepixel/stages/smoothing.hpp"
#include "libdepixel/stages/splines.hpp"

namespace depixel {

/// What vectorizing a frame took: counts, and the time of each stage.
struct VectorizeStats {
  static constexpr int kStages = 6;
  static constexpr std::array<std::string_view, kStages> kStageNames{"similarity", "crossings", "cells",
                                                                     "contours",   "splines",   "map"};
  std::array<std::int64_t, kStages> stage_ns{};  ///< wall-clock nanoseconds
  int pixels = 0, crossings = 0, contours = 0, nodes = 0, segments = 0;
  std::size_t memory_bytes = 0;  ///< held by all stages' arrays, between frames
};

/// Turns frames into planar maps, one after the other; buffers are kept, so that a warm vectorizer allocates
/// nothing. The arrays of every stage can be looked at until the next frame.
class Vectorizer {
 public:
  /// Runs all stages, in order, from scratch.
  /// \param frame  at least 1x1 pixels; read during the call only.
  /// \return the planar map, valid until the next call.
  const PlanarMap& vectorize(const FrameView& frame, const Options& options);

  const SimilarityGraph& graph() const { return graph_; }  ///< resolved
  const Components& components() const {
    return components_;
  }  ///< filled only when merging or connecting lines
  const CellGraph& cells() const { return cells_; }
  const Contours& contours() const { return contours_; }
  const Splines& splines() const { return splines_; }
  const PlanarMap& map() const { return map_; }
  const VectorizeStats& stats() const { return stats_; }

 private:
  std::size_t memory_bytes() const;

  SimilarityGraph graph_;
  CrossingScratch crossings_;
  Components components_;
  CellGraph cells_;
  Contours contours_;
  SplineFitter fitter_;
  Splines splines_;
  PlanarMap map_;
  VectorizeStats stats_;
};

}  // namespace depixel
