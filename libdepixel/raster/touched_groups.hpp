#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/core/simd.hpp"

namespace depixel {

/// Which pixels of some rows were touched, by groups of four, a byte each: found again without a look at
/// every pixel.
class TouchedGroups {
 public:
  static constexpr int kGroup = kWordLanes;  ///< pixels

  void resize(int rows, int width) {
    pitch_ = (width / kGroup / kAtOnce + 1) * kAtOnce;
    flags_.assign(std::size_t(rows) * pitch_, 0);
  }
  void touch(int row, int column) { flags_[std::size_t(row) * pitch_ + column / kGroup] = 1; }

  /// Calls visit(first column) for each group of a row with touched pixels, from left to right, up to a
  /// column.
  template <typename Visit>
  void for_each(int row, int last, Visit visit) const {
    const std::uint8_t* flags = flags_.data() + std::size_t(row) * pitch_;
    for (int flag = 0; flag <= last / kGroup; flag += kAtOnce) {
      for (std::uint64_t bits = load_bytes(flags + flag); bits != 0; bits &= bits - 1) {
        visit((flag + std::countr_zero(bits) / 8) * kGroup);
      }
    }
  }
  void forget(int row) { std::fill_n(flags_.data() + std::size_t(row) * pitch_, pitch_, std::uint8_t{0}); }

  std::size_t memory_bytes() const { return held_bytes(flags_); }

 private:
  static constexpr int kAtOnce = sizeof(std::uint64_t);  ///< flags that are looked at together
  int pitch_ = 0;
  std::vector<std::uint8_t> flags_;
};

}  // namespace depixel
