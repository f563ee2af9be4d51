#pragma once

#include <bit>
#include <cstdint>

#include "libdepixel/core/simd.hpp"

namespace depixel {

/// Calls visit(i) for each i for which test(sixteen bytes from i on)[0] is not 0; sixteen at a time where
/// there are as many.
template <typename Test, typename Visit>
void for_each_byte(int count, Test test, Visit visit) {
  constexpr int kAtOnce = sizeof(Byte16);
  for (int i = 0; i < count; i += kAtOnce) {
    std::uint32_t bits = gather_bits(reinterpret_cast<Byte16>(test(i) != 0), 0);
    if (count - i < kAtOnce) bits &= (1U << (count - i)) - 1;
    for (; bits != 0; bits &= bits - 1) visit(i + std::countr_zero(bits));
  }
}

/// Calls visit(i) where two rows of bytes differ. Both are read up to fifteen bytes beyond their end.
template <typename Visit>
void for_each_difference(const std::uint8_t* a, const std::uint8_t* b, int count, Visit visit) {
  for_each_byte(
      count, [&](int i) { return load_vector<Byte16>(a + i) ^ load_vector<Byte16>(b + i); }, visit);
}

/// Calls visit(i) where a row of bytes has all of some bits. It is read up to fifteen bytes beyond its end.
template <typename Visit>
void for_each_with_bits(const std::uint8_t* row, int count, std::uint8_t bits, Visit visit) {
  for_each_byte(
      count,
      [&](int i) {
        const auto wanted = (load_vector<Byte16>(row + i) & bits) == bits;
        return reinterpret_cast<Byte16>(wanted);
      },
      visit);
}

/// Calls visit(i) where a row of bytes has a value. It is read up to fifteen bytes beyond its end.
template <typename Visit>
void for_each_equal(const std::uint8_t* row, int count, std::uint8_t value, Visit visit) {
  for_each_byte(
      count, [&](int i) { return reinterpret_cast<Byte16>(load_vector<Byte16>(row + i) == value); }, visit);
}

}  // namespace depixel
