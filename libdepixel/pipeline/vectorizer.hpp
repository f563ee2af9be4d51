#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <string_view>

#include "libdepixel/core/options.hpp"
#include "libdepixel/stages/arcs.hpp"
#include "libdepixel/stages/border.hpp"
#include "libdepixel/stages/cell_graph.hpp"
#include "libdepixel/stages/components.hpp"
#include "libdepixel/stages/contours.hpp"
#include "libdepixel/stages/crossings.hpp"
#include "libdepixel/stages/dithers.hpp"
#include "libdepixel/stages/edge_map.hpp"
#include "libdepixel/stages/planar_map.hpp"
#include "libdepixel/stages/similarity_graph.hpp"
#include "libdepixel/stages/spline_table.hpp"

namespace depixel {

/// What vectorizing a frame took: counts, and the time of each stage.
struct VectorizeStats {
  static constexpr int kStages = 6;
  static constexpr std::array<std::string_view, kStages> kStageNames{"similarity", "crossings", "cells",
                                                                     "contours",   "splines",   "map"};
  std::array<std::int64_t, kStages> stage_ns{};  ///< wall-clock nanoseconds
  int pixels = 0, crossings = 0, contours = 0, nodes = 0, segments = 0;
  int arcs = 0, fitted_shapes = 0;  ///< arcs whose shape was known already need no fitting
  /// Of incremental vectorizing, where the counts above are of what was done for the frame, but for segments;
  /// from scratch, all is new. With a border, its margin counts here.
  int changed_pixels = 0;        ///< that differ from the frame before, moved as a whole where it moved
  int stale_corners = 0;         ///< lattice corners, and so 2x2 blocks, whose contours were traced again
  int changed_tiles = 0;         ///< tiles, one a pixel, in which the map is new
  int moved_tiles = 0;           ///< tiles in which the map is what it was elsewhere
  std::size_t memory_bytes = 0;  ///< held by all stages' arrays, between frames
};

/// Measures the stages of a frame, one after the other.
class StageClock {
 public:
  explicit StageClock(VectorizeStats& stats) : stats_(stats) { stats_.stage_ns = {}; }
  void finish(int stage) {
    const auto now = std::chrono::steady_clock::now();
    stats_.stage_ns[stage] += std::chrono::duration_cast<std::chrono::nanoseconds>(now - last_).count();
    last_ = now;
  }

 private:
  VectorizeStats& stats_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Turns frames into planar maps, each from scratch; buffers are kept, so that a warm vectorizer allocates
/// nothing. The arrays of every stage can be looked at until the next frame.
class Vectorizer {
 public:
  /// Runs all stages, in order.
  /// \param input  a frame of at least 1x1 pixels; read during the call only.
  /// \return the planar map, valid until the next call. It does not depend on the number of threads.
  const PlanarMap& vectorize(const FrameView& input, const Options& options);
  /// Runs all stages but the last: the map by edge is all that a rasteriser needs.
  void vectorize_by_edge(const FrameView& input, const Options& options);

  /// Resolved. Its pixels are the frame's, with dithers blended if asked for.
  const SimilarityGraph& graph() const { return graph_; }
  const Components& components() const { return components_; }
  const CellGraph& cells() const { return cells_; }
  const Contours& contours() const { return contours_; }
  const Arcs& arcs() const { return arcs_; }
  const SplineTable& table() const { return table_; }
  const EdgeMap& edges() const { return edges_; }
  MapByEdge by_edge() const { return {edges_, table_, cells_.colours, shading_}; }
  /// The map as a list of segments, of the last call of vectorize().
  const PlanarMap& map() const { return map_; }
  const VectorizeStats& stats() const { return stats_; }

 private:
  void fit(const Options& options);
  std::size_t memory_bytes() const;

  Workers workers_;
  Dithers dithers_;  ///< filled only when dithers are blended
  Border border_;
  SimilarityGraph graph_;
  CrossingScratch crossings_;
  Components components_;  ///< filled only when merging or connecting lines
  CellGraph cells_;
  std::vector<PixelMarks> marks_;
  Contours contours_;
  Arcs arcs_;
  SplineTable table_;
  EdgeMap edges_;
  Shading shading_;
  PlanarMap map_;
  VectorizeStats stats_;
};

}  // namespace depixel
