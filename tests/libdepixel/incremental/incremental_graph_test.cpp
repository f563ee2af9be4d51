#include "libdepixel/incremental/incremental_graph.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/random_sequences.hpp"

namespace depixel::test {
namespace {

/// The resolved graph of a picture, and how many crossings it had.
std::pair<SimilarityGraph, int> resolved(const Picture& picture, const Options& options) {
  SimilarityGraph graph;
  CrossingScratch scratch;
  build_similarity_graph(picture.view(), LinkCriteria::of(options), graph);
  const CrossingVotes votes = CrossingVotes::of(options);
  const int crossings = resolve_crossings(graph, votes, scratch);
  return {graph, crossings};
}

RC_GTEST_PROP(IncrementalGraph, IsThatFromScratchWhateverTheMoves, (const Sequence& sequence)) {
  const auto number = [] { return *random_int(-5, 6); };
  IncrementalGraph graph;
  BlockMoves blocks;
  std::optional<Options> options;
  for (const SequenceFrame& frame : sequence.frames) {
    const FrameView view = frame.picture.view();
    const Lattice lattice(view.width, view.height);
    SimilarityGraph before = graph.resolved();
    const bool is_known = options == frame.options && before.lattice == lattice;
    options = frame.options;
    if (is_known) {
      const std::array<glm::ivec2, 3> moves{glm::ivec2(number(), number()), glm::ivec2(0),
                                            glm::ivec2(number(), number())};
      blocks.find_changed_rows(view, before);
      blocks.find(view, before, moves);
    } else {
      graph.reset(lattice);
      blocks.set_unknown(lattice);
    }
    graph.update(view, frame.options, blocks, {});
    const auto [expected, crossings] = resolved(frame.picture, frame.options);
    RC_ASSERT(graph.resolved().pixels == expected.pixels);
    RC_ASSERT(graph.resolved().links == expected.links);
    RC_ASSERT(graph.crossings() <= crossings);
    if (!is_known) continue;
    // Outside of stale blocks, all is as it was where their blocks were.
    const BlockGrid& grid = blocks.grid();
    for (int y = 0; y < lattice.height(); ++y) {
      for (int x = 0; x < lattice.width(); ++x) {
        const int column = x / BlockGrid::kSide, row = y / BlockGrid::kSide;
        if (graph.stale().has(column, row)) continue;
        const glm::ivec2 from = glm::ivec2(x, y) - blocks.move(column, row);
        for (const glm::ivec2 by : {glm::ivec2(0), glm::ivec2(-2), glm::ivec2(2, -2), glm::ivec2(2)}) {
          const glm::ivec2 at = glm::ivec2(x, y) + by, at_before = from + by;
          if (at.x < 0 || at.y < 0 || at.x >= grid.width || at.y >= grid.height) continue;
          const int pixel = lattice.pixel(at.x, at.y), pixel_before = lattice.pixel(at_before.x, at_before.y);
          RC_ASSERT(expected.pixels[pixel] == before.pixels[pixel_before]);
          RC_ASSERT(expected.links[pixel] == before.links[pixel_before]);
        }
      }
    }
  }
}

}  // namespace
}  // namespace depixel::test
