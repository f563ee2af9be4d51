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
/// Where known moves leave more than this part of what changed, others are tried: of up to so many pixels
/// along one axis, or along both.
constexpr double kMostLeft = 0.5;
constexpr int kFarthest = 12, kFarthestBoth = 4;
/// Moves that explain none of so many samples are given up.
constexpr int kSamplesAtFirst = 32;
/// Layers that are found by trying, at most.
constexpr int kMostUnknown = 2;

bool agrees(const FrameView& frame, const SimilarityGraph& before, glm::ivec2 at, glm::ivec2 move) {
  const glm::ivec2 from = at - move;
  const bool is_inside =
      from.x >= 0 && from.y >= 0 && from.x + kSamplePixels <= frame.width && from.y < frame.height;
  if (!is_inside) return false;
  const auto known = load_vector<Word4>(before.pixels.data() + before.lattice.pixel(from.x, from.y));
  const std::uint8_t* now = frame.pixels + at.y * frame.pitch + std::ptrdiff_t{sizeof(Rgba)} * at.x;
  return is_zero(load_normalized(now) ^ known);
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

/// How many samples of those that are left a move explains.
int MoveGuess::count_explained(const FrameView& frame, const SimilarityGraph& before, glm::ivec2 move) const {
  int explained = 0, seen = 0;
  for (int i = 0; i < kSamples; ++i) {
    if ((unexplained_[i / 64] >> i % 64 & 1) == 0) continue;
    explained += agrees(frame, before, samples_[i], move) ? 1 : 0;
    if (++seen == kSamplesAtFirst && explained == 0) break;
  }
  return explained;
}

/// Tries the move by a few pixels that explains most of what is left. \return whether one explains enough.
bool MoveGuess::attempt_near(const FrameView& frame, const SimilarityGraph& before) {
  glm::ivec2 best(0);
  int most = kFewestExplained - 1;
  for (int y = -kFarthest; y <= kFarthest; ++y) {
    for (int x = -kFarthest; x <= kFarthest; ++x) {
      const bool is_along_axis = x == 0 || y == 0;
      if (!is_along_axis && std::max(std::abs(x), std::abs(y)) > kFarthestBoth) continue;
      const int explained = count_explained(frame, before, {x, y});
      if (explained <= most) continue;
      most = explained;
      best = {x, y};
    }
  }
  if (best == glm::ivec2(0)) return false;
  attempt(frame, before, best);
  return true;
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
      int explained = count(left) - count(rest);
      // What is not clearly explained by a move stayed.
      if (chosen_.empty() && trial.move == glm::ivec2(0)) explained += kFewestExplained;
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
  for (int layer = 0; layer < kMostUnknown && count(unexplained_) > kMostLeft * changed; ++layer) {
    if (!attempt_near(frame, before)) break;
    unexplained_ = choose();
  }
  if (std::find(chosen_.begin(), chosen_.end(), none) == chosen_.end()) chosen_.push_back(none);
  return chosen_;
}

}  // namespace depixel
