#include "libdepixel/incremental/byte_rows.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace depixel::test {
namespace {

/// A row of a few different bytes, and sixteen more behind its end.
std::vector<std::uint8_t> random_row(int count) {
  const auto byte = rc::gen::element<std::uint8_t>(0, 1, 12, 15, 255);
  return *rc::gen::container<std::vector<std::uint8_t>>(count + 16, byte);
}

RC_GTEST_PROP(ByteRows, AreSearchedUpToTheirEnd, ()) {
  const int count = *rc::gen::inRange(0, 50);
  const std::vector<std::uint8_t> a = random_row(count), b = random_row(count);
  std::vector<int> differing, equal, with_bits, expected_differing, expected_equal, expected_with_bits;
  for_each_difference(a.data(), b.data(), count, [&](int i) { differing.push_back(i); });
  for_each_equal(a.data(), count, 12, [&](int i) { equal.push_back(i); });
  for_each_with_bits(a.data(), count, 12, [&](int i) { with_bits.push_back(i); });
  for (int i = 0; i < count; ++i) {
    if (a[i] != b[i]) expected_differing.push_back(i);
    if (a[i] == 12) expected_equal.push_back(i);
    if ((a[i] & 12) == 12) expected_with_bits.push_back(i);
  }
  RC_ASSERT(differing == expected_differing);
  RC_ASSERT(equal == expected_equal);
  RC_ASSERT(with_bits == expected_with_bits);
}

}  // namespace
}  // namespace depixel::test
