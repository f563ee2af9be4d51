#include "bench/sequences/report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace depixel::bench {
namespace {

/// What the table and the JSON object say of a sequence.
struct Summary {
  explicit Summary(const SequenceTiming& timing)
      : to_xbr(ratios(timing.incremental, timing.xbr4)),
        to_scratch(ratios(timing.incremental, timing.scratch)),
        scratch_to_xbr(ratios(timing.scratch, timing.xbr4)) {}

  std::vector<double> to_xbr, to_scratch, scratch_to_xbr;
};

void print_softfilters(const SequenceTiming& timing) {
  for (const SoftFilterTiming& filter : timing.softfilters) {
    fmt::print("  {:<27} to {:>4} x {:<4} {:>7.3f} ms, incremental {:.2f} times that\n", filter.name,
               filter.out_width, filter.out_height, median(filter.samples.medians()),
               median(ratios(timing.incremental, filter.samples)));
  }
}

void print_repeats(const SequenceTiming& timing) {
  const auto of_repeats = [&](const std::vector<double>& values) {
    std::vector<double> chosen;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (timing.is_repeat[i]) chosen.push_back(values[i]);
    }
    return chosen;
  };
  const auto incremental_ms = of_repeats(timing.incremental.medians());
  if (incremental_ms.empty()) return;
  fmt::print("  frames like the one before: {}, incremental {:.4f} ms, {:.1f} times a memcmp of {:.4f} ms\n",
             incremental_ms.size(), median(incremental_ms),
             median(of_repeats(ratios(timing.incremental, timing.compare))),
             median(of_repeats(timing.compare.medians())));
}

}  // namespace

void print_header() {
  fmt::print("{:<26} {:>6} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n",
             "sequence, ms at 4x", "frames", "increm.", "scratch", "xbr", "hqx", "inc/xbr", "inc/scr", "p99",
             "p99/xbr", "max i/s", "max s/x", "B/pixel");
}

void print_timing(const SequenceTiming& timing) {
  const Summary summary(timing);
  const auto incremental_ms = timing.incremental.medians();
  fmt::print(
      "{:<26} {:>6} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.2f} {:>8.2f} {:>8.3f} {:>8.2f} {:>8.2f} "
      "{:>8.2f} {:>8.1f}\n",
      timing.name, incremental_ms.size(), median(incremental_ms), median(timing.scratch.medians()),
      median(timing.xbr4.medians()), median(timing.hqx4.medians()), median(summary.to_xbr),
      median(summary.to_scratch), percentile_99(incremental_ms), percentile_99(summary.to_xbr),
      worst(summary.to_scratch), worst(summary.scratch_to_xbr), timing.bytes_per_pixel);
  print_softfilters(timing);
  print_repeats(timing);
  std::fflush(stdout);
}

void print_threads(const ThreadTiming& timing) {
  fmt::print("  {} threads from scratch: drawing {:.2f}, vectorizing and drawing {:.2f} times as fast as 1\n",
             timing.threads, timing.draw_speed_up, timing.both_speed_up);
  std::fflush(stdout);
}

void print_verdicts(std::span<const Verdict> verdicts) {
  fmt::print("\n");
  for (const Verdict& verdict : verdicts) {
    fmt::print("{}: {} {:.2f}, wanted at {} {}: {}\n", verdict.sequence, verdict.what, verdict.value,
               verdict.wants_more ? "least" : "most", verdict.wanted,
               verdict.is_reached() ? "reached" : "missed");
  }
  const auto reached = std::count_if(verdicts.begin(), verdicts.end(),
                                     [](const Verdict& verdict) { return verdict.is_reached(); });
  fmt::print("{} of {} reached\n", reached, verdicts.size());
}

void print_json(std::span<const SequenceTiming> timings) {
  using Json = nlohmann::ordered_json;
  Json sequences = Json::array();
  for (const SequenceTiming& timing : timings) {
    const Summary summary(timing);
    Json softfilters = Json::object();
    for (const SoftFilterTiming& filter : timing.softfilters) {
      softfilters[filter.name] = median(filter.samples.medians());
    }
    sequences.push_back({{"name", timing.name},
                         {"xbr4_ms", median(timing.xbr4.medians())},
                         {"hqx4_ms", median(timing.hqx4.medians())},
                         {"scratch_ms", median(timing.scratch.medians())},
                         {"median_ms", median(timing.incremental.medians())},
                         {"p99_ms", percentile_99(timing.incremental.medians())},
                         {"median_ratio_to_xbr4", median(summary.to_xbr)},
                         {"median_ratio_to_scratch", median(summary.to_scratch)},
                         {"worst_ratio_to_scratch", worst(summary.to_scratch)},
                         {"scratch_ratio_to_xbr4_worst", worst(summary.scratch_to_xbr)},
                         {"bytes_per_pixel", timing.bytes_per_pixel},
                         {"softfilters", std::move(softfilters)}});
  }
  fmt::print("{}\n", Json{{"sequences", std::move(sequences)}}.dump());
}

}  // namespace depixel::bench
