#include "libdepixel/incremental/line_tiles_updater.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>

#include "tests/support/random_sequences.hpp"

namespace depixel::test {
namespace {

/// A copy of the records, kept up to date by what an updater tells that it wrote.
class Records {
 public:
  void copy_new(const LineTilesUpdater& updater) {
    const std::vector<Tile>& tiles = updater.tiles().tiles();
    const std::vector<TileLine>& lines = updater.tiles().lines();
    width_ = updater.tiles().width();
    if (updater.is_all_new()) {
      tiles_ = tiles;
      lines_ = lines;
      copied_tiles_ = std::ssize(tiles);
      return;
    }
    copied_tiles_ = 0;
    for (const TileBox& box : updater.new_boxes()) {
      copied_tiles_ += box.area();
      for (int y = box.north; y < box.south; ++y) {
        const int first = y * width_ + box.west;
        std::copy_n(tiles.begin() + first, box.width(), tiles_.begin() + first);
      }
    }
    lines_.resize(lines.size());
    const auto first_new = static_cast<std::ptrdiff_t>(updater.first_new_line());
    std::copy(lines.begin() + first_new, lines.end(), lines_.begin() + first_new);
  }

  std::int64_t copied_tiles() const { return copied_tiles_; }

  /// Empty if all tiles are those of a map that is cut from scratch, else which one is not.
  std::string mismatch(const LineTiles& scratch) const {
    if (width_ != scratch.width() || tiles_.size() != scratch.tiles().size()) return "another size";
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
      const Tile &tile = tiles_[i], &expected = scratch.tiles()[i];
      const auto first = lines_.begin() + tile.first;
      const bool is_same = tile.colour == expected.colour && tile.count == expected.count &&
                           tile.first + tile.count <= lines_.size() &&
                           std::equal(first, first + tile.count, scratch.lines().begin() + expected.first);
      if (!is_same) return "tile " + std::to_string(i % width_) + ", " + std::to_string(i / width_);
    }
    return "";
  }

 private:
  int width_ = 0;
  std::vector<Tile> tiles_;
  std::vector<TileLine> lines_;
  std::int64_t copied_tiles_ = 0;
};

LineTiles cut_anew(const IncrementalVectorizer& vectorizer, glm::dvec2 scale, TileEncoding encoding) {
  LineTiles tiles;
  tiles.build(vectorizer.map(), scale, encoding);
  return tiles;
}

/// A picture with much in it, in which nothing repeats.
Picture busy_picture(int width, int height) {
  Picture picture(width, height);
  std::uint32_t state = 1;
  for (Rgba& c : picture.pixels) {
    state = state * 1664525 + 1013904223;
    c = palette_colour(".#rg"[state >> 30]);
  }
  return picture;
}

RC_GTEST_PROP(LineTilesUpdater, TilesAreThoseCutFromScratch, (const Sequence& sequence)) {
  IncrementalVectorizer vectorizer;
  LineTilesUpdater updater;
  Records records;
  MapChanges changes;
  glm::dvec2 scale(3, 3);
  for (const SequenceFrame& frame : sequence.frames) {
    if (frame.is_reset) vectorizer.reset();
    vectorizer.vectorize(frame.picture.view(), frame.options);
    changes.add(vectorizer.changes());
    if (*rc::gen::inRange(0, 4) == 0) continue;  // several frames between two updates
    if (*rc::gen::inRange(0, 8) == 0) scale = {*rc::gen::element(0.5, 2.7, 16.0), 2};
    const auto encoding = frame.options.has_shading()  ? TileEncoding::regions
                          : frame.options.linear_light ? TileEncoding::light
                                                       : TileEncoding::levels;
    updater.update(vectorizer, changes, scale, encoding);
    changes.set_nothing();
    records.copy_new(updater);
    const LineTiles scratch = cut_anew(vectorizer, scale, encoding);
    RC_ASSERT(records.mismatch(scratch) == "");
    RC_ASSERT(updater.tiles() == scratch);
    std::size_t lines = 0;
    for (const Tile& tile : updater.tiles().tiles()) lines += tile.count;
    RC_ASSERT(updater.tiles().used_lines() == lines);
    RC_ASSERT(updater.tiles().lines().size() <= std::max<std::size_t>(2 * lines, scratch.lines().size()));
  }
}

TEST(LineTilesUpdater, WritesNothingWhereNothingChanged) {
  const Picture picture = busy_picture(40, 30);
  IncrementalVectorizer vectorizer;
  LineTilesUpdater updater;
  for (const bool is_first : {true, false}) {
    vectorizer.vectorize(picture.view(), {});
    updater.update(vectorizer, vectorizer.changes(), {3, 3}, TileEncoding::levels);
    EXPECT_EQ(updater.is_all_new(), is_first);
  }
  EXPECT_TRUE(updater.new_boxes().empty());
  EXPECT_EQ(updater.first_new_line(), updater.tiles().lines().size());
}

TEST(LineTilesUpdater, WritesLittleWhereLittleChanged) {
  Picture picture = busy_picture(100, 80);
  IncrementalVectorizer vectorizer;
  LineTilesUpdater updater;
  Records records;
  for (const Rgba colour : {palette_colour('b'), palette_colour('4')}) {
    picture.at(50, 40) = picture.at(10, 70) = colour;
    vectorizer.vectorize(picture.view(), {});
    updater.update(vectorizer, vectorizer.changes(), {3, 3}, TileEncoding::levels);
    records.copy_new(updater);
  }
  EXPECT_FALSE(updater.is_all_new());
  EXPECT_EQ(updater.new_boxes().size(), 2u);
  EXPECT_LT(records.copied_tiles(), 200);
  EXPECT_LT(updater.tiles().lines().size() - updater.first_new_line(), 1000u);
}

TEST(LineTilesUpdater, CutsOnlyWhatComesIntoViewOfWhatScrolls) {
  const Picture world = busy_picture(200, 60);
  IncrementalVectorizer vectorizer;
  LineTilesUpdater updater;
  for (int x = 0; x < 8; ++x) {
    Picture seen(120, 60);
    paste(seen, world, -x, 0);
    vectorizer.vectorize(seen.view(), {});
    updater.update(vectorizer, vectorizer.changes(), {4, 4}, TileEncoding::levels);
    ASSERT_EQ(updater.is_all_new(), x == 0);
    if (x == 0) continue;
    const std::size_t lines = updater.tiles().lines().size() - updater.first_new_line();
    EXPECT_LT(10 * lines, updater.tiles().used_lines());
    EXPECT_TRUE(updater.tiles() == cut_anew(vectorizer, {4, 4}, TileEncoding::levels));
  }
}

TEST(LineTilesUpdater, CutsAllForAnotherScaleOrLight) {
  const Picture picture = busy_picture(20, 20);
  IncrementalVectorizer vectorizer;
  vectorizer.vectorize(picture.view(), {});
  LineTilesUpdater updater;
  updater.update(vectorizer, vectorizer.changes(), {3, 3}, TileEncoding::levels);
  vectorizer.vectorize(picture.view(), {});
  const MapChanges& nothing = vectorizer.changes();
  ASSERT_FALSE(nothing.any());
  const auto expect_all_cut = [&](glm::dvec2 scale, TileEncoding encoding) {
    EXPECT_FALSE(updater.is_for(scale, encoding));
    updater.update(vectorizer, nothing, scale, encoding);
    EXPECT_TRUE(updater.is_all_new());
    EXPECT_TRUE(updater.is_for(scale, encoding));
    EXPECT_TRUE(updater.tiles() == cut_anew(vectorizer, scale, encoding));
  };
  expect_all_cut({3, 4}, TileEncoding::levels);
  expect_all_cut({3, 4}, TileEncoding::light);
  expect_all_cut({3, 4}, TileEncoding::regions);
}

TEST(LineTilesUpdater, LinesThatAreNobodysAreDropped) {
  Picture picture = busy_picture(60, 40);
  IncrementalVectorizer vectorizer;
  LineTilesUpdater updater;
  int compactions = 0;
  for (int frame = 0; frame < 60; ++frame) {
    paste(picture, Picture(8, 8, palette_colour(frame % 2 == 0 ? 'b' : '4')), frame % 10 * 5, frame % 7 * 4);
    vectorizer.vectorize(picture.view(), {});
    updater.update(vectorizer, vectorizer.changes(), {3, 3}, TileEncoding::levels);
    EXPECT_LE(updater.tiles().lines().size(), 2 * updater.tiles().used_lines());
    if (frame == 0 || !updater.is_all_new()) continue;
    ++compactions;
    EXPECT_EQ(updater.tiles().lines(), cut_anew(vectorizer, {3, 3}, TileEncoding::levels).lines());
  }
  EXPECT_GT(compactions, 0);
  EXPECT_LT(compactions, 20);
}

}  // namespace
}  // namespace depixel::test
