#include "libdepixel/incremental/move_guess.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "libdepixel/core/simd.hpp"

namespace depixel {
namespace {

constexpr std::size_t kMostRecent = 8;
/// Pixels of a sample: so many in a row seldom agree by chance.
constexpr int kSamplePixels = kWordLanes;
constexpr int kMostSamples = 192, kFewestSamples = 16;
/// A move must explain more than two thirds of what changed.
constexpr int kWantedOf3 = 2;

Word4 frame_pixels(const FrameView& frame, glm::ivec2 at) {
  constexpr auto kAlpha = std::bit_cast<std::uint32_t>(Rgba{0, 0, 0, 255});
  const auto four = load_vector<Word4>(frame.pixels + at.y * frame.pitch + std::ptrdiff_t{sizeof(Rgba)} * at.x);
  const Word4 visible = (four & kAlpha) != 0;
  return four & visible;
}

bool is_equal(Word4 a, Word4 b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
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

/// Some places that changed, spread over the frame.
void MoveGuess::take_samples(const FrameView& frame, const SimilarityGraph& before, const RowSpans& changed) {
  samples_.clear();
  int length = 0;
  for (int y = 0; y < changed.rows(); ++y) length += changed[y].length();
  const int step = std::max(1, length / kMostSamples);
  int next = step / 2;  // counted along all spans
  for (int y = 0; y < changed.rows(); next -= changed[y].length(), ++y) {
    for (; next < changed[y].length(); next += step) {
      const glm::ivec2 at(std::min(changed[y].from + next, frame.width - kSamplePixels), y);
      const auto known = load_vector<Word4>(before.pixels.data() + before.lattice.pixel(at.x, at.y));
      if (!is_equal(frame_pixels(frame, at), known)) samples_.push_back(at);
    }
  }
}

std::optional<glm::ivec2> MoveGuess::guess(const FrameView& frame, const SimilarityGraph& before,
                                           const RowSpans& changed) {
  if (recent_.empty() || frame.width < kSamplePixels) return std::nullopt;
  take_samples(frame, before, changed);
  if (static_cast<int>(samples_.size()) < kFewestSamples) return std::nullopt;
  std::optional<glm::ivec2> best;
  std::size_t most = samples_.size() * kWantedOf3 / 3;
  for (const glm::ivec2 move : recent_) {
    std::size_t found = 0;
    for (const glm::ivec2 at : samples_) {
      const glm::ivec2 from = at - move;
      if (from.x < 0 || from.y < 0 || from.x + kSamplePixels > frame.width || from.y >= frame.height) continue;
      const auto known = load_vector<Word4>(before.pixels.data() + before.lattice.pixel(from.x, from.y));
      found += is_equal(frame_pixels(frame, at), known) ? 1 : 0;
    }
    if (found <= most) continue;
    most = found;
    best = move;
  }
  return best;
}

}  // namespace depixel
