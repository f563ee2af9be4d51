#include "libdepixel/incremental/move_guess.hpp"

#include <algorithm>

#include "libdepixel/core/normalized_pixels.hpp"

namespace depixel {
namespace {

constexpr std::size_t kMostRecent = 8;
/// Pixels of a sample: so many in a row seldom agree by chance.
constexpr int kSamplePixels = kWordLanes;
constexpr int kMostSamples = 512, kFewestChanged = 16;
/// A move must leave less than two thirds of the samples that changed.
constexpr int kWantedOf3 = 2;
/// Where no move is known, moves of up to this many pixels along either axis are tried.
constexpr int kFarthest = 12;

bool is_equal(Word4 a, Word4 b) {
  const Word4 differing = a ^ b;
  return (differing[0] | differing[1] | differing[2] | differing[3]) == 0;
}

bool agrees(const FrameView& frame, const SimilarityGraph& before, glm::ivec2 at, glm::ivec2 move) {
  const glm::ivec2 from = at - move;
  const auto known = load_vector<Word4>(before.pixels.data() + before.lattice.pixel(from.x, from.y));
  const std::uint8_t* now = frame.pixels + at.y * frame.pitch + std::ptrdiff_t{sizeof(Rgba)} * at.x;
  return is_equal(load_normalized(now), known);
}

}  // namespace

void MoveGuess::remember(glm::ivec2 move) {
  const auto known = std::find(recent_.begin(), recent_.end(), move);
  if (known != recent_.end()) {
    std::rotate(recent_.begin(), known, known + 1);
    return;
  }
  if (recent_.size() == kMostRecent) recent_.pop_back();
  recent_.insert(recent_.begin(), move);
}

/// Some places, spread over the frame. \return how many of them changed.
int MoveGuess::take_samples(const FrameView& frame, const SimilarityGraph& before) {
  samples_.clear();
  const int pixels = frame.width * frame.height;
  int changed = 0;
  for (int i = 0; i < kMostSamples; ++i) {
    // Multiples of the golden ratio are spread evenly, in whatever rows the frame is cut.
    const auto at = static_cast<int>(static_cast<std::uint32_t>(i) * 0x9e3779b1ULL % 0x100000000ULL *
                                         static_cast<std::uint64_t>(pixels) >>
                                     32);
    samples_.emplace_back(std::min(at % frame.width, frame.width - kSamplePixels), at / frame.width);
    changed += agrees(frame, before, samples_.back(), glm::ivec2(0)) ? 0 : 1;
  }
  return changed;
}

/// How many samples a move leaves unexplained, or `most` if they are more; those that come from outside count
/// as halves, as they may be anything.
int MoveGuess::count_unexplained(const FrameView& frame, const SimilarityGraph& before, glm::ivec2 move,
                                 int most) const {
  int twice = 0;
  for (const glm::ivec2 at : samples_) {
    if (twice >= 2 * most) return most;
    const glm::ivec2 from = at - move;
    const bool is_inside =
        from.x >= 0 && from.y >= 0 && from.x + kSamplePixels <= frame.width && from.y < frame.height;
    twice += !is_inside ? 1 : agrees(frame, before, at, move) ? 0 : 2;
  }
  return twice / 2;
}

std::optional<glm::ivec2> MoveGuess::guess(const FrameView& frame, const SimilarityGraph& before) {
  if (frame.width < kSamplePixels) return std::nullopt;
  const int changed = take_samples(frame, before);
  if (changed < kFewestChanged) return std::nullopt;
  std::optional<glm::ivec2> best;
  int fewest = changed * kWantedOf3 / 3;
  const auto attempt = [&](glm::ivec2 move) {
    const int unexplained = count_unexplained(frame, before, move, fewest);
    if (unexplained >= fewest) return;
    fewest = unexplained;
    best = move;
  };
  for (const glm::ivec2 move : recent_) attempt(move);
  if (best) return best;
  for (int way = 1; way <= kFarthest; ++way) {
    for (const glm::ivec2 step : kStep) attempt(step * way);
  }
  return best;
}

}  // namespace depixel
