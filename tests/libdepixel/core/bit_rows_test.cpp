#include "libdepixel/core/bit_rows.hpp"

#include <gtest/gtest.h>

namespace depixel::test {
namespace {

TEST(BitRows, HoldWhatIsSetInTheMarginToo) {
  BitRows bits;
  bits.reset(130, 3);
  for (const int x : {-BitRows::kMargin, 0, 61, 62, 129, 131}) {
    for (const int y : {-1, 2, 4}) {
      EXPECT_FALSE(bits.has(x, y));
      bits.set(x, y);
      EXPECT_TRUE(bits.has(x, y));
    }
    EXPECT_FALSE(bits.has(x, 0));
  }
}

TEST(BitRows, NeighboursLieInTheWordsBeside) {
  for (int x = 0; x < 130; ++x) {
    BitRows bits, west, east;
    for (BitRows* all : {&bits, &west, &east}) all->reset(130, 1);
    bits.set(x, 0);
    for (int i = 0; i < bits.words(); ++i) {
      west.row(0)[i] = west_of(bits.row(0) + i);
      east.row(0)[i] = east_of(bits.row(0) + i);
    }
    for (int k = -1; k <= 130; ++k) {
      EXPECT_EQ(west.has(k, 0), k == x + 1);
      EXPECT_EQ(east.has(k, 0), k == x - 1);
    }
  }
}

}  // namespace
}  // namespace depixel::test
