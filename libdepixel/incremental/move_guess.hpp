#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "libdepixel/core/frame_view.hpp"
#include "libdepixel/stages/similarity_graph.hpp"

namespace depixel {

/// Guesses how most of a frame moved since the frame before: as frames moved lately, or by a few pixels along
/// an axis, if samples agree that less changes by the move than without. A wrong guess costs time and changes
/// no result.
class MoveGuess {
 public:
  void clear() { recent_.clear(); }

  /// Remembers a move that was found.
  void remember(glm::ivec2 move);

  /// \param before  pixels of the frame before.
  std::optional<glm::ivec2> guess(const FrameView& frame, const SimilarityGraph& before);

  std::size_t memory_bytes() const { return held_bytes(recent_, samples_); }

 private:
  int take_samples(const FrameView& frame, const SimilarityGraph& before);
  int count_unexplained(const FrameView& frame, const SimilarityGraph& before, glm::ivec2 move,
                        int most) const;

  std::vector<glm::ivec2> recent_;   ///< the latest first
  std::vector<glm::ivec2> samples_;  ///< pixels, each the first of a few in its row
};

}  // namespace depixel
