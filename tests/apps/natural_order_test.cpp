#include "apps/common/natural_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string_view>
#include <vector>

namespace depixel {
namespace {

TEST(NaturalOrder, SortsNumbersByValue) {
  const std::vector<std::string_view> sorted{"",    "0",       "1",         "2",        "10",
                                             "a",   "a1b2",    "a1b10",     "a2",       "a010",
                                             "a10", "frame_9", "frame_010", "frame_11", "z"};
  std::vector<std::string_view> names = sorted;
  std::shuffle(names.begin(), names.end(), std::mt19937(1));
  std::sort(names.begin(), names.end(), naturally_before);
  EXPECT_EQ(names, sorted);
}

TEST(NaturalOrder, IsStrictAndTotal) {
  const std::vector<std::string_view> names{"1", "01", "001", "a", "a1", "a01", "a1b", "99999999999999999999",
                                            "b"};
  for (const auto a : names) {
    for (const auto b : names) {
      EXPECT_EQ(naturally_before(a, b) + naturally_before(b, a), a == b ? 0 : 1) << a << " and " << b;
    }
  }
}

}  // namespace
}  // namespace depixel
