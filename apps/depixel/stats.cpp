#include "apps/depixel/stats.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace depixel {
namespace {

/// The most memory that the process held at a time.
std::int64_t peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::int64_t{usage.ru_maxrss} * 1024;
}

using Rows = std::vector<std::pair<std::string_view, std::int64_t>>;

Rows time_rows(const RunStats& s) {
  Rows rows{{"read", s.read_ns}};
  for (std::size_t i = 0; i < s.stage_ns.size(); ++i)
    rows.emplace_back(VectorizeStats::kStageNames[i], s.stage_ns[i]);
  rows.insert(rows.end(), {{"draw", s.draw_ns}, {"write", s.write_ns}});
  return rows;
}

Rows memory_rows(const RunStats& s) {
  return {{"vectorizer_bytes", static_cast<std::int64_t>(s.vectorizer_bytes)}, {"peak_bytes", peak_bytes()}};
}

double milliseconds(std::int64_t ns) {
  return double(ns) / 1e6;
}

}  // namespace

void RunStats::add_vectorized(const VectorizeStats& frame) {
  work.add_vectorized(frame);
  for (std::size_t i = 0; i < stage_ns.size(); ++i) stage_ns[i] += frame.stage_ns[i];
  vectorizer_bytes = std::max(vectorizer_bytes, frame.memory_bytes);
}

std::string stats_table(const RunStats& stats) {
  std::string table;
  const auto out = std::back_inserter(table);
  const auto frames = double(std::max<std::int64_t>(stats.work.frames, 1));
  for (const CountInfo& info : count_table()) {
    const std::int64_t count = stats.work.*info.value;
    fmt::format_to(out, "{:<20}{:>14}", info.label, count);
    if (info.value != &WorkCounts::frames) fmt::format_to(out, "{:>16.1f} a frame", double(count) / frames);
    table += '\n';
  }
  for (const auto& [name, ns] : time_rows(stats)) {
    const double ms = milliseconds(ns);
    fmt::format_to(out, "{:<20}{:>14.3f} ms{:>13.3f} ms a frame\n", name, ms, ms / frames);
  }
  for (const auto& [name, bytes] : memory_rows(stats)) {
    fmt::format_to(out, "{:<20}{:>14.1f} MiB\n", name.substr(0, name.find('_')), double(bytes) / (1 << 20));
  }
  return table;
}

std::string stats_json(const RunStats& stats) {
  std::string json = "{" + json_members(stats.work) + ",";
  const auto out = std::back_inserter(json);
  for (const auto& [name, bytes] : memory_rows(stats)) fmt::format_to(out, "\"{}\":{},", name, bytes);
  json += "\"ms\":{";
  for (const auto& [name, ns] : time_rows(stats))
    fmt::format_to(out, "\"{}\":{:.6f},", name, milliseconds(ns));
  json.back() = '}';
  return json + "}\n";
}

}  // namespace depixel
