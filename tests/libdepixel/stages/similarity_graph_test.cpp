#include "libdepixel/stages/similarity_graph.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/naive_graph.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

SimilarityGraph build(const Picture& picture, Similarity similarity = Similarity::exact,
                      bool connect_lines = false) {
  SimilarityGraph graph;
  build_similarity_graph(picture.view(), {similarity, connect_lines, kHqxLuma}, graph);
  return graph;
}

int links_at(const SimilarityGraph& graph, int x, int y) {
  return graph.links[graph.lattice.pixel(x, y)];
}

TEST(SimilarityGraph, UniformBlockKeepsItsSidesOnly) {
  const SimilarityGraph graph = build(ascii_picture({"rr",  //
                                                     "rr"}));
  EXPECT_EQ(links_at(graph, 0, 0), kNorthSide | kWestSide);
  EXPECT_EQ(links_at(graph, 1, 0), kWestSide);
  EXPECT_EQ(links_at(graph, 0, 1), kNorthSide);
  EXPECT_EQ(links_at(graph, 1, 1), 0);
}

TEST(SimilarityGraph, RawGraphKeepsTheDiagonalsOfUniformBlocks) {
  SimilarityGraph graph;
  build_raw_similarity_graph(ascii_picture({"rr",  //
                                            "rr"})
                                 .view(),
                             {}, graph);
  EXPECT_EQ(links_at(graph, 0, 0), kNorthSide | kWestSide | kBothDiagonals);
}

TEST(SimilarityGraph, ThreeOfAColourKeepTheirDiagonal) {
  const SimilarityGraph graph = build(ascii_picture({"rr",  //
                                                     "r."}));
  EXPECT_EQ(links_at(graph, 0, 0), kNorthSide | kWestSide | kAntiDiagonal);
}

TEST(SimilarityGraph, CheckerboardBlockCrosses) {
  const SimilarityGraph graph = build(ascii_picture({"r.",  //
                                                     ".r"}));
  EXPECT_EQ(links_at(graph, 0, 0), kBothDiagonals);
  EXPECT_TRUE(graph.is_crossing(graph.lattice.pixel(0, 0)));
}

TEST(SimilarityGraph, AlphaZeroIsOneColourAndUnequalAlphaAnother) {
  Picture picture(3, 1);
  picture.pixels = {{9, 9, 9, 0}, {70, 0, 200, 0}, {70, 0, 200, 1}};
  for (const Similarity similarity : {Similarity::exact, Similarity::merge}) {
    const SimilarityGraph graph = build(picture, similarity);
    EXPECT_EQ(links_at(graph, 0, 0), kNorthSide);
    EXPECT_EQ(links_at(graph, 1, 0), 0);
    EXPECT_EQ(graph.pixels[graph.lattice.pixel(0, 0)], Rgba{});
  }
}

TEST(SimilarityGraph, MergingIsJudgedByLinksNotByGroups) {
  // 4-5 and 5-6 are alike (25 apart), 4-6 are not (50 apart): three sides, so both diagonals go.
  const SimilarityGraph graph = build(ascii_picture({"45",  //
                                                     "56"}),
                                      Similarity::merge);
  EXPECT_EQ(links_at(graph, 0, 0), kNorthSide | kWestSide);
  EXPECT_EQ(links_at(graph, 0, 1), kNorthSide);
}

TEST(SimilarityGraph, MergedBlocksOfOneSideKeepTheirDiagonals) {
  // 4 and 5 at the top are alike, and so are 5 and 6; 4-6 and 4-9 and 6-9 are not.
  const SimilarityGraph graph = build(ascii_picture({"45",  //
                                                     "69"}),
                                      Similarity::merge);
  EXPECT_EQ(links_at(graph, 0, 0), kNorthSide | kAntiDiagonal);
}

TEST(SimilarityGraph, LinesConnectAcrossDiagonalsOnly) {
  // Two lines of near greys, end to end across a diagonal, on a background that is no line.
  const Picture picture = ascii_picture({"rrrrrrr",  //
                                         "r33rrrr",  //
                                         "rrr55rr",  //
                                         "rrrrrrr"});
  EXPECT_EQ(links_at(build(picture), 2, 1) & kMainDiagonal, 0);
  EXPECT_EQ(links_at(build(picture, Similarity::exact, true), 2, 1) & kMainDiagonal, kMainDiagonal);

  const Picture side_by_side = ascii_picture({"rrrrrrr",  //
                                              "r3355rr",  //
                                              "rrrrrrr",  //
                                              "rrrrrrr"});
  const SimilarityGraph graph = build(side_by_side, Similarity::exact, true);
  EXPECT_EQ(links_at(graph, 2, 1) & kNorthSide, 0);
}

TEST(SimilarityGraph, LinesOfFarColoursStayApart) {
  const Picture picture = ascii_picture({"rrrrrrr",  //
                                         "r00rrrr",  //
                                         "rrr55rr",  //
                                         "rrrrrrr"});
  EXPECT_EQ(links_at(build(picture, Similarity::exact, true), 2, 1) & kMainDiagonal, 0);
}

TEST(SimilarityGraph, AComponentWithAJunctionIsNoLine) {
  // The lower shape has a pixel of valence 3.
  const Picture picture = ascii_picture({"rrrrrrr",  //
                                         "r33rrrr",  //
                                         "rrr55rr",  //
                                         "rrr55rr",  //
                                         "rrrrrrr"});
  EXPECT_EQ(links_at(build(picture, Similarity::exact, true), 2, 1) & kMainDiagonal, 0);
}

TEST(SimilarityGraph, JoinsAreTestedOnTheGraphAsItWas) {
  // The third join of the spot in the middle would make it no line, were they made one by one.
  const Picture picture = ascii_picture({"rrrrr",  //
                                         "r3r5r",  //
                                         "rr4rr",  //
                                         "r5r3r",  //
                                         "rrrrr"});
  const SimilarityGraph graph = build(picture, Similarity::exact, true);
  EXPECT_NE(links_at(graph, 1, 1) & kMainDiagonal, 0);
  EXPECT_NE(links_at(graph, 2, 1) & kAntiDiagonal, 0);
  EXPECT_NE(links_at(graph, 1, 2) & kAntiDiagonal, 0);
  EXPECT_NE(links_at(graph, 2, 2) & kMainDiagonal, 0);
}

TEST(SimilarityGraph, NothingLeavesTheFrame) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 5}, {5, 1}, {2, 2}}) {
    const SimilarityGraph graph = build(Picture(width, height, palette_colour('r')));
    for (int i = 0; i < graph.lattice.size(); ++i) {
      const glm::ivec2 p = graph.lattice.pixel_position(i);
      int allowed = 0;
      if (p.x >= 0 && p.y >= 0 && p.x < width && p.y < height) {
        allowed = (p.x + 1 < width ? kNorthSide : 0) | (p.y + 1 < height ? kWestSide : 0);
      }
      EXPECT_EQ(graph.links[i], allowed) << width << 'x' << height << " at " << p.x << ',' << p.y;
    }
  }
}

TEST(SimilarityGraph, PitchIsHonoured) {
  const Picture wide = ascii_picture({"rr..",  //
                                      "..rr"});
  SimilarityGraph graph;
  FrameView view = wide.view();
  view.width = 2;
  build_similarity_graph(view, {}, graph);
  EXPECT_EQ(links_at(graph, 0, 0), kNorthSide);
  EXPECT_EQ(links_at(graph, 0, 1), kNorthSide);
}

TEST(SimilarityGraph, NeighboursRunClockwiseFromNorth) {
  const SimilarityGraph graph = build(ascii_picture({"gr.",  //
                                                     ".rr",  //
                                                     "r.."}));
  // The centre is linked to N, E and, across a crossing that is not resolved yet, SW.
  EXPECT_EQ(graph.neighbours(graph.lattice.pixel(1, 1)), 1 << 0 | 1 << 2 | 1 << 5);
}

RC_GTEST_PROP(SimilarityGraph, EqualsTheTextbook, (const Picture& picture)) {
  const Options options = *random_options();
  SimilarityGraph graph;
  build_similarity_graph(picture.view(), LinkCriteria::of(options), graph);
  NaiveGraph naive(picture, options);
  if (options.connect_lines) naive.connect_lines();
  naive.freeze();
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const int expected = kNorthSide * naive.linked({x, y}, {x + 1, y}) |
                           kWestSide * naive.linked({x, y}, {x, y + 1}) |
                           kMainDiagonal * naive.linked({x, y}, {x + 1, y + 1}) |
                           kAntiDiagonal * naive.linked({x + 1, y}, {x, y + 1});
      RC_ASSERT(links_at(graph, x, y) == expected);
    }
  }
}

RC_GTEST_PROP(SimilarityGraph, BuffersOfAnotherFrameLeaveNoTrace,
              (const Picture& first, const Picture& second)) {
  SimilarityGraph reused = build(first, Similarity::merge, true);
  build_similarity_graph(second.view(), {}, reused);
  const SimilarityGraph fresh = build(second);
  RC_ASSERT(reused.links == fresh.links);
  RC_ASSERT(reused.pixels == fresh.pixels);
}

}  // namespace
}  // namespace depixel::test
