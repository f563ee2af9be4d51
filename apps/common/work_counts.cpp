#include "apps/common/work_counts.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>

namespace depixel {

void WorkCounts::add_vectorized(const VectorizeStats& frame) {
  ++frames;
  pixels += frame.pixels;
  changed_pixels += frame.changed_pixels;
  recomputed_blocks += frame.stale_corners;
  crossings += frame.crossings;
  contours += frame.contours;
  nodes += frame.nodes;
  arcs += frame.arcs;
  fitted_shapes += frame.fitted_shapes;
  cache_hits += frame.arcs - frame.fitted_shapes;
  segments += frame.segments;
  changed_tiles += frame.changed_tiles;
  moved_tiles += frame.moved_tiles;
}

void WorkCounts::add_drawn(const FilterStats& drawing) {
  drawn_pixels += drawing.drawn_pixels;
  moved_pixels += drawing.moved_pixels;
  upload_bytes += static_cast<std::int64_t>(drawing.upload_bytes);
}

std::span<const CountInfo> count_table() {
  static constexpr std::array kTable{
      CountInfo{"frames", "frames", &WorkCounts::frames},
      CountInfo{"pixels", "pixels", &WorkCounts::pixels},
      CountInfo{"changed_pixels", "pixels changed", &WorkCounts::changed_pixels},
      CountInfo{"crossings", "crossings", &WorkCounts::crossings},
      CountInfo{"recomputed_blocks", "blocks recomputed", &WorkCounts::recomputed_blocks},
      CountInfo{"contours", "contours traced", &WorkCounts::contours},
      CountInfo{"nodes", "nodes traced", &WorkCounts::nodes},
      CountInfo{"arcs", "arcs traced", &WorkCounts::arcs},
      CountInfo{"fitted_shapes", "shapes fitted", &WorkCounts::fitted_shapes},
      CountInfo{"cache_hits", "arcs of known shape", &WorkCounts::cache_hits},
      CountInfo{"segments", "segments in maps", &WorkCounts::segments},
      CountInfo{"changed_tiles", "tiles changed", &WorkCounts::changed_tiles},
      CountInfo{"moved_tiles", "tiles moved", &WorkCounts::moved_tiles},
      CountInfo{"drawn_pixels", "output drawn", &WorkCounts::drawn_pixels},
      CountInfo{"moved_pixels", "output moved", &WorkCounts::moved_pixels},
      CountInfo{"upload_bytes", "bytes uploaded", &WorkCounts::upload_bytes},
  };
  return kTable;
}

std::string json_members(const WorkCounts& counts) {
  std::string members;
  for (const CountInfo& info : count_table()) {
    if (!members.empty()) members += ',';
    fmt::format_to(std::back_inserter(members), "\"{}\":{}", info.key, counts.*info.value);
  }
  return members;
}

}  // namespace depixel
