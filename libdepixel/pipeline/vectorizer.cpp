#include "libdepixel/pipeline/vectorizer.hpp"

#include <chrono>

namespace depixel {
namespace {

/// Measures the time since it was last asked.
class Lap {
 public:
  std::int64_t operator()() {
    const auto now = std::chrono::steady_clock::now();
    const auto ns = std::chrono::duration_cast<std::chrono::nanoseconds>(now - last_).count();
    last_ = now;
    return ns;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

const PlanarMap& Vectorizer::vectorize(const FrameView& frame, const Options& options) {
  const bool merges = options.similarity == Similarity::merge || options.connect_lines;
  Lap lap;

  build_similarity_graph(frame, options.similarity, options.connect_lines, graph_);
  stats_.stage_ns[0] = lap();

  const CrossingVotes votes{options.curve_weight, options.sparse_weight, options.island_weight};
  stats_.crossings = resolve_crossings(graph_, votes, crossings_);
  stats_.stage_ns[1] = lap();

  if (merges) {
    label_components(graph_, components_);
    find_majority_colours(graph_, components_);
  }
  build_cell_graph(graph_, merges ? &components_ : nullptr, cells_);
  stats_.stage_ns[2] = lap();

  trace_contours(cells_, contours_);
  stats_.stage_ns[3] = lap();

  fitter_.fit(graph_, cells_, contours_, options.spline, options.smoothing, splines_);
  stats_.stage_ns[4] = lap();

  build_planar_map(cells_, contours_, splines_, map_);
  stats_.stage_ns[5] = lap();

  stats_.pixels = frame.width * frame.height;
  stats_.contours = static_cast<int>(contours_.list.size());
  stats_.nodes = static_cast<int>(contours_.corner.size());
  stats_.segments = static_cast<int>(map_.segments.size());
  stats_.memory_bytes = memory_bytes();
  return map_;
}

std::size_t Vectorizer::memory_bytes() const {
  return graph_.memory_bytes() + crossings_.memory_bytes() + components_.memory_bytes() +
         cells_.memory_bytes() + contours_.memory_bytes() + fitter_.memory_bytes() + splines_.memory_bytes() +
         map_.memory_bytes();
}

}  // namespace depixel
