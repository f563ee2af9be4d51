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
  static constexpr int kGroup = kWordLanes;              ///< pixels
  static constexpr int kAtOnce = sizeof(std::uint64_t);  ///< flags that are looked at together

  void resize(int rows, int width) {
    pitch_ = (width / kGroup / kAtOnce + 1) * kAtOnce;
    flags_.assign(std::size_t(rows) * pitch_, 0);
  }
  /// The flags of a row, and one of them set.
  std::uint8_t* row(int row) { return flags_.data() + std::size_t(row) * pitch_; }
  static void touch(std::uint8_t* row, int column) { row[static_cast<unsigned>(column) / kGroup] = 1; }

  /// Calls visit(first column, flags) for the flags of a row up to a column, those that are looked at
  /// together; not if all are 0.
  template <typename Visit>
  void for_each_flags(int row, int last, Visit visit) const {
    const std::uint8_t* flags = flags_.data() + std::size_t(row) * pitch_;
    for (int flag = 0; flag <= last / kGroup; flag += kAtOnce) {
      if (const std::uint64_t together = load_bytes(flags + flag); together != 0)
        visit(flag * kGroup, together);
    }
  }
  /// Calls visit(first column) for each group that was touched, from left to right.
  template <typename Visit>
  static void for_each_group(int first, std::uint64_t flags, Visit visit) {
    for (; flags != 0; flags &= flags - 1) visit(first + std::countr_zero(flags) / 8 * kGroup);
  }
  /// The same for a row, up to a column.
  template <typename Visit>
  void for_each(int row, int last, Visit visit) const {
    for_each_flags(row, last, [&](int first, std::uint64_t flags) { for_each_group(first, flags, visit); });
  }
  /// Flags are 0 or 1.
  static int count(std::uint64_t flags) { return static_cast<int>(flags * 0x01'01'01'01'01'01'01'01 >> 56); }

  void forget(int row) { std::fill_n(flags_.data() + std::size_t(row) * pitch_, pitch_, std::uint8_t{0}); }

  std::size_t memory_bytes() const { return held_bytes(flags_); }

 private:
  int pitch_ = 0;
  std::vector<std::uint8_t> flags_;
};

}  // namespace depixel
