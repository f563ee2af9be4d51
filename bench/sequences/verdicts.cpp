#include "bench/sequences/verdicts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "bench/sequences/samples.hpp"

namespace depixel::bench {
namespace {

enum class Motion { changing, still, scrolling, other };

struct NamePart {
  std::string_view part;
  Motion motion;
};

/// The first that is found in a name counts: a fade of a scrolling game is a fade.
constexpr std::array<NamePart, 10> kNameParts{{{"fade", Motion::changing},
                                               {"freedoom", Motion::changing},
                                               {"jumpnbump", Motion::still},
                                               {"geometrix", Motion::still},
                                               {"nes_clevercat", Motion::scrolling},
                                               {"snes_platformer", Motion::scrolling},
                                               {"minicraft", Motion::scrolling},
                                               {"sushinights", Motion::scrolling},
                                               {"alex4", Motion::scrolling},
                                               {"renegaderush", Motion::scrolling}}};

constexpr double kWantedScrollingToXbr = 1.2, kWantedScrollingToScratch = 0.4, kWantedStillToXbr = 0.15,
                 kWantedChangingToScratch = 1.1, kWantedWorstToScratch = 1.3, kWantedScratchToXbr = 3.0,
                 kWantedBytes = 256, kWantedSpeedUp = 1.6;

Motion motion_of(std::string_view name) {
  const auto* found = std::find_if(kNameParts.begin(), kNameParts.end(), [&](const NamePart& known) {
    return name.find(known.part) != std::string_view::npos;
  });
  return found != kNameParts.end() ? found->motion : Motion::other;
}

}  // namespace

std::vector<Verdict> judge(const SequenceTiming& timing) {
  std::vector<Verdict> verdicts;
  const auto add = [&](std::string_view what, double value, double wanted) {
    verdicts.push_back({timing.name, std::string(what), value, wanted});
  };
  const auto to_xbr = ratios(timing.incremental, timing.xbr4),
             to_scratch = ratios(timing.incremental, timing.scratch);
  constexpr std::string_view kToXbr = "median incremental/xbr", kToScratch = "median incremental/scratch";
  switch (motion_of(timing.name)) {
    case Motion::scrolling:
      add(kToXbr, median(to_xbr), kWantedScrollingToXbr);
      add(kToScratch, median(to_scratch), kWantedScrollingToScratch);
      break;
    case Motion::still:
      add(kToXbr, median(to_xbr), kWantedStillToXbr);
      break;
    case Motion::changing:
      add(kToScratch, median(to_scratch), kWantedChangingToScratch);
      break;
    case Motion::other:
      break;
  }
  add("worst incremental/scratch", worst(to_scratch), kWantedWorstToScratch);
  add("worst scratch/xbr", worst(ratios(timing.scratch, timing.xbr4)), kWantedScratchToXbr);
  add("bytes a source pixel", timing.bytes_per_pixel, kWantedBytes);
  return verdicts;
}

Verdict judge(const std::string& sequence, const ThreadTiming& timing) {
  return {sequence, fmt::format("speed-up of drawing from scratch by {} threads", timing.threads),
          timing.draw_speed_up, kWantedSpeedUp, true};
}

}  // namespace depixel::bench
