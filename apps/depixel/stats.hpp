#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "apps/common/work_counts.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"

namespace depixel {

/// What a run of the program took, over all frames.
struct RunStats {
  WorkCounts work;
  std::array<std::int64_t, VectorizeStats::kStages> stage_ns{};
  std::int64_t read_ns = 0;          ///< files to pictures in memory
  std::int64_t draw_ns = 0;          ///< planar maps to pixels or SVG text
  std::int64_t write_ns = 0;         ///< pixels to files
  std::size_t vectorizer_bytes = 0;  ///< held by the stages' arrays, at most

  void add_vectorized(const VectorizeStats& frame);
};

/// For people: a table of totals and of milliseconds a frame.
std::string stats_table(const RunStats& stats);
/// For programs: one JSON object of totals, on one line.
std::string stats_json(const RunStats& stats);

}  // namespace depixel
