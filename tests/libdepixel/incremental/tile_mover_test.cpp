#include "libdepixel/incremental/tile_mover.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/guarded_canvas.hpp"
#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

/// A picture in which no two pixels are equal.
Picture numbered(int width, int height) {
  Picture picture(width, height);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    picture.pixels[i] = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i >> 8),
                         static_cast<std::uint8_t>(i >> 16), 255};
  }
  return picture;
}

/// Some tiles, same, new or moved from inside the frame.
MapChanges random_changes(const Lattice& lattice, const std::vector<glm::ivec2>& moves, std::uint32_t seed) {
  MapChanges changes;
  changes.set_nothing();
  changes.moves = moves;
  changes.tiles.assign(lattice.size(), MapChanges::kSame);
  for (int y = 0; y < lattice.height(); ++y) {
    for (int x = 0; x < lattice.width(); ++x) {
      seed = seed * 1664525 + 1013904223;
      const auto tile = static_cast<std::uint8_t>((seed >> 20) % (MapChanges::kMoved + moves.size()));
      std::uint8_t& set = changes.tiles[lattice.pixel(x, y)];
      if (tile >= MapChanges::kMoved) {
        const glm::ivec2 from = glm::ivec2(x, y) - moves[tile - MapChanges::kMoved];
        if (from.x < 0 || from.y < 0 || from.x >= lattice.width() || from.y >= lattice.height()) continue;
        ++changes.moved_tiles;
      }
      changes.new_tiles += tile == MapChanges::kNew ? 1 : 0;
      set = tile;
    }
  }
  return changes;
}

/// The output pixels of a tile, which lie in the picture or not.
template <typename Visit>
void for_each_pixel(const Lattice& lattice, const OutputGrid& grid, int tile, Visit visit) {
  const glm::ivec2 at = lattice.pixel_position(tile);
  const int scale_x = grid.x.whole_scale(), scale_y = grid.y.whole_scale();
  const glm::ivec2 first(grid.column(at.x) / kRasterSubpixels, grid.row(at.y) / kRasterSubpixels);
  for (int y = 0; y < scale_y; ++y) {
    for (int x = 0; x < scale_x; ++x) visit(first + glm::ivec2(x, y));
  }
}

RC_GTEST_PROP(TileMover, EqualsACopyOfEachTileFromThePictureBefore, ()) {
  const auto number = [](int from, int end) { return *random_int(from, end); };
  const Lattice lattice(number(1, 24), number(1, 16));
  const int scale_x = number(1, 5), scale_y = number(1, 5);
  const glm::ivec2 origin(number(-3, 6), number(-3, 6));
  const View view{double(scale_x), double(scale_y), double(origin.x), double(origin.y)};
  std::vector<glm::ivec2> moves;
  for (int i = number(1, 4); i > 0; --i) moves.emplace_back(number(-6, 7), number(-6, 7));
  const MapChanges changes = random_changes(lattice, moves, *rc::gen::arbitrary<std::uint32_t>());

  const Picture before = numbered(number(1, 90), number(1, 60));
  GuardedCanvas canvas(before.width, before.height);
  for (int y = 0; y < before.height; ++y) {
    std::memcpy(canvas.target().pixels + y * canvas.target().pitch,
                &before.pixels[std::size_t(y) * before.width], sizeof(Rgba) * before.width);
  }
  const OutputGrid grid(view, lattice, canvas.target());
  std::vector<std::uint8_t> is_stale;
  const std::int64_t moved_pixels = TileMover().move(grid, changes, is_stale);

  RC_ASSERT(canvas.is_guard_whole());
  RC_ASSERT(is_stale.size() == changes.tiles.size());
  Picture expected = before;
  std::int64_t expected_pixels = 0;
  for (int y = 0; y < lattice.height(); ++y) {
    for (int x = 0; x < lattice.width(); ++x) {
      const int tile = lattice.pixel(x, y);
      const std::uint8_t change = changes.tiles[tile];
      // What did not change is not drawn, what is new is; of what moved, either.
      if (change < MapChanges::kMoved) RC_ASSERT(is_stale[tile] == (change == MapChanges::kNew ? 1 : 0));
      if (change < MapChanges::kMoved || is_stale[tile] != 0) continue;
      const glm::ivec2 by = moves[change - MapChanges::kMoved] * glm::ivec2(scale_x, scale_y);
      for_each_pixel(lattice, grid, tile, [&](glm::ivec2 p) {
        ++expected_pixels;
        RC_ASSERT(before.contains(p.x, p.y));
        RC_ASSERT(before.contains(p.x - by.x, p.y - by.y));
        expected.at(p.x, p.y) = before.at(p.x - by.x, p.y - by.y);
      });
    }
  }
  RC_ASSERT(canvas.picture() == expected);
  RC_ASSERT(moved_pixels == expected_pixels);
}

MapChanges all_moved(const Lattice& lattice, glm::ivec2 by) {
  MapChanges changes;
  changes.set_nothing();
  changes.moves = {by};
  changes.tiles.assign(lattice.size(), MapChanges::kSame);
  for (int y = 0; y < lattice.height(); ++y) {
    for (int x = 0; x < lattice.width(); ++x) {
      const bool is_inside =
          x - by.x >= 0 && x - by.x < lattice.width() && y - by.y >= 0 && y - by.y < lattice.height();
      changes.tiles[lattice.pixel(x, y)] = is_inside ? MapChanges::kMoved : MapChanges::kNew;
      (is_inside ? changes.moved_tiles : changes.new_tiles) += 1;
    }
  }
  return changes;
}

TEST(TileMover, MovesWholeFramesEveryWay) {
  const Lattice lattice(12, 9);
  constexpr int kScale = 3;
  for (const glm::ivec2 by : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 2), glm::ivec2(0, -2),
                              glm::ivec2(4, 3), glm::ivec2(-4, 3), glm::ivec2(4, -3), glm::ivec2(-4, -3)}) {
    const Picture before = numbered(12 * kScale, 9 * kScale);
    Picture moved = before, expected = before;
    paste(expected, before, kScale * by.x, kScale * by.y);
    std::vector<std::uint8_t> is_stale;
    TileMover mover;
    const std::int64_t pixels =
        mover.move({{kScale, kScale, 0, 0}, lattice, moved.target()}, all_moved(lattice, by), is_stale);
    EXPECT_EQ(pixels, kScale * kScale * (12 - std::abs(by.x)) * (9 - std::abs(by.y)));
    EXPECT_TRUE(moved == expected) << by.x << ", " << by.y;
  }
}

TEST(TileMover, MovesNothingWherePixelsAreNotWhole) {
  const Lattice lattice(12, 9);
  for (const View& view :
       {View{2.5, 2.5, 0, 0}, View{2, 3.01, 0, 0}, View{2, 2, 0.25, 0}, View{1, 1, 0, 0.5}}) {
    const Picture before = numbered(60, 60);
    Picture moved = before;
    std::vector<std::uint8_t> is_stale;
    EXPECT_EQ(TileMover().move({view, lattice, moved.target()}, all_moved(lattice, {1, 0}), is_stale), 0);
    EXPECT_TRUE(moved == before);
    EXPECT_EQ(is_stale[lattice.pixel(5, 5)], 1);
  }
}

TEST(TileMover, MovesWhereOriginsAreWholeOutputPixels) {
  const Lattice lattice(12, 9);
  Picture moved = numbered(30, 30);
  std::vector<std::uint8_t> is_stale;
  EXPECT_GT(
      TileMover().move({{2, 2, 0.5, -1}, lattice, moved.target()}, all_moved(lattice, {1, 0}), is_stale), 0);
}

}  // namespace
}  // namespace depixel::test
