#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "libdepixel/core/frame_view.hpp"
#include "libdepixel/stages/similarity_graph.hpp"

namespace depixel {

/// Guesses how parts of a frame moved since the frame before: not at all, as frames moved lately, or by a few
/// pixels, if many samples agree that are not explained otherwise. A wrong guess costs time and
/// changes no result.
class MoveGuess {
 public:
  /// Remembers a move that was found.
  void remember(glm::ivec2 move);

  /// \param before  pixels of the frame before.
  /// \return a few moves, that of most samples first; that by nothing is always one of them. Valid until the
  ///         next call.
  std::span<const glm::ivec2> guess(const FrameView& frame, const SimilarityGraph& before);

  std::size_t memory_bytes() const { return held_bytes(recent_, samples_, trials_, chosen_); }

 private:
  static constexpr int kSamples = 256;

  /// A set of samples.
  using SampleSet = std::array<std::uint64_t, kSamples / 64>;
  /// A move, and the samples that it explains.
  struct Trial {
    glm::ivec2 move;
    SampleSet explained;
  };

  void take_samples(const FrameView& frame);
  void attempt(const FrameView& frame, const SimilarityGraph& before, glm::ivec2 move);
  int count_explained(const FrameView& frame, const SimilarityGraph& before, glm::ivec2 move) const;
  bool attempt_near(const FrameView& frame, const SimilarityGraph& before);
  SampleSet choose();

  std::vector<glm::ivec2> recent_;   ///< the latest first
  std::vector<glm::ivec2> samples_;  ///< pixels, each the first of a few in its row
  std::vector<Trial> trials_;
  std::vector<glm::ivec2> chosen_;
  SampleSet unexplained_{};
};

}  // namespace depixel
