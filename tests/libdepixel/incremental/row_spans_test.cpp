#include "libdepixel/incremental/row_spans.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace depixel::test {
namespace {

TEST(RowSpans, NothingChangedAtFirst) {
  RowSpans spans;
  EXPECT_FALSE(spans.any());
  spans.reset(3);
  EXPECT_EQ(spans.rows(), 3);
  EXPECT_FALSE(spans.any());
  for (int row = 0; row < 3; ++row) EXPECT_TRUE(spans.is_empty(row));
}

TEST(RowSpans, RowsOutsideThePictureNeverChange) {
  RowSpans spans;
  spans.reset(2);
  for (const int row : {0, 1}) spans.set(row, {0, 4});
  EXPECT_TRUE(spans.is_empty(-1));
  EXPECT_TRUE(spans.is_empty(2));
  EXPECT_TRUE(spans.any());
  EXPECT_EQ(spans[1].length(), 4);
  spans.reset(2);
  EXPECT_FALSE(spans.any());
}

/// Rows of a few values, mostly equal to each other.
template <typename Value>
void expect_first_and_last_difference() {
  const auto row = *rc::gen::container<std::vector<Value>>(rc::gen::inRange<Value>(0, 3));
  auto other = row;
  const auto changes = *rc::gen::resize(3, rc::gen::arbitrary<std::vector<unsigned>>());
  for (const unsigned at : changes) {
    if (!other.empty()) other[at % other.size()] ^= 1;
  }
  Span expected;
  for (int x = 0; x < static_cast<int>(row.size()); ++x) {
    if (row[x] == other[x]) continue;
    if (expected.is_empty()) expected.from = x;
    expected.to = x + 1;
  }
  const Span found = differing_part(row.data(), other.data(), static_cast<int>(row.size()));
  RC_ASSERT(found.is_empty() == expected.is_empty());
  if (expected.is_empty()) return;
  RC_ASSERT(found.from == expected.from);
  RC_ASSERT(found.to == expected.to);
}

RC_GTEST_PROP(RowSpans, TheDifferingPartRunsFromTheFirstToTheLastDifference, ()) {
  expect_first_and_last_difference<std::uint8_t>();
  expect_first_and_last_difference<std::uint32_t>();
}

}  // namespace
}  // namespace depixel::test
