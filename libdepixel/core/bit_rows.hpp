#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "libdepixel/core/memory.hpp"

namespace depixel {

/// A bit for each entry of a grid, 64 to a word, so that simple questions about neighbours are asked of 64
/// entries at once. Round the grid lies a margin of entries, so that these questions need no bounds checks.
class BitRows {
 public:
  using Word = std::uint64_t;
  static constexpr int kBits = 64;
  static constexpr int kMargin = 2;  ///< entries on every side

  /// Sets all bits to 0.
  void reset(int width, int height) {
    width_ = width;
    height_ = height;
    words_ = (width + 2 * kMargin + kBits - 1) / kBits;
    bits_.assign(1 + std::size_t(words_ + 1) * (height + 2 * kMargin), 0);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  int words() const { return words_; }  ///< in a row; those before the first and after the last are 0
  /// Row y, -kMargin .. height + kMargin - 1. Its bit 0 is entry -kMargin.
  Word* row(int y) { return bits_.data() + 1 + std::ptrdiff_t{words_ + 1} * (y + kMargin); }
  const Word* row(int y) const { return bits_.data() + 1 + std::ptrdiff_t{words_ + 1} * (y + kMargin); }

  bool has(int x, int y) const { return (row(y)[(x + kMargin) / kBits] >> (x + kMargin) % kBits & 1) != 0; }
  void set(int x, int y) { row(y)[(x + kMargin) / kBits] |= Word{1} << (x + kMargin) % kBits; }

  std::size_t memory_bytes() const { return held_bytes(bits_); }

 private:
  int width_ = 0, height_ = 0, words_ = 0;
  std::vector<Word> bits_;
};

/// The bits one to the west and one to the east of a word's, in their places.
inline BitRows::Word west_of(const BitRows::Word* word) {
  return word[0] << 1 | word[-1] >> (BitRows::kBits - 1);
}
inline BitRows::Word east_of(const BitRows::Word* word) {
  return word[0] >> 1 | word[1] << (BitRows::kBits - 1);
}

}  // namespace depixel
