#include "libdepixel/incremental/block_set.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

using Blocks = std::set<std::pair<int, int>>;  ///< columns and rows

Lattice random_lattice() {
  const auto size = [] { return *random_int(1, 60); };
  const int width = size();
  return {width, size()};
}

Blocks random_blocks(const BlockGrid& grid) {
  Blocks blocks;
  for (int i = *rc::gen::inRange(0, 8); i > 0; --i) {
    blocks.emplace(*rc::gen::inRange(0, grid.columns), *rc::gen::inRange(0, grid.rows));
  }
  return blocks;
}

BlockSet set_of(const BlockGrid& grid, const Blocks& blocks) {
  BlockSet set;
  set.reset(grid);
  for (const auto& [column, row] : blocks) set.add(column, row);
  return set;
}

RC_GTEST_PROP(BlockSet, RunsHoldThePixelsOfItsBlocks, ()) {
  const Lattice lattice = random_lattice();
  const BlockGrid grid(lattice);
  const Blocks blocks = random_blocks(grid);
  BlockSet set = set_of(grid, blocks);
  set.find_runs();
  RC_ASSERT(set.count() == static_cast<int>(blocks.size()));
  for (int y = 0; y < lattice.height(); ++y) {
    std::set<int> in_runs;
    int from_before = lattice.width() + 1;
    for (const BlockSet::Run run : set.runs(y)) {
      RC_ASSERT(run.to < from_before);
      from_before = run.from;
      for (int x = run.from; x < run.to; ++x) in_runs.insert(x);
    }
    for (int x = 0; x < lattice.width(); ++x) {
      RC_ASSERT(in_runs.contains(x) == blocks.contains({x / BlockGrid::kSide, y / BlockGrid::kSide}));
    }
  }
}

RC_GTEST_PROP(BlockSet, GrowsByTheBlocksBeside, ()) {
  const BlockGrid grid(random_lattice());
  const Blocks blocks = random_blocks(grid);
  BlockSet grown;
  grown.set_grown(set_of(grid, blocks));
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      bool is_near = false;
      for (const auto& [c, r] : blocks) is_near |= std::abs(c - column) <= 1 && std::abs(r - row) <= 1;
      RC_ASSERT(grown.has(column, row) == is_near);
    }
  }
}

RC_GTEST_PROP(BlockSet, AddsAllBlocksAroundAPixel, ()) {
  const Lattice lattice = random_lattice();
  const BlockGrid grid(lattice);
  const glm::ivec2 pixel(*rc::gen::inRange(0, lattice.width()), *rc::gen::inRange(0, lattice.height()));
  const int distance = *rc::gen::inRange(0, 9);
  BlockSet set = set_of(grid, {});
  set.add_around(pixel, distance);
  Blocks expected;
  for (int y = std::max(0, pixel.y - distance); y <= std::min(lattice.height() - 1, pixel.y + distance);
       ++y) {
    for (int x = std::max(0, pixel.x - distance); x <= std::min(lattice.width() - 1, pixel.x + distance);
         ++x) {
      expected.emplace(x / BlockGrid::kSide, y / BlockGrid::kSide);
    }
  }
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      RC_ASSERT(set.has(column, row) == expected.contains({column, row}));
    }
  }
}

TEST(BlockSet, KnowsWhetherItHasAll) {
  const BlockGrid grid(Lattice(17, 9));
  EXPECT_EQ(grid.columns, 3);
  EXPECT_EQ(grid.rows, 2);
  EXPECT_EQ(grid.end_x(2), 17);
  BlockSet set;
  set.reset(grid);
  for (int column = 0; column < 3; ++column) {
    EXPECT_FALSE(set.has_all());
    set.add(column, 0);
    set.add(column, 1);
  }
  EXPECT_TRUE(set.has_all());
  set.reset(grid);
  EXPECT_EQ(set.count(), 0);
  set.add_all();
  EXPECT_TRUE(set.has_all());
}

}  // namespace
}  // namespace depixel::test
