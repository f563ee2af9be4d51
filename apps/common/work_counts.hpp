#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "filter/frame_filter.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"

namespace depixel {

/// How much was done for frames, one or many: sums. Of a sequence, only what changed is done anew.
struct WorkCounts {
  std::int64_t frames = 0, pixels = 0;
  std::int64_t changed_pixels = 0;                 ///< that differ from the frame before, as it moved
  std::int64_t recomputed_blocks = 0;              ///< 2x2 blocks whose contours were traced again
  std::int64_t crossings = 0;                      ///< that were resolved
  std::int64_t contours = 0, nodes = 0, arcs = 0;  ///< that were traced
  std::int64_t fitted_shapes = 0;                  ///< shapes of arcs that were new
  std::int64_t cache_hits = 0;                     ///< arcs whose shape was known
  std::int64_t segments = 0;                       ///< in whole maps
  std::int64_t changed_tiles = 0, moved_tiles = 0;
  std::int64_t drawn_pixels = 0, moved_pixels = 0;  ///< of the output, by the processor
  std::int64_t upload_bytes = 0;                    ///< to OpenGL

  void add_vectorized(const VectorizeStats& frame);
  void add_drawn(const FilterStats& drawing);
};

/// A count as it is told to programs, and to people.
struct CountInfo {
  std::string_view key, label;
  std::int64_t WorkCounts::*value;
};
/// All counts, in the order in which they come about.
std::span<const CountInfo> count_table();
/// The members of a JSON object, without its braces.
std::string json_members(const WorkCounts& counts);

}  // namespace depixel
