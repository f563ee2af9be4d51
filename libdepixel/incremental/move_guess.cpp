#include "libdepixel/incremental/move_guess.hpp"

#include <algorithm>
#include <bit>

#include "libdepixel/core/normalized_pixels.hpp"

namespace depixel {
namespace {

constexpr std::size_t kMostRecent = 8, kMostMoves = 4;
/// Pixels of a sample: so many in a row seldom agree by chance.
constexpr int kSamplePixels = kWordLanes;
/// A further move must explain so many samples that those before it do not.
constexpr int kFewestExplained = 6;
/// Where known moves leave more than this part of what changed, others of up to so many pixels along either
/// axis are tried.
constexpr double kMostLeft = 0.5;
constexpr int kFarthest = 12;

bool is_equal(Word4 a, Word4 b) {
  const Word4 differing = a ^ b;
  return (differing[0] | differing[1] | differing[2] | differing[3]) == 0;
}

bool agrees(const FrameView& frame, const SimilarityGraph& before, glm::ivec2 at, glm::ivec2 move) {
  const glm::ivec2 from = at - move;
  const bool is_inside =
      from.x >= 0 && from.y >= 0 && from.x + kSamplePixels <= frame.width && from.y < frame.height;
  if (!is_inside) return false;
  const auto known = load_vector<Word4>(before.pixels.data() + before.lattice.pixel(from.x, from.y));
  const std::uint8_t* now = frame.pixels + at.y * frame.pitch + std::ptrdiff_t{sizeof(Rgba)} * at.x;
  return is_equal(load_normalized(now), known);
}

template <typename Set>
int count(const Set& samples) {
  int all = 0;
  for (const std::uint64_t word : samples) all += std::popcount(word);
  return all;
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

/// Some places, spread over the frame.
void MoveGuess::take_samples(const FrameView& frame) {
  samples_.clear();
  const int pixels = frame.width * frame.height;
  for (int i = 0; i < kSamples; ++i) {
    // Multiples of the golden ratio are spread evenly, in whatever rows the frame is cut.
    const auto at = static_cast<int>(static_cast<std::uint32_t>(i) * 0x9e3779b1ULL % 0x100000000ULL *
                                         static_cast<std::uint64_t>(pixels) >>
                                     32);
    samples_.emplace_back(std::min(at % frame.width, frame.width - kSamplePixels), at / frame.width);
  }
}

void MoveGuess::attempt(const FrameView& frame, const SimilarityGraph& before, glm::ivec2 move) {
  Trial trial{move, {}};
  for (int i = 0; i < kSamples; ++i) {
    if (agrees(frame, before, samples_[i], move)) trial.explained[i / 64] |= std::uint64_t{1} << i % 64;
  }
  trials_.push_back(trial);
}

/// Tries the move by a few pixels along an axis that explains most of what is left.
void MoveGuess::attempt_near(const FrameView& frame, const SimilarityGraph& before) {
  glm::ivec2 best(0);
  int most = kFewestExplained - 1;
  for (int way = 1; way <= kFarthest; ++way) {
    for (const glm::ivec2 step : kStep) {
      int explained = 0;
      for (int i = 0; i < kSamples; ++i) {
        if ((unexplained_[i / 64] >> i % 64 & 1) == 0) continue;
        explained += agrees(frame, before, samples_[i], step * way) ? 1 : 0;
      }
      if (explained <= most) continue;
      most = explained;
      best = step * way;
    }
  }
  if (best != glm::ivec2(0)) attempt(frame, before, best);
}

/// Chooses moves that were tried, each time the one that explains most of what is left. \return what all
/// leave.
MoveGuess::SampleSet MoveGuess::choose() {
  chosen_.clear();
  SampleSet left;
  left.fill(~std::uint64_t{0});
  while (chosen_.size() < kMostMoves) {
    glm::ivec2 best(0);
    int most = kFewestExplained - 1;
    SampleSet left_by_best = left;
    for (const Trial& trial : trials_) {
      SampleSet rest = left;
      for (std::size_t i = 0; i < rest.size(); ++i) rest[i] &= ~trial.explained[i];
      const int explained = count(left) - count(rest);
      if (explained <= most) continue;
      most = explained;
      best = trial.move;
      left_by_best = rest;
    }
    if (most < kFewestExplained) break;
    chosen_.push_back(best);
    left = left_by_best;
  }
  return left;
}

std::span<const glm::ivec2> MoveGuess::guess(const FrameView& frame, const SimilarityGraph& before) {
  const glm::ivec2 none(0);
  chosen_.assign(1, none);
  if (frame.width < kSamplePixels) return chosen_;
  take_samples(frame);
  trials_.clear();
  attempt(frame, before, none);
  const int changed = kSamples - count(trials_.front().explained);
  if (changed < kFewestExplained) return chosen_;
  for (const glm::ivec2 move : recent_) attempt(frame, before, move);
  unexplained_ = choose();
  if (count(unexplained_) > kMostLeft * changed) {
    attempt_near(frame, before);
    choose();
  }
  if (std::find(chosen_.begin(), chosen_.end(), none) == chosen_.end()) chosen_.push_back(none);
  return chosen_;
}

}  // namespace depixel
