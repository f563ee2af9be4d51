#include "libdepixel/stages/components.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>

#include "tests/support/naive_graph.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

struct Labelled {
  SimilarityGraph graph;
  Components components;

  int label(int x, int y) const { return components.label[graph.lattice.pixel(x, y)]; }
};

Labelled label(const Picture& picture, Similarity similarity = Similarity::exact) {
  Labelled result;
  CrossingScratch scratch;
  build_similarity_graph(picture.view(), {similarity, false, kHqxLuma}, result.graph);
  resolve_crossings(result.graph, {}, scratch);
  label_components(result.graph, result.components);
  find_majority_colours(result.graph, result.components);
  return result;
}

TEST(Components, AreNumberedByTheirFirstPixels) {
  const Labelled result = label(ascii_picture({"r.r",  //
                                               "r.r",  //
                                               "rrr"}));
  EXPECT_EQ(result.components.count, 2);
  EXPECT_EQ(result.label(0, 0), 0);
  EXPECT_EQ(result.label(1, 0), 1);
  EXPECT_EQ(result.label(2, 0), 0);
  EXPECT_EQ(result.components.size, (std::vector<int>{7, 2}));
}

TEST(Components, AreSplitWhereCrossingsWereCut) {
  const Labelled tie = label(ascii_picture({"r.",  //
                                            ".r"}));
  EXPECT_EQ(tie.components.count, 4);
}

TEST(Components, MajorityColour) {
  const Labelled result = label(ascii_picture({"4555",  //
                                               "4r44"}),
                                Similarity::merge);
  ASSERT_EQ(result.components.count, 2);
  EXPECT_EQ(result.components.colour[0], palette_colour('4'));
  EXPECT_EQ(result.components.colour[1], palette_colour('r'));
}

TEST(Components, MajorityColourOfATieIsTheLowest) {
  const Labelled result = label(ascii_picture({"55",  //
                                               "44"}),
                                Similarity::merge);
  ASSERT_EQ(result.components.count, 1);
  EXPECT_EQ(result.components.colour[0], palette_colour('4'));
}

RC_GTEST_PROP(Components, EqualBreadthFirstSearch, (Picture picture)) {
  const Similarity similarity = *rc::gen::element(Similarity::exact, Similarity::merge);
  const Labelled result = label(picture, similarity);
  NaiveGraph naive(picture, {.similarity = similarity, .merge_luma = 48});
  naive.freeze();
  naive.resolve({});
  const auto expected = naive.components();
  RC_ASSERT(result.components.count == static_cast<int>(expected.size()));
  for (int c = 0; c < result.components.count; ++c) {
    RC_ASSERT(result.components.size[c] == static_cast<int>(expected[c].size()));
    std::map<std::uint32_t, int> votes;
    for (const auto& [x, y] : expected[c]) {
      RC_ASSERT(result.label(x, y) == c);
      ++votes[rgba_order(normalized(picture.at(x, y)))];
    }
    // The first of the largest, in ascending order of colours.
    const auto best = std::max_element(votes.begin(), votes.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    RC_ASSERT(rgba_order(result.components.colour[c]) == best->first);
  }
}

RC_GTEST_PROP(Components, PaddingHasNoLabel, (const Picture& picture)) {
  const Labelled result = label(picture);
  int labelled = 0;
  for (const int l : result.components.label) labelled += l >= 0 ? 1 : 0;
  RC_ASSERT(labelled == picture.width * picture.height);
}

}  // namespace
}  // namespace depixel::test
