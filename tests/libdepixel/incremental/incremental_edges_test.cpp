#include "libdepixel/incremental/incremental_edges.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/random_sequences.hpp"

namespace depixel::test {
namespace {

/// What a frame's contours are traced from.
struct MarkedCells {
  MarkedCells(const Picture& picture, const Options& options) {
    CrossingScratch scratch;
    build_similarity_graph(picture.view(), {}, graph);
    resolve_crossings(graph, CrossingVotes::of(options), scratch);
    build_cell_graph(graph, nullptr, cells);
    find_pixel_marks(graph, false, marks);
  }

  SimilarityGraph graph;
  CellGraph cells;
  std::vector<PixelMarks> marks;
};

/// A frame's moves, as they were guessed.
void find_moves(const Picture& picture, const SimilarityGraph& before, glm::ivec2 move, BlockMoves& blocks) {
  const std::array<glm::ivec2, 2> moves{move, glm::ivec2(0)};
  blocks.find_changed_rows(picture.view(), before);
  blocks.find(picture.view(), before, moves);
}

/// The curves of a frame's edges.
std::vector<EdgeCurve> curves_of(const IncrementalEdges& edges) {
  std::vector<EdgeCurve> curves;
  for (const int number : edges.edges().curve) curves.push_back(edges.table().curve(number));
  return curves;
}

RC_GTEST_PROP(IncrementalEdges, AreThoseFromScratchAndTellWhichDiffer, (const Sequence& sequence)) {
  const Options options;
  Workers workers;
  IncrementalEdges edges;
  BlockMoves blocks;
  SimilarityGraph before;
  std::vector<CornerCode> codes_before;
  for (const SequenceFrame& frame : sequence.frames) {
    const MarkedCells now(frame.picture, options);
    const Lattice& lattice = now.cells.lattice;
    IncrementalEdges fresh;
    fresh.reset(lattice);
    fresh.trace_all(now.cells, now.marks, options);
    fresh.fit(now.cells, options, {}, workers);
    if (before.lattice == lattice && !before.pixels.empty()) {
      const auto number = [] { return *random_int(-5, 6); };
      find_moves(frame.picture, before, {number(), number()}, blocks);
      edges.start(blocks);
      // All corners are stale that have edges now, or what was moved to them.
      const GridPart corners = GridPart::corners(lattice);
      std::vector<CornerCode> moved(lattice.size());
      move_blocks(blocks, corners, CornerCode{}, codes_before, moved);
      std::vector<int> stale;
      std::vector<CornerCode> stale_codes;
      for (int corner = 0; corner < lattice.size(); ++corner) {
        if ((now.cells.corners[corner].bits() | moved[corner].bits()) == 0) continue;
        stale.push_back(corner);
        stale_codes.push_back(moved[corner]);
      }
      std::vector<int> expected(edges.edges().curve.size(), 0);
      move_blocks(blocks, GridPart::corners(lattice, 2), 0, edges.before(), expected);
      const bool moves = blocks.any_moved();
      if (!moves) expected = edges.edges().curve;
      edges.trace_stale(now.cells, now.marks, stale, stale_codes, options, blocks, {});
      edges.fit(now.cells, options, {}, workers);
      // Seams may leave edges of which neither corner has a code that tells of them.
      if (!moves) RC_ASSERT(curves_of(edges) == curves_of(fresh));
      for (const SetCurve& set : edges.set()) {
        RC_ASSERT(expected[set.slot] == set.before);
        expected[set.slot] = edges.edges().curve[set.slot];
      }
      RC_ASSERT(expected == edges.edges().curve);
    } else {
      edges.reset(lattice);
      blocks.set_unknown(lattice);
      edges.trace_all(now.cells, now.marks, options);
      edges.fit(now.cells, options, {}, workers);
      RC_ASSERT(curves_of(edges) == curves_of(fresh));
    }
    before = now.graph;
    codes_before = now.cells.corners;
  }
}

}  // namespace
}  // namespace depixel::test
