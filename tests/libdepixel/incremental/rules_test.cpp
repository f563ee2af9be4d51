#include "libdepixel/incremental/rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "libdepixel/incremental/picture_updater.hpp"
#include "tests/support/ascii_picture.hpp"

namespace depixel::test {
namespace {

/// Two frames of which the second goes wrong without a rule, and the first does not.
struct RuleCase {
  std::string_view rule;
  Picture before, after;
  Options options = {};
};

constexpr Options kOnlyContinuousCurves{
    .curve_rule = CurveRule::continuity, .sparse_weight = 0, .island_weight = 0};

constexpr Options kBlendedDithers{.dither = DitherKind::blend};

/// The smallest that a search over random sequences came to.
std::vector<RuleCase> rule_cases() {
  const Picture letter = ascii_picture({".......",  //
                                        "..####.",  //
                                        ".#.....",  //
                                        ".#.....",  //
                                        ".#.....",  //
                                        "..####.",  //
                                        "......."});
  Picture beside_letter = letter;
  beside_letter.at(0, 0) = palette_colour('4');
  return {
      {"dithers_by_pixels",
       ascii_picture({".#.#",  //
                      "#.#.",  //
                      ".#.#",  //
                      "#.#."}),
       ascii_picture({".4.4",  //
                      "4.4.",  //
                      ".4.4",  //
                      "4.4."}),
       kBlendedDithers},
      // One pixel changes, and what is left is no area.
      {"dithers_by_areas",
       ascii_picture({".#.#",  //
                      "#.#.",  //
                      ".#.#",  //
                      "#.#."}),
       ascii_picture({".#.#",  //
                      "#4#.",  //
                      ".#.#",  //
                      "#.#."}),
       kBlendedDithers},
      // The link is the first row's, the pixel that changes is in the second.
      {"links_by_pixels",
       ascii_picture({"..",  //
                      ".."}),
       ascii_picture({"..",  //
                      "4."})},
      // All goes one pixel east but for the westernmost block: two white pixels come together where they
      // meet.
      {"links_by_seams", ascii_picture({"...4..4.44"}), ascii_picture({"...4..4..4"})},
      // A component grows by a pixel beside the crossings, and is as sparse as it was no more. Most of the
      // frame
      // is empty: where little of it is, all crossings are resolved.
      {"crossings_by_windows",
       ascii_picture({".#.#.....................",  //
                      "#.#......................",  //
                      "4.#4....................."}),
       ascii_picture({".#.#.....................",  //
                      "#.#4.....................",  //
                      "4.#4....................."})},
      // The two curves that cross are as long as each other no more; the westernmost crossings lie too far
      // from the change to see it in their windows.
      {"crossings_by_curves",
       ascii_picture({".4.4.4.4.4.4.4.4.",  //
                      "4.4.4.4.4.4.4.4.4"}),
       ascii_picture({".4.4.4.4.4.4.4.4#",  //
                      "4.4.4.4.4.4.4.4.4"})},
      // The line in the second row ends where it becomes part of an area, though the pixel there is linked as
      // it was; so the crossings in the west are cut otherwise.
      {"crossings_by_junctions",
       ascii_picture({"...4.4.4.4.4.4.4....4###",  //
                      "##4.4.4.4.4.4.4.4444444#"}),
       ascii_picture({"...4.4.4.4.4.4.4....44##",  //
                      "##4.4.4.4.4.4.4.4444444#"}),
       kOnlyContinuousCurves},
      // The eastern part goes two pixels west: the lower curve is shorter by as much, and its crossings with
      // the upper one, far in the west, are cut otherwise.
      {"crossings_by_seams",
       ascii_picture({".4.4.4.4.4...4.4.4.4.4.4.4.4.4.4.4.#.4.4.4.",  //
                      "4.4.4.4.4#4.4.4.4.4.4.4.4.4.4.4.4.4.#.4.4.4"}),
       ascii_picture({".4.4.4.4.4...4.4.4.4.4.4.4.4.4.4.#.4.4.4.4.",  //
                      "4.4.4.4.4#4.4.4.4.4.4.4.4.4.4.4.4.#.4.4.4.4"})},
      // The same two pixels are linked before and after, but the junction pairs its contours otherwise.
      {"codes_by_pixels",
       ascii_picture({"#5",  //
                      "75"}),
       ascii_picture({"4R",  //
                      "#R"})},
      // Crossings in the east are cut otherwise, as their curves are.
      {"codes_by_crossings",
       ascii_picture({".4.4.4.4.4.4.4.4.",  //
                      "4.4.4#4.4.4.4.4.4"}),
       ascii_picture({".4.4.4.4.4.4.4.4.",  //
                      "4.4.4#..4.4.4.4.4"})},
      {"marks_by_links",
       ascii_picture({".4",  //
                      "55"}),
       ascii_picture({".5",  //
                      "55"})},
      // A round letter beside a pixel that changes.
      {"text_by_marks", letter, beside_letter, {.text_safe = true}},
      {"edges_by_codes",  //
       ascii_picture({"R4"}), ascii_picture({"44"})},
      {"curves_by_codes",
       ascii_picture({"4.4",  //
                      "44#"}),
       ascii_picture({"_.4",  //
                      "__#"})},
      // The slanted line grows a thick end, so its pixels are thin no more; farther along it, no code
      // differs.
      {"curves_by_marks",
       ascii_picture({"4..",  //
                      "b44",  //
                      "..5"}),
       ascii_picture({"4..",  //
                      "b44",  //
                      "..4"})},
      // The contours in the west end in others where the east begins, which goes one pixel east.
      {"curves_by_seams",
       ascii_picture({"444.4..4.4.",  //
                      "4..4....4.4"}),
       ascii_picture({"444.4..44.4",  //
                      "4..4.....4."})},
      // The lower junction is as it was, but the contour that goes through has another curve.
      {"joints_by_curves",
       ascii_picture({"4.",  //
                      "#4",  //
                      ".4"}),
       ascii_picture({"5.",  //
                      "#4",  //
                      ".4"})},
      {"tiles_by_curves",
       ascii_picture({"...4",  //
                      "444.",  //
                      "...4"}),
       ascii_picture({"...4",  //
                      "444.",  //
                      "..44"})},
      {"tiles_by_colours", ascii_picture({"R"}), ascii_picture({"_"})},
      // The curve below the 4s bulges into their row, whose own colours stay and which is drawn by itself.
      {"tiles_by_side_colours",
       ascii_picture({"...",  //
                      "44.",  //
                      "gg4"}),
       ascii_picture({"...",  //
                      "44.",  //
                      "##4"})},
      // Tiles in the east, which goes one pixel east, have curves from beyond the seam in them.
      {"tiles_by_seams",
       ascii_picture({"..4.444.4.",  //
                      "....4.44.4",  //
                      "...44444.4"}),
       ascii_picture({"..4.444..4",  //
                      "....4.444.",  //
                      "....44444."})},
      // A pixel changes in a component that keeps its colour: what runs to it from beside changes with it.
      {"tiles_by_shading",
       ascii_picture({"455444"}),
       ascii_picture({"454444"}),
       {.similarity = Similarity::merge, .merge_luma = 48, .shading = ShadingKind::gradient}},
  };
}

/// What goes wrong in a frame.
struct Wrong {
  bool map = false, pixels = false;

  bool any() const { return map || pixels; }
};

/// Vectorizes and draws two frames, one after the other. \return what was wrong in each.
std::array<Wrong, 2> played(const RuleCase& c, RuleSet rules) {
  constexpr int kScale = 4;
  IncrementalVectorizer vectorizer(rules);
  Vectorizer scratch;
  PictureUpdater updater;
  Picture out(kScale * c.before.width, kScale * c.before.height);
  std::array<Wrong, 2> wrong;
  for (const int frame : {0, 1}) {
    const Picture& picture = frame == 0 ? c.before : c.after;
    const View view{kScale, kScale, 0, 0};
    vectorizer.vectorize(picture.view(), c.options);
    updater.draw(vectorizer, vectorizer.changes(), view, false, 1, out.target(), true);
    Picture expected(out.width, out.height);
    CpuRaster().draw(scratch.vectorize(picture.view(), c.options), view, false, 1, expected.target());
    wrong[frame] = {!(vectorizer.map() == scratch.map()), !(out == expected)};
  }
  return wrong;
}

class Rules : public testing::TestWithParam<int> {};

TEST_P(Rules, AreNeeded) {
  const std::string_view name = kRuleNames[GetParam()];
  const std::vector<RuleCase> cases = rule_cases();
  const auto found =
      std::find_if(cases.begin(), cases.end(), [&](const RuleCase& c) { return c.rule == name; });
  ASSERT_NE(found, cases.end()) << "there is no case for this rule";

  const auto [first, second] = played(*found, {});
  EXPECT_FALSE(first.any());
  EXPECT_FALSE(second.any());

  const auto [first_without, second_without] =
      played(*found, RuleSet{}.without(static_cast<Rule>(GetParam())));
  EXPECT_FALSE(first_without.any());
  EXPECT_TRUE(second_without.any());
  // Rules about tiles are those of pictures.
  EXPECT_EQ(second_without.map, !name.starts_with("tiles_"));
}

INSTANTIATE_TEST_SUITE_P(All, Rules, testing::Range(0, static_cast<int>(kRuleNames.size())),
                         [](const auto& tested) { return std::string(kRuleNames[tested.param]); });

TEST(RuleSet, HoldsAllRulesButThoseTakenAway) {
  constexpr auto kFirst = Rule::dithers_by_pixels, kLast = Rule::tiles_by_shading;
  EXPECT_EQ(kRuleNames.size(), static_cast<std::size_t>(kLast) + 1);
  constexpr RuleSet kAll, kSome = kAll.without(kFirst).without(kLast);
  for (std::size_t i = 0; i < kRuleNames.size(); ++i) {
    const auto rule = static_cast<Rule>(i);
    EXPECT_TRUE(kAll.has(rule));
    EXPECT_EQ(kSome.has(rule), rule != kFirst && rule != kLast);
  }
}

}  // namespace
}  // namespace depixel::test
