#include "libdepixel/stages/cell_graph.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>

#include "libdepixel/stages/crossings.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

constexpr int kN = 1 << kNorth, kE = 1 << kEast, kS = 1 << kSouth, kW = 1 << kWest;

struct Cells {
  SimilarityGraph graph;
  Components components;
  CellGraph cells;

  CornerCode corner(int x, int y) const { return cells.corners[cells.lattice.corner(x, y)]; }
};

Cells build_cells(const Picture& picture, Similarity similarity = Similarity::exact,
                  bool connect_lines = false, const CrossingVotes& votes = {}) {
  Cells result;
  CrossingScratch scratch;
  const bool merges = similarity == Similarity::merge || connect_lines;
  build_similarity_graph(picture.view(), {similarity, connect_lines, kHqxLuma}, result.graph);
  resolve_crossings(result.graph, votes, scratch);
  if (merges) {
    label_components(result.graph, result.components);
    find_majority_colours(result.graph, result.components);
  }
  build_cell_graph(result.graph, merges ? &result.components : nullptr, result.cells);
  return result;
}

TEST(CornerCode, NodesOfTheFallingDiagonal) {
  // Figure 32: the link NW-SE splits the corner in a node towards the NE pixel and one towards the SW pixel.
  const CornerCode code(15, CornerCode::kNorthEast, true);
  EXPECT_EQ(code.node_quarters(kNorth), glm::ivec2(1, -1));
  EXPECT_EQ(code.node_quarters(kEast), glm::ivec2(1, -1));
  EXPECT_EQ(code.node_quarters(kSouth), glm::ivec2(-1, 1));
  EXPECT_EQ(code.node_quarters(kWest), glm::ivec2(-1, 1));
}

TEST(CornerCode, NodesOfTheRisingDiagonal) {
  const CornerCode code(15, CornerCode::kNorthWest, true);
  EXPECT_EQ(code.node_quarters(kNorth), glm::ivec2(-1, -1));
  EXPECT_EQ(code.node_quarters(kWest), glm::ivec2(-1, -1));
  EXPECT_EQ(code.node_quarters(kEast), glm::ivec2(1, 1));
  EXPECT_EQ(code.node_quarters(kSouth), glm::ivec2(1, 1));
}

TEST(CornerCode, UncutCornersHaveOneNode) {
  for (const auto pairing : {CornerCode::kOpposite, CornerCode::kNorthEast, CornerCode::kNorthWest}) {
    for (const Direction d : kDirections)
      EXPECT_EQ(CornerCode(15, pairing, false).node_quarters(d), glm::ivec2(0));
  }
}

TEST(CornerCode, PartnersArePairs) {
  for (const auto pairing : {CornerCode::kOpposite, CornerCode::kNorthEast, CornerCode::kNorthWest}) {
    const CornerCode code(15, pairing, false);
    for (const Direction d : kDirections) {
      EXPECT_NE(code.partner(d), d);
      EXPECT_EQ(code.partner(code.partner(d)), d);
    }
  }
}

TEST(CellGraph, DiagonalsCutTheirCornerInEveryOrientation) {
  // Two black pixels that touch at a corner, held together by their islands' vote.
  const Picture falling = ascii_picture({"....",  //
                                         ".#..",  //
                                         "..#.",  //
                                         "...."});
  for (const Symmetry& symmetry : kSymmetries) {
    const bool rises = symmetry.mirrored != (symmetry.quarter_turns % 2 == 1);
    const CornerCode code = build_cells(symmetry(falling)).corner(2, 2);
    EXPECT_EQ(code.visible_edges(), kN | kE | kS | kW);
    EXPECT_TRUE(code.is_cut());
    EXPECT_EQ(code.pairing(), rises ? CornerCode::kNorthWest : CornerCode::kNorthEast);
  }
}

TEST(CellGraph, ALoneCornerIsARightAngleCutByItsDiagonal) {
  // The three red pixels keep a diagonal, which cuts the corner of the white one: figure 32, a node a quarter
  // off.
  const CornerCode code = build_cells(ascii_picture({"rr",  //
                                                     "r."}))
                              .corner(1, 1);
  EXPECT_EQ(code.visible_edges(), kE | kS);
  EXPECT_TRUE(code.is_cut());
  EXPECT_EQ(code.partner(kEast), kSouth);
  EXPECT_EQ(code.node_quarters(kEast), glm::ivec2(1, 1));
}

TEST(CellGraph, StraightEdgesAreNotCut) {
  const Cells cells = build_cells(ascii_picture({"rr..",  //
                                                 "rr..",  //
                                                 "rr.."}));
  EXPECT_EQ(cells.corner(2, 1).visible_edges(), kN | kS);
  EXPECT_FALSE(cells.corner(2, 1).is_cut());
  EXPECT_EQ(cells.corner(2, 1).partner(kNorth), kSouth);
  EXPECT_EQ(cells.corner(1, 1).bits(), 0);
}

TEST(CellGraph, ContoursEndAtTheBorder) {
  const Cells cells = build_cells(ascii_picture({"r.",  //
                                                 "r.",  //
                                                 "gg"}));
  EXPECT_EQ(cells.corner(1, 0).visible_edges(), kS);
  EXPECT_TRUE(cells.corner(1, 0).ends(kSouth));
  EXPECT_EQ(cells.corner(0, 2).visible_edges(), kE);
  EXPECT_EQ(cells.corner(2, 2).visible_edges(), kW);
  EXPECT_EQ(cells.corner(1, 3).bits(), 0);
  EXPECT_EQ(cells.corner(0, 0).bits(), 0);
}

TEST(CellGraph, SharpContoursGoThroughAndTheShadingEnds) {
  // 4 and 5 are near, red is far from both: the edge between the greys ends.
  for (const Symmetry& symmetry : kSymmetries) {
    const Picture picture = symmetry(ascii_picture({"r5",  //
                                                    "r4"}));
    const CornerCode code = build_cells(picture).corner(1, 1);
    EXPECT_EQ(std::popcount(static_cast<unsigned>(code.visible_edges())), 3);
    int endings = 0;
    for (const Direction d : kDirections) {
      if (!code.ends(d)) continue;
      ++endings;
      // The edge that ends has the two greys on its sides.
      const std::array<glm::ivec2, 4> pixel_left_of{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
      const glm::ivec2 a = pixel_left_of[d], b = pixel_left_of[turned(d, 1)];
      EXPECT_TRUE(near_yuv(picture.at(a.x, a.y), picture.at(b.x, b.y)));
    }
    EXPECT_EQ(endings, 1);
  }
}

TEST(CellGraph, ShadingThatTurnsLetsTheSharpPairTurn) {
  // Both edges of the red pixel are sharp; between 0 and 4, which are 100 levels apart, runs a shading
  // contour.
  const Picture picture = ascii_picture({"0r",  //
                                         "44"});
  for (const Symmetry& symmetry : kSymmetries) {
    const glm::ivec2 size(2, 2);
    const CornerCode code = build_cells(symmetry(picture)).corner(1, 1);
    // The shading edge is that between pixels (0, 0) and (0, 1); it leaves the centre to their side.
    const glm::ivec2 to = symmetry({0, 1}, size) - symmetry({1, 1}, size);
    for (const Direction d : kDirections) EXPECT_EQ(code.ends(d), kStep[d] == to);
  }
}

TEST(CellGraph, OtherwiseOppositeEdgesPair) {
  for (const auto& rows : {std::vector<std::string_view>{"45",  //
                                                         "66"},
                           std::vector<std::string_view>{"rg",  //
                                                         "bb"}}) {
    const CornerCode code = build_cells(ascii_picture(rows)).corner(1, 1);
    EXPECT_EQ(code.visible_edges(), kN | kE | kW);
    EXPECT_TRUE(code.ends(kNorth));
    EXPECT_EQ(code.partner(kEast), kWest);
    EXPECT_EQ(build_cells(Symmetry{false, 1}(ascii_picture(rows))).corner(1, 1).partner(kNorth), kSouth);
  }
}

TEST(CellGraph, JunctionsOfFourPairOppositeEdges) {
  const CornerCode code = build_cells(ascii_picture({"rg",  //
                                                     "by"}))
                              .corner(1, 1);
  EXPECT_EQ(code.visible_edges(), 15);
  EXPECT_FALSE(code.is_cut());
  for (const Direction d : kDirections) EXPECT_EQ(code.partner(d), opposite(d));
}

TEST(CellGraph, MergedCellsAreOneRegionOfTheMajorityColour) {
  const Cells cells = build_cells(ascii_picture({"554",  //
                                                 "rrr"}),
                                  Similarity::merge);
  EXPECT_EQ(cells.corner(2, 1).visible_edges(), kE | kW);
  for (int x = 0; x < 3; ++x)
    EXPECT_EQ(cells.cells.colours[cells.cells.lattice.pixel(x, 0)], palette_colour('5'));
}

/// Two pixels belong to one region when their component is the same or, with exact similarity, their colour
/// is.
RC_GTEST_PROP(CellGraph, EdgesAreVisibleWhereCellsDiffer, (Picture picture)) {
  const bool merge = *rc::gen::arbitrary<bool>();
  const Cells cells = build_cells(picture, merge ? Similarity::merge : Similarity::exact);
  const Lattice& lattice = cells.cells.lattice;
  const auto differ = [&](int x0, int y0, int x1, int y1) {
    if (!picture.contains(x0, y0) || !picture.contains(x1, y1)) return false;  // the border is no contour
    const int p = lattice.pixel(x0, y0), q = lattice.pixel(x1, y1);
    if (merge) return cells.components.label[p] != cells.components.label[q];
    return !(cells.graph.pixels[p] == cells.graph.pixels[q]);
  };
  for (int y = 0; y <= picture.height; ++y) {
    for (int x = 0; x <= picture.width; ++x) {
      const int expected = kN * differ(x - 1, y - 1, x, y - 1) | kE * differ(x, y - 1, x, y) |
                           kS * differ(x - 1, y, x, y) | kW * differ(x - 1, y - 1, x - 1, y);
      RC_ASSERT(cells.corner(x, y).visible_edges() == expected);
    }
  }
}

RC_GTEST_PROP(CellGraph, AtMostOneContourEndsInsideAndOnlyAtThreeWayCorners, (const Picture& picture)) {
  const bool merge = *rc::gen::arbitrary<bool>();
  const Cells cells = build_cells(picture, merge ? Similarity::merge : Similarity::exact);
  for (int y = 1; y < picture.height; ++y) {
    for (int x = 1; x < picture.width; ++x) {
      const CornerCode code = cells.corner(x, y);
      const int visible = std::popcount(static_cast<unsigned>(code.visible_edges()));
      int endings = 0;
      for (const Direction d : kDirections) endings += code.ends(d) ? 1 : 0;
      RC_ASSERT(visible != 1);
      RC_ASSERT(endings == (visible == 3 ? 1 : 0));
      const int links = cells.graph.links[cells.graph.lattice.pixel(x - 1, y - 1)] & kBothDiagonals;
      RC_ASSERT(code.is_cut() == (visible > 0 && links != 0));
    }
  }
}

RC_GTEST_PROP(CellGraph, BuffersOfAnotherFrameLeaveNoTrace, (const Picture& first)) {
  Picture second(first.width, first.height, palette_colour('b'));
  paste(second, *random_picture(), 0, 0);
  Cells reused = build_cells(first), fresh = build_cells(second);
  build_cell_graph(fresh.graph, nullptr, reused.cells);
  for (std::size_t i = 0; i < fresh.cells.corners.size(); ++i) {
    RC_ASSERT(reused.cells.corners[i].bits() == fresh.cells.corners[i].bits());
  }
  RC_ASSERT(reused.cells.colours == fresh.cells.colours);
}

}  // namespace
}  // namespace depixel::test
