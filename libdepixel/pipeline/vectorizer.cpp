#include "libdepixel/pipeline/vectorizer.hpp"

#include "libdepixel/core/stopwatch.hpp"

namespace depixel {

const PlanarMap& Vectorizer::vectorize(const FrameView& input, const Options& options) {
  vectorize_by_edge(input, options);
  {
    const Stopwatch time(stats_.stage_ns[5]);
    build_planar_map(by_edge(), map_);
  }
  stats_.memory_bytes = memory_bytes();
  return map_;
}

void Vectorizer::vectorize_by_edge(const FrameView& input, const Options& options) {
  const bool merges = options.has_whole_components();
  workers_.set_threads(options.threads);
  StageClock clock(stats_);

  const bool blends = options.dither == DitherKind::blend;
  if (blends) blend_dithers(input, options.linear_light, dithers_);
  const FrameView frame = border_.continued(blends ? dithers_.view() : input, options.border);
  build_similarity_graph(frame, LinkCriteria::of(options), graph_);
  clock.finish(0);

  const CrossingVotes votes = CrossingVotes::of(options);
  stats_.crossings = resolve_crossings(graph_, votes, crossings_);
  clock.finish(1);

  if (merges) {
    label_components(graph_, components_);
    find_majority_colours(graph_, components_);
  }
  build_cell_graph(graph_, merges ? &components_ : nullptr, cells_);
  if (options.smoothing == Smoothing::energy) find_pixel_marks(graph_, options.text_safe, marks_);
  clock.finish(2);

  trace_contours(cells_, contours_);
  cut_arcs(cells_, contours_, marks_, options.spline, options.smoothing, arcs_);
  clock.finish(3);

  fit(options);
  clock.finish(4);

  build_shading(graph_, cells_, options, shading_);
  clock.finish(5);

  stats_.pixels = input.width * input.height;
  stats_.contours = static_cast<int>(contours_.list.size());
  stats_.nodes = static_cast<int>(contours_.corner.size());
  stats_.arcs = static_cast<int>(arcs_.list.size());
  stats_.changed_pixels = stats_.changed_tiles = stats_.pixels;
  stats_.stale_corners = (frame.width + 1) * (frame.height + 1);
  stats_.memory_bytes = memory_bytes();
}

void Vectorizer::fit(const Options& options) {
  const std::array<int, 4> step = cells_.lattice.step_offsets();
  edges_.lattice = cells_.lattice;
  edges_.curve.assign(2 * std::size_t(cells_.lattice.size()), 0);
  table_.clear();
  for (Arc& arc : arcs_.list) arc.place = table_.place_of(arcs_.words(arc), arc.kind);
  stats_.fitted_shapes = table_.fit_added(options, workers_);
  stats_.segments = 0;
  for (const Arc& arc : arcs_.list) {
    for_each_edge(arcs_, arc, table_, step, [&](int slot, int number) { edges_.curve[slot] = number; });
    stats_.segments += arc.step_count();
  }
  for_each_joint(contours_, cells_, [&](int corner) {
    const JoinedEdge joined = join_at(corner, cells_, edges_, table_);
    edges_.curve[joined.slot] = joined.curve;
  });
}

std::size_t Vectorizer::memory_bytes() const {
  return dithers_.memory_bytes() + border_.memory_bytes() + graph_.memory_bytes() +
         crossings_.memory_bytes() + components_.memory_bytes() + cells_.memory_bytes() + held_bytes(marks_) +
         contours_.memory_bytes() + arcs_.memory_bytes() + table_.memory_bytes() + edges_.memory_bytes() +
         shading_.memory_bytes() + map_.memory_bytes();
}

}  // namespace depixel
