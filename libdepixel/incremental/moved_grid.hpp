#pragma once

#include <algorithm>
#include <glm/vec2.hpp>
#include <vector>

#include "libdepixel/core/lattice.hpp"

namespace depixel {

/// The entries of a padded array that a move concerns: columns x rows of them, from one on.
struct GridPart {
  int first;  ///< index of the north-western entry
  int columns, rows;
  int stride;  ///< from one row to the next

  static GridPart pixels(const Lattice& lattice) {
    return {lattice.pixel(0, 0), lattice.width(), lattice.height(), lattice.stride()};
  }
  static GridPart corners(const Lattice& lattice) {
    return {lattice.corner(0, 0), lattice.width() + 1, lattice.height() + 1, lattice.stride()};
  }
  /// Part of an array with several values an entry.
  GridPart times(int values) const { return {first * values, columns * values, rows, stride * values}; }
};

/// Copies what lies by -move from each entry; entries for which that is outside the part are set to a value.
/// Both arrays may be one. Cost: that of copying memory.
template <typename Value>
void move_entries(const GridPart& part, glm::ivec2 move, Value uncovered, const std::vector<Value>& from,
                  std::vector<Value>& to) {
  const int kept = std::max(0, part.columns - std::abs(move.x));
  const int west = std::max(0, move.x), source_west = std::max(0, -move.x);
  for (int i = 0; i < part.rows; ++i) {
    // Against the direction of the move, so that no row is overwritten before it is read.
    const int y = move.y > 0 ? part.rows - 1 - i : i, source = y - move.y;
    Value* row = to.data() + part.first + std::ptrdiff_t{y} * part.stride;
    if (source < 0 || source >= part.rows || kept == 0) {
      std::fill_n(row, part.columns, uncovered);
      continue;
    }
    const Value* source_row = from.data() + part.first + std::ptrdiff_t{source} * part.stride;
    if (row + west <= source_row + source_west) {
      std::copy_n(source_row + source_west, kept, row + west);
    } else {
      std::copy_backward(source_row + source_west, source_row + source_west + kept, row + west + kept);
    }
    std::fill_n(row, west, uncovered);
    std::fill(row + west + kept, row + part.columns, uncovered);
  }
}

}  // namespace depixel
