#include "libdepixel/stages/crossings.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/naive_graph.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

constexpr CrossingVotes kCurvesOnly{1, 0, 0}, kSparseOnly{0, 1, 0}, kIslandsOnly{0, 0, 5};

struct Resolved {
  SimilarityGraph graph;
  int crossings = 0;

  /// The diagonals left in the block whose north-west pixel is (x, y).
  int diagonals(int x, int y) const { return graph.links[graph.lattice.pixel(x, y)] & kBothDiagonals; }
};

Resolved resolve(const Picture& picture, const CrossingVotes& votes = {},
                 Similarity similarity = Similarity::exact) {
  Resolved result;
  CrossingScratch scratch;
  build_similarity_graph(picture.view(), {similarity, false, kHqxLuma}, result.graph);
  result.crossings = resolve_crossings(result.graph, votes, scratch);
  return result;
}

/// Figure 31 (a): a black curve of five links, on a background that is no curve. The window of the first
/// crossing holds all 6 black and 42 white pixels.
Picture hook() {
  return ascii_picture({"........",  //
                        ".###....",  //
                        "....#...",  //
                        "...#....",  //
                        "...#....",  //
                        "........"});
}

/// A closed black curve of four links; the window of each crossing holds all 4 black and 26 white pixels.
Picture ring() {
  return ascii_picture({"......",  //
                        "..#...",  //
                        ".#.#..",  //
                        "..#...",  //
                        "......"});
}

TEST(Crossings, LongerCurveWins) {
  const Resolved result = resolve(hook(), kCurvesOnly);
  EXPECT_EQ(result.crossings, 2);
  EXPECT_EQ(result.diagonals(3, 1), kMainDiagonal);
  EXPECT_EQ(result.diagonals(3, 2), kAntiDiagonal);
}

TEST(Crossings, VotesAreDifferencesOfLengthsAndSizes) {
  // 5 - 1 links for the black diagonal; with a negative weight, 42 - 6 pixels against it.
  EXPECT_EQ(resolve(hook(), {8, -1, 0}).diagonals(3, 1), kAntiDiagonal);
  EXPECT_EQ(resolve(hook(), {9, -1, 0}).diagonals(3, 1), 0);
  EXPECT_EQ(resolve(hook(), {10, -1, 0}).diagonals(3, 1), kMainDiagonal);
}

TEST(Crossings, AClosedCurveCountsEachLinkOnce) {
  const Resolved kept = resolve(ring(), kCurvesOnly);
  EXPECT_EQ(kept.crossings, 4);
  EXPECT_EQ(kept.diagonals(1, 1), kAntiDiagonal);
  EXPECT_EQ(kept.diagonals(2, 1), kMainDiagonal);
  EXPECT_EQ(kept.diagonals(1, 2), kMainDiagonal);
  EXPECT_EQ(kept.diagonals(2, 2), kAntiDiagonal);
  // 4 - 1 links times 22 against 26 - 4 pixels times 3.
  EXPECT_EQ(resolve(ring(), {22, -3, 0}).diagonals(1, 1), 0);
}

TEST(Crossings, SparserColourWins) {
  // Figure 31 (b): blue spots are fewer than white ones in the window.
  const Picture picture = ascii_picture({"........",  //
                                         "........",  //
                                         "..bb....",  //
                                         "..bb....",  //
                                         "....bb..",  //
                                         "....bb..",  //
                                         "........",  //
                                         "........"});
  const Resolved result = resolve(picture, kSparseOnly);
  EXPECT_EQ(result.crossings, 1);
  EXPECT_EQ(result.diagonals(3, 3), kMainDiagonal);
}

TEST(Crossings, SparseLooksNoFurtherThanTheWindow) {
  // The window of the crossing at (4, 4) ends at column 8: eight blue pixels inside it against eight yellow
  // ones, although there is more blue beyond.
  Picture picture(14, 10, palette_colour('r'));
  for (const auto& [x, y] : {std::pair{4, 4}, {3, 3}, {2, 2}, {5, 5}, {6, 6}, {7, 7}, {8, 7}, {8, 6}}) {
    picture.at(x, y) = palette_colour('b');
  }
  for (const auto& [x, y] : {std::pair{5, 4}, {6, 3}, {7, 2}, {4, 5}, {3, 6}, {2, 7}, {1, 7}, {1, 8}}) {
    picture.at(x, y) = palette_colour('y');
  }
  EXPECT_EQ(resolve(picture, kSparseOnly).diagonals(4, 4), 0);
  for (int x = 9; x < 14; ++x) picture.at(x, 5) = palette_colour('b');  // touches (8, 6), outside the window
  EXPECT_EQ(resolve(picture, kSparseOnly).diagonals(4, 4), 0);
  picture.at(8, 5) = palette_colour('b');  // one blue pixel more inside
  EXPECT_EQ(resolve(picture, kSparseOnly).diagonals(4, 4), kAntiDiagonal);
}

TEST(Crossings, IslandsStayConnected) {
  // Figure 31 (c): cutting the black diagonal would leave a single black pixel.
  const Picture picture = ascii_picture({".....",  //
                                         ".#...",  //
                                         "..##.",  //
                                         "..##.",  //
                                         "....."});
  EXPECT_EQ(resolve(picture, kIslandsOnly).diagonals(1, 1), kMainDiagonal);
}

TEST(Crossings, AnIslandVotesOnceForBothEnds) {
  // Both black pixels are islands: still one vote, here outvoted by the sizes (2 black against 14 white).
  const Picture picture = ascii_picture({"....",  //
                                         ".#..",  //
                                         "..#.",  //
                                         "...."});
  EXPECT_EQ(resolve(picture, {0, -0.5, 5}).diagonals(1, 1), kAntiDiagonal);   // 6 against 5
  EXPECT_EQ(resolve(picture, {0, -0.25, 5}).diagonals(1, 1), kMainDiagonal);  // 3 against 5
}

TEST(Crossings, TiesCutBoth) {
  const Resolved result = resolve(ascii_picture({"r.",  //
                                                 ".r"}));
  EXPECT_EQ(result.crossings, 1);
  EXPECT_EQ(result.diagonals(0, 0), 0);
}

TEST(Crossings, VotesAreCastOnTheFrozenGraph) {
  // A cut must not lessen the votes of the next crossing: a symmetric board is cut symmetrically.
  const Picture board = ascii_picture({"#.#.#",  //
                                       ".#.#.",  //
                                       "#.#.#",  //
                                       ".#.#.",  //
                                       "#.#.#"});
  const Resolved result = resolve(board);
  EXPECT_EQ(result.crossings, 16);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      const int here = result.diagonals(x, y);
      const int mirrored = result.diagonals(3 - x, y);
      EXPECT_EQ(here == kMainDiagonal, mirrored == kAntiDiagonal) << x << ',' << y;
      EXPECT_EQ(here == 0, mirrored == 0) << x << ',' << y;
    }
  }
}

/// What is left in a block by curves alone, by either rule.
struct ByRule {
  int valence, continuity;

  friend bool operator==(const ByRule&, const ByRule&) = default;
};
ByRule by_curves(const Picture& picture, int x, int y) {
  const auto diagonals = [&](CurveRule rule) { return resolve(picture, {1, 0, 0, rule}).diagonals(x, y); };
  return {diagonals(CurveRule::valence), diagonals(CurveRule::continuity)};
}

TEST(Crossings, CurvesGoStraightOnWhereLinesCross) {
  // The black line that meets the blue one of seven links has eight, but crosses another after the sixth.
  const Picture picture = ascii_picture({"#...#.....",  //
                                         ".#.#......",  //
                                         "..#......b",  //
                                         ".#.#....b.",  //
                                         "#...#..b..",  //
                                         ".....#b...",  //
                                         ".....b#...",  //
                                         "....b..#..",  //
                                         "...b....#.",  //
                                         "..b......."});
  EXPECT_EQ(by_curves(picture, 5, 5), (ByRule{kAntiDiagonal, kMainDiagonal}));
}

TEST(Crossings, CurvesGoStraightOnPastABranch) {
  // The black line has three links up to the pixel beside the branch; the blue one has four.
  const Picture picture = ascii_picture({".....b",  //
                                         "####b.",  //
                                         ".#.b#.",  //
                                         ".#b..#",  //
                                         ".b...."});
  EXPECT_EQ(by_curves(picture, 3, 1), (ByRule{kAntiDiagonal, kMainDiagonal}));
}

TEST(Crossings, CurvesEndInAreas) {
  // The black line has four links up to the square, where it ends; as many as the blue one.
  const Picture picture = ascii_picture({".....b",  //
                                         "####b.",  //
                                         "##.b#.",  //
                                         "##b..#",  //
                                         ".b...."});
  EXPECT_EQ(by_curves(picture, 3, 1), (ByRule{kAntiDiagonal, 0}));
}

TEST(Crossings, CurvesEndInDithers) {
  // Diagonals of a checkerboard are no lines, however long they are: here all votes are ties but at the
  // border.
  Picture board(10, 10, palette_colour('.'));
  for (int y = 0; y < board.height; ++y) {
    for (int x = 0; x < board.width; ++x) board.at(x, y) = palette_colour((x + y) % 2 == 0 ? '#' : '.');
  }
  EXPECT_EQ(by_curves(board, 2, 1), (ByRule{0, 0}));
  EXPECT_EQ(by_curves(board, 4, 4), (ByRule{0, 0}));
}

TEST(Crossings, MergedBlocksOfOneSideCrossToo) {
  // Alike are the top two pixels and both diagonals, no others.
  Picture picture(2, 2);
  picture.pixels = {{100, 100, 100, 255}, {130, 130, 130, 255}, {170, 170, 170, 255}, {60, 60, 60, 255}};
  const Resolved result = resolve(picture, {}, Similarity::merge);
  EXPECT_EQ(result.crossings, 1);
  EXPECT_EQ(result.diagonals(0, 0), 0);  // both lie on one curve, in one component
  EXPECT_EQ(result.graph.links[result.graph.lattice.pixel(0, 0)], kNorthSide);
}

RC_GTEST_PROP(Crossings, EqualTheTextbook, (const Picture& picture)) {
  const Options options = *random_options();
  const auto weight = rc::gen::element(0.0, 0.5, 1.0, 2.0, 5.0);
  const CrossingVotes votes{*weight, *weight, *weight, options.curve_rule};
  SimilarityGraph graph;
  CrossingScratch scratch;
  build_similarity_graph(picture.view(), LinkCriteria::of(options), graph);
  const int crossings = resolve_crossings(graph, votes, scratch);

  NaiveGraph naive(picture, options);
  if (options.connect_lines) naive.connect_lines();
  naive.freeze();
  RC_ASSERT(crossings == naive.resolve(votes));
  for (int y = 0; y + 1 < picture.height; ++y) {
    for (int x = 0; x + 1 < picture.width; ++x) {
      const int expected = kMainDiagonal * naive.linked({x, y}, {x + 1, y + 1}) |
                           kAntiDiagonal * naive.linked({x + 1, y}, {x, y + 1});
      RC_ASSERT((graph.links[graph.lattice.pixel(x, y)] & kBothDiagonals) == expected);
    }
  }
}

RC_GTEST_PROP(Crossings, DoNotDependOnTheOrderOfBlocks, (const Picture& picture)) {
  // A flip or turn visits the blocks in another order.
  const CrossingVotes votes{.curve_rule = *rc::gen::element(CurveRule::valence, CurveRule::continuity)};
  const Resolved straight = resolve(picture, votes);
  const glm::ivec2 size(picture.width, picture.height);
  for (const Symmetry& symmetry : kSymmetries) {
    const Resolved other = resolve(symmetry(picture), votes);
    const bool swaps = symmetry.mirrored != (symmetry.quarter_turns % 2 == 1);
    for (int y = 0; y + 1 < picture.height; ++y) {
      for (int x = 0; x + 1 < picture.width; ++x) {
        const glm::ivec2 block = symmetry.pixel({x, y}, size - 1);
        int expected = straight.diagonals(x, y);
        if (swaps && expected != 0) expected ^= kBothDiagonals;
        RC_ASSERT(other.diagonals(block.x, block.y) == expected);
      }
    }
  }
}

TEST(Crossings, AFullCheckerboardIsResolvedLikeTheTextbook) {
  Picture board(40, 30, palette_colour('.'));
  for (int y = 0; y < board.height; ++y) {
    for (int x = 0; x < board.width; ++x) board.at(x, y) = palette_colour((x + y) % 2 == 0 ? '#' : '.');
  }
  const Resolved result = resolve(board);
  NaiveGraph naive(board, {});
  naive.freeze();
  EXPECT_EQ(result.crossings, naive.resolve({}));
  for (int y = 0; y + 1 < board.height; ++y) {
    for (int x = 0; x + 1 < board.width; ++x) {
      const int expected = kMainDiagonal * naive.linked({x, y}, {x + 1, y + 1}) |
                           kAntiDiagonal * naive.linked({x + 1, y}, {x, y + 1});
      ASSERT_EQ(result.diagonals(x, y), expected) << x << ',' << y;
    }
  }
}

}  // namespace
}  // namespace depixel::test
