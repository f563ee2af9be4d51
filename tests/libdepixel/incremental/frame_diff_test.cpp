#include "libdepixel/incremental/frame_diff.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/random_sequences.hpp"

namespace depixel::test {
namespace {

SimilarityGraph graph_of(const Picture& picture) {
  SimilarityGraph graph;
  build_similarity_graph(picture.view(), Similarity::exact, false, graph);
  return graph;
}

int take(const FrameView& frame, SimilarityGraph& graph, RowSpans& changed) {
  find_changed_pixels(frame, graph, changed);
  return take_changed_pixels(frame, changed, graph);
}

RC_GTEST_PROP(FrameDiff, FindsWhereRowsDifferFirstAndLast, (const Sequence& sequence)) {
  SimilarityGraph graph;
  RowSpans changed;
  for (const SequenceFrame& frame : sequence.frames) {
    const Picture& picture = frame.picture;
    const Lattice lattice(picture.width, picture.height);
    graph.resize(lattice);
    const std::vector<Rgba> before = graph.pixels;
    const int count = take(picture.view(), graph, changed);
    RC_ASSERT(graph.pixels == graph_of(picture).pixels);
    RC_ASSERT(changed.rows() == picture.height);
    int differing = 0;
    for (int y = 0; y < picture.height; ++y) {
      Span expected;
      for (int x = 0; x < picture.width; ++x) {
        if (before[lattice.pixel(x, y)] == graph.pixels[lattice.pixel(x, y)]) continue;
        if (expected.is_empty()) expected.from = x;
        expected.to = x + 1;
        ++differing;
      }
      RC_ASSERT(changed.is_empty(y) == expected.is_empty());
      if (expected.is_empty()) continue;
      RC_ASSERT(changed[y].from == expected.from);
      RC_ASSERT(changed[y].to == expected.to);
    }
    RC_ASSERT(count == differing);
  }
}

TEST(FrameDiff, WhatIsTransparentIsTheSameWhateverItsColour) {
  const Picture before(9, 2, {0, 0, 0, 0});
  SimilarityGraph graph = graph_of(before);
  RowSpans changed;
  EXPECT_EQ(take(Picture(9, 2, {10, 20, 30, 0}).view(), graph, changed), 0);
  EXPECT_FALSE(changed.any());
  EXPECT_EQ(graph.pixels, graph_of(before).pixels);
}

TEST(FrameDiff, ReadsRowsWithGapsBetweenThem) {
  const Picture wide = ascii_picture({"rgb#####",  //
                                      "yyy#####"});
  SimilarityGraph graph = graph_of(ascii_picture({"rgb",  //
                                                  "y.y"}));
  RowSpans changed;
  const FrameView view{wide.view().pixels, 3, 2, wide.view().pitch};
  EXPECT_EQ(take(view, graph, changed), 1);
  EXPECT_TRUE(changed.is_empty(0));
  EXPECT_EQ(changed[1].from, 1);
  EXPECT_EQ(changed[1].to, 2);
}

}  // namespace
}  // namespace depixel::test
