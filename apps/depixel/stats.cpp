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

Rows count_rows(const RunStats& s) {
  return {{"frames", s.frames},     {"pixels", s.pixels}, {"crossings", s.crossings},
          {"contours", s.contours}, {"nodes", s.nodes},   {"segments", s.segments}};
}

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

void RunStats::add(const VectorizeStats& frame) {
  ++frames;
  pixels += frame.pixels;
  crossings += frame.crossings;
  contours += frame.contours;
  nodes += frame.nodes;
  segments += frame.segments;
  for (std::size_t i = 0; i < stage_ns.size(); ++i) stage_ns[i] += frame.stage_ns[i];
  vectorizer_bytes = std::max(vectorizer_bytes, frame.memory_bytes);
}

std::string stats_table(const RunStats& stats) {
  std::string table;
  const auto out = std::back_inserter(table);
  for (const auto& [name, count] : count_rows(stats)) fmt::format_to(out, "{:<12}{:>12}\n", name, count);
  for (const auto& [name, ns] : time_rows(stats)) {
    const double ms = milliseconds(ns);
    fmt::format_to(out, "{:<12}{:>12.3f} ms{:>12.3f} ms a frame\n", name, ms,
                   ms / double(std::max<std::int64_t>(stats.frames, 1)));
  }
  for (const auto& [name, bytes] : memory_rows(stats)) {
    fmt::format_to(out, "{:<16}{:>8.1f} MiB\n", name.substr(0, name.find('_')), double(bytes) / (1 << 20));
  }
  return table;
}

std::string stats_json(const RunStats& stats) {
  std::string json = "{";
  const auto out = std::back_inserter(json);
  for (const auto& [name, count] : count_rows(stats)) fmt::format_to(out, "\"{}\":{},", name, count);
  for (const auto& [name, bytes] : memory_rows(stats)) fmt::format_to(out, "\"{}\":{},", name, bytes);
  json += "\"ms\":{";
  for (const auto& [name, ns] : time_rows(stats))
    fmt::format_to(out, "\"{}\":{:.6f},", name, milliseconds(ns));
  json.back() = '}';
  return json + "}\n";
}

}  // namespace depixel
