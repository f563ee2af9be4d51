#include "libdepixel/incremental/map_changes.hpp"

#include <gtest/gtest.h>

namespace depixel::test {
namespace {

constexpr std::uint8_t kSame = MapChanges::kSame, kNew = MapChanges::kNew, kMoved = MapChanges::kMoved;

MapChanges changes_of(const std::vector<std::uint8_t>& tiles, const std::vector<glm::ivec2>& moves = {}) {
  MapChanges changes;
  changes.set_nothing();
  changes.tiles = tiles;
  changes.moves = moves;
  for (const std::uint8_t tile : tiles) {
    changes.new_tiles += tile == kNew ? 1 : 0;
    changes.moved_tiles += tile >= kMoved ? 1 : 0;
  }
  return changes;
}

TEST(MapChanges, EverythingIsNewAtFirst) {
  EXPECT_TRUE(MapChanges().everything);
  EXPECT_TRUE(MapChanges().any());
}

TEST(MapChanges, EverythingAndMoreIsEverything) {
  MapChanges changes;
  changes.add(changes_of({kNew, kSame}));
  EXPECT_TRUE(changes.everything);
  changes = changes_of({kNew, kSame});
  changes.add(MapChanges());
  EXPECT_TRUE(changes.everything);
}

TEST(MapChanges, NothingAndMoreIsThat) {
  MapChanges changes;
  changes.set_nothing();
  EXPECT_FALSE(changes.any());
  changes.add(changes_of({kSame, kMoved, kNew}, {{3, 1}}));
  EXPECT_EQ(changes.tiles, (std::vector<std::uint8_t>{kSame, kMoved, kNew}));
  EXPECT_EQ(changes.moves, (std::vector<glm::ivec2>{{3, 1}}));
  EXPECT_EQ(changes.moved_tiles, 1);
  EXPECT_EQ(changes.new_tiles, 1);
}

TEST(MapChanges, SomethingAndNothingIsAsBefore) {
  MapChanges changes = changes_of({kSame, kMoved, kNew}, {{3, 1}}), nothing;
  nothing.set_nothing();
  nothing.tiles = {kNew, kNew, kNew};  // of some frame before: they mean nothing
  changes.add(nothing);
  EXPECT_EQ(changes.tiles, (std::vector<std::uint8_t>{kSame, kMoved, kNew}));
  EXPECT_EQ(changes.moved_tiles, 1);
}

TEST(MapChanges, WhatMovedBeforeOrAfterOtherChangesIsNew) {
  MapChanges changes = changes_of({kSame, kMoved, kNew, kSame, kSame}, {{3, 1}});
  changes.add(changes_of({kSame, kSame, kSame, kMoved + 1, kNew}, {{1, 0}, {0, 2}}));
  EXPECT_EQ(changes.tiles, (std::vector<std::uint8_t>{kSame, kNew, kNew, kNew, kNew}));
  EXPECT_EQ(changes.new_tiles, 4);
  EXPECT_EQ(changes.moved_tiles, 0);
  EXPECT_TRUE(changes.moves.empty());
}

}  // namespace
}  // namespace depixel::test
