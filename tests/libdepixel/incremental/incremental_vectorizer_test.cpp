#include "libdepixel/incremental/incremental_vectorizer.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/map_segments.hpp"
#include "tests/support/random_sequences.hpp"
#include "tests/support/test_pictures.hpp"

namespace depixel::test {
namespace {

/// Vectorizes frame after frame, incrementally and from scratch.
class Both {
 public:
  /// \return empty if both maps are equal, else how they differ.
  std::string mismatch(const SequenceFrame& frame) {
    if (frame.is_reset) incremental_.reset();
    incremental_.vectorize(frame.picture.view(), frame.options);
    const PlanarMap &expected = scratch_.vectorize(frame.picture.view(), frame.options),
                    &actual = incremental_.map();
    if (actual == expected) {
      const int segments = incremental_.stats().segments;
      return segments == scratch_.stats().segments ? "" : std::to_string(segments) + " segments are counted";
    }
    if (!(actual.lattice == expected.lattice)) return "the size differs";
    const std::string segments = difference(free_segments(expected), free_segments(actual));
    return segments.empty() ? "segments are the same, but not colours or their order" : segments;
  }

  const IncrementalVectorizer& incremental() const { return incremental_; }

 private:
  IncrementalVectorizer incremental_;
  Vectorizer scratch_;
};

/// Empty if the maps of all frames are those made from scratch, else how the first one differs.
std::string first_mismatch(const Sequence& sequence) {
  Both both;
  for (std::size_t i = 0; i < sequence.frames.size(); ++i) {
    const std::string found = both.mismatch(sequence.frames[i]);
    if (!found.empty()) return "frame " + std::to_string(i) + ": " + found;
  }
  return "";
}

RC_GTEST_PROP(IncrementalVectorizer, MapsAreThoseMadeFromScratch, (const Sequence& sequence)) {
  const std::string found = first_mismatch(sequence);
  if (!found.empty()) RC_FAIL(found);
}

TEST(IncrementalVectorizer, PixelsWithoutLinksAreThinFromTheFirstFrameOn) {
  EXPECT_EQ(first_mismatch({{{ascii_picture({"#.",  //
                                             "rr"}),
                              {}}}}),
            "");
}

TEST(IncrementalVectorizer, ContoursAlongASeamSeeWhatIsThinBeyondIt) {
  // The lowest row stays; of the rows that come down on it, the lowest is part of an area, not of a line.
  EXPECT_EQ(first_mismatch({{{ascii_picture({"....g", "....g", "....g", "....g",  //
                                             "....g", "....g", "....g", "ggggg",  //
                                             ".4.4."}),
                              {}},
                             {ascii_picture({"g....", "g....", "g....", "g....",  //
                                             "ggggg", "ggggg", "ggggg", "ggggg",  //
                                             ".4.4."}),
                              {}}}}),
            "");
}

TEST(IncrementalVectorizer, MapsOfLongSequencesAreThoseMadeFromScratch) {
  for (const unsigned seed : {1U, 2U}) {
    EXPECT_EQ(first_mismatch(fixed_sequence(seed, {.max_width = 40, .max_height = 32, .steps = 250})), "");
  }
}

class ThinFrames : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(ThinFrames, MapsAreThoseMadeFromScratch) {
  const auto& [width, height] = GetParam();
  Both both;
  for (unsigned seed = 1; seed < 4; ++seed) {
    for (SequenceFrame frame :
         fixed_sequence(seed, {.max_width = 20, .max_height = 20, .steps = 60}).frames) {
      Picture cut(width, height, palette_colour('.'));
      paste(cut, frame.picture, 0, 0);
      frame.picture = cut;
      ASSERT_EQ(both.mismatch(frame), "") << cut;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(IncrementalVectorizer, ThinFrames,
                         testing::Values(std::pair{1, 1}, std::pair{1, 2}, std::pair{2, 1}, std::pair{1, 19},
                                         std::pair{19, 1}, std::pair{2, 19}, std::pair{17, 2}));

/// A picture with all that there is to be found: slopes, thin lines, T-junctions, junctions of four, dots.
Picture varied_picture() {
  return ascii_picture({"................................",  //
                        "..rrrrrrrrr.........#...........",  //
                        "..rrrrrrrrrr.......#............",  //
                        "..rrrrggggggg.....#......#.#.#..",  //
                        "..rrrrggggggg....#......#.#.#...",  //
                        "..yyyyybbbbb....#........#.#.#..",  //
                        "...yyyybbbb....#........#.#.#...",  //
                        "....yyybbb......................",  //
                        "................ccc.............",  //
                        "......####.....ccccc....mmmm....",  //
                        ".....#....#....ccccc....mmmm....",  //
                        "....#......#...ccccc....mmmm....",  //
                        "....#......#....ccc.............",  //
                        ".....#....#.....................",  //
                        "......####......................",  //
                        "................................"});
}

/// A picture of 3 x 3 busy ones.
Picture large_picture() {
  const Picture one = varied_picture();
  Picture whole(3 * one.width, 3 * one.height);
  for (int i = 0; i < 9; ++i) paste(whole, one, i % 3 * one.width, i / 3 * one.height);
  return whole;
}

Picture with_colour(Picture picture, char from, char to) {
  std::replace(picture.pixels.begin(), picture.pixels.end(), palette_colour(from), palette_colour(to));
  return picture;
}

TEST(IncrementalVectorizer, TheFirstFrameIsNewEverywhere) {
  Both both;
  ASSERT_EQ(both.mismatch({varied_picture(), {}}), "");
  EXPECT_TRUE(both.incremental().changes().everything);
  EXPECT_EQ(both.incremental().stats().changed_tiles, 32 * 16);
  EXPECT_EQ(both.incremental().stats().moved_tiles, 0);
}

TEST(IncrementalVectorizer, TheSameFrameAgainChangesNothing) {
  Both both;
  ASSERT_EQ(both.mismatch({varied_picture(), {}}), "");
  const VectorizeStats& stats = both.incremental().stats();
  EXPECT_EQ(stats.stale_corners, (varied_picture().width + 1) * (varied_picture().height + 1));
  ASSERT_EQ(both.mismatch({varied_picture(), {}}), "");
  EXPECT_FALSE(both.incremental().changes().any());
  EXPECT_EQ(stats.changed_pixels, 0);
  EXPECT_EQ(stats.stale_corners, 0);
  EXPECT_EQ(stats.contours, 0);
  EXPECT_EQ(stats.fitted_shapes, 0);
  EXPECT_EQ(stats.changed_tiles, 0);
  EXPECT_EQ(stats.moved_tiles, 0);
}

TEST(IncrementalVectorizer, TransparentPixelsOfOtherColoursAreTheSame) {
  IncrementalVectorizer vectorizer;
  Picture picture = with_colour(varied_picture(), '.', '_');
  vectorizer.vectorize(picture.view(), {});
  for (Rgba& c : picture.pixels) {
    if (c.a == 0) c = {9, 8, 7, 0};
  }
  vectorizer.vectorize(picture.view(), {});
  EXPECT_EQ(vectorizer.stats().changed_pixels, 0);
  EXPECT_FALSE(vectorizer.changes().any());
}

TEST(IncrementalVectorizer, AFadeThatKeepsWhatIsEqualTracesAndFitsNothing) {
  Both both;
  const Picture before = varied_picture();
  ASSERT_EQ(both.mismatch({before, {}}), "");
  // Of two colours only, so that no pairing at a T-junction looks at them anew.
  const Picture after = with_colour(with_colour(before, 'c', 'e'), 'm', 'f');
  ASSERT_EQ(both.mismatch({after, {}}), "");
  const VectorizeStats& stats = both.incremental().stats();
  EXPECT_GT(stats.changed_pixels, 0);
  EXPECT_EQ(stats.stale_corners, 0);
  EXPECT_EQ(stats.contours, 0);
  EXPECT_EQ(stats.fitted_shapes, 0);
  EXPECT_FALSE(both.incremental().changes().everything);
  EXPECT_GE(stats.changed_tiles, stats.changed_pixels);
}

TEST(IncrementalVectorizer, AScrollMovesTiles) {
  for (const glm::ivec2 by : {glm::ivec2(1, 0), glm::ivec2(-2, 1), glm::ivec2(0, -3)}) {
    Both both;
    ASSERT_EQ(both.mismatch({hills({0, 0}), {}}), "");
    const int shapes = both.incremental().stats().fitted_shapes;
    ASSERT_EQ(both.mismatch({hills(-by), {}}), "");
    const VectorizeStats& stats = both.incremental().stats();
    const std::vector<glm::ivec2>& moves = both.incremental().changes().moves;
    EXPECT_NE(std::find(moves.begin(), moves.end(), by), moves.end());
    EXPECT_LT(stats.changed_tiles, stats.pixels / 4);
    EXPECT_GT(stats.moved_tiles, 2 * stats.changed_tiles);
    EXPECT_LT(stats.fitted_shapes, shapes);  // those that the border cuts
  }
}

TEST(IncrementalVectorizer, ASmallChangeTracesALittle) {
  Both both;
  Picture picture = large_picture();
  ASSERT_EQ(both.mismatch({picture, {}}), "");
  const int nodes = both.incremental().stats().nodes;
  picture.at(40, 40) = palette_colour('b');
  ASSERT_EQ(both.mismatch({picture, {}}), "");
  const VectorizeStats& stats = both.incremental().stats();
  EXPECT_EQ(stats.changed_pixels, 1);
  EXPECT_GT(stats.stale_corners, 0);
  EXPECT_LE(stats.stale_corners, 16);
  EXPECT_LT(stats.nodes, nodes / 10);
  EXPECT_GT(stats.changed_tiles, 0);
  EXPECT_LT(stats.changed_tiles, 64);
}

TEST(IncrementalVectorizer, TilesBeyondTheFrameAreTheSame) {
  Picture picture(21, 6, palette_colour('.'));
  IncrementalVectorizer vectorizer;
  vectorizer.vectorize(picture.view(), {});
  paste(picture, Picture(4, 2, palette_colour('r')), 17, 2);  // edges end at the border
  vectorizer.vectorize(picture.view(), {});
  const MapChanges& changes = vectorizer.changes();
  ASSERT_FALSE(changes.everything);
  EXPECT_GT(changes.new_tiles, 0);
  const auto unlike = std::count_if(changes.tiles.begin(), changes.tiles.end(),
                                    [](std::uint8_t tile) { return tile != MapChanges::kSame; });
  EXPECT_EQ(unlike, changes.new_tiles + changes.moved_tiles);
}

TEST(IncrementalVectorizer, OtherOptionsMakeAllNew) {
  Both both;
  ASSERT_EQ(both.mismatch({varied_picture(), {}}), "");
  for (const Smoothing smoothing : {Smoothing::average, Smoothing::none, Smoothing::energy}) {
    Options options;
    options.smoothing = smoothing;
    ASSERT_EQ(both.mismatch({varied_picture(), options}), "");
    EXPECT_TRUE(both.incremental().changes().everything);
  }
}

TEST(IncrementalVectorizer, OptionsOfDrawingAndThreadsMakeNothingNew) {
  Both both;
  ASSERT_EQ(both.mismatch({varied_picture(), {}}), "");
  Options options;
  options.linear_light = true;
  options.threads = 3;
  ASSERT_EQ(both.mismatch({varied_picture(), options}), "");
  EXPECT_FALSE(both.incremental().changes().any());
}

/// Alternating colours are how old displays showed more of them.
TEST(IncrementalVectorizer, DithersThatSwapTheirColoursChangeNothing) {
  constexpr Options kBlend{.dither = DitherKind::blend};
  Both both;
  for (int phase = 0; phase < 4; ++phase) {
    Picture picture = large_picture();
    for (int y = 4; y < 20; ++y) {
      for (int x = 5; x < 25; ++x) picture.at(x, y) = palette_colour("08"[(x + y + phase) % 2]);
    }
    ASSERT_EQ(both.mismatch({picture, kBlend}), "");
    EXPECT_EQ(both.incremental().changes().any(), phase == 0);
  }
}

TEST(IncrementalVectorizer, DithersAreBlendedInTheLightOfEdges) {
  const Picture picture = ascii_picture({".#.#",  //
                                         "#.#.",  //
                                         ".#.#",  //
                                         "#.#."});
  Both both;
  ASSERT_EQ(both.mismatch({picture, {.dither = DitherKind::blend}}), "");
  ASSERT_EQ(both.mismatch({picture, {.dither = DitherKind::blend, .linear_light = true}}), "");
  EXPECT_TRUE(both.incremental().changes().any());
}

TEST(IncrementalVectorizer, AResetMakesAllNew) {
  Both both;
  ASSERT_EQ(both.mismatch({varied_picture(), {}}), "");
  ASSERT_EQ(both.mismatch({varied_picture(), {}, true}), "");
  EXPECT_TRUE(both.incremental().changes().everything);
  EXPECT_EQ(both.incremental().stats().changed_pixels, 32 * 16);
}

TEST(IncrementalVectorizer, ANewSizeMakesAllNew) {
  Both both;
  ASSERT_EQ(both.mismatch({varied_picture(), {}}), "");
  ASSERT_EQ(both.mismatch({large_picture(), {}}), "");
  EXPECT_TRUE(both.incremental().changes().everything);
  ASSERT_EQ(both.mismatch({Symmetry{false, 1}(large_picture()), {}}), "");
  EXPECT_TRUE(both.incremental().changes().everything);
}

TEST(IncrementalVectorizer, BeginsAnewWhenItsTableIsFull) {
  Both both;
  std::uint32_t state = 1;
  std::size_t before = 0, most = 0;
  int begun_anew = 0;
  for (int frame = 0; frame < 120; ++frame) {
    Picture noise(24, 24);
    for (Rgba& c : noise.pixels) {
      state = state * 1664525 + 1013904223;
      c = palette_colour(".#r"[(state >> 24) % 3]);
    }
    ASSERT_EQ(both.mismatch({noise, {}}), "") << "frame " << frame;
    const std::size_t size = both.incremental().table().size();
    begun_anew += size < before ? 1 : 0;
    most = std::max(most, size);
    before = size;
  }
  EXPECT_GT(begun_anew, 0);
  EXPECT_GT(most, std::size_t{1} << 14);
  EXPECT_LT(most, std::size_t{1} << 15);
}

}  // namespace
}  // namespace depixel::test
