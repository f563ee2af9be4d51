#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "libdepixel/core/lattice.hpp"
#include "libdepixel/core/memory.hpp"

namespace depixel {

/// A frame cut into blocks of kSide x kSide pixels; those at its east and south may have fewer.
struct BlockGrid {
  /// What a pixel influences directly, through windows of 8x8 pixels among others, lies in its block or in
  /// one beside it.
  static constexpr int kSide = 8;

  BlockGrid() = default;
  explicit BlockGrid(const Lattice& lattice)
      : width(lattice.width()),
        height(lattice.height()),
        columns((width + kSide - 1) / kSide),
        rows((height + kSide - 1) / kSide) {}

  int width = 0, height = 0;  ///< pixels
  int columns = 0, rows = 0;  ///< blocks

  int first_x(int column) const { return column * kSide; }
  int end_x(int column) const { return std::min(width, (column + 1) * kSide); }
  int first_y(int row) const { return row * kSide; }
  int end_y(int row) const { return std::min(height, (row + 1) * kSide); }
};

/// Some of the blocks of a frame.
class BlockSet {
 public:
  /// Starts with none.
  void reset(const BlockGrid& grid) {
    grid_ = grid;
    is_in_.assign(std::size_t(pitch()) * (grid.rows + 2), 0);
  }
  void add(int column, int row) { is_in_[index(column, row)] = 1; }
  void add_all() {
    for (int row = 0; row < grid_.rows; ++row) std::fill_n(is_in_.begin() + index(0, row), grid_.columns, 1);
  }
  /// Adds all blocks with a pixel at most `distance` from one, along either axis.
  void add_around(glm::ivec2 pixel, int distance) {
    const auto block = [](int at, int count) { return std::clamp(at / BlockGrid::kSide, 0, count - 1); };
    for (int row = block(pixel.y - distance, grid_.rows); row <= block(pixel.y + distance, grid_.rows);
         ++row) {
      for (int column = block(pixel.x - distance, grid_.columns);
           column <= block(pixel.x + distance, grid_.columns); ++column) {
        add(column, row);
      }
    }
  }
  /// Sets this to another's blocks and those beside them, diagonally too.
  void set_grown(const BlockSet& from) {
    reset(from.grid_);
    const int step = pitch();
    for (int row = 0; row < grid_.rows; ++row) {
      const std::uint8_t* here = from.is_in_.data() + index(0, row);
      std::uint8_t* to = is_in_.data() + index(0, row);
      for (int column = 0; column < grid_.columns; ++column) {
        const auto three = [&](const std::uint8_t* at) { return at[-1] | at[0] | at[1]; };
        const std::uint8_t* at = here + column;
        to[column] = static_cast<std::uint8_t>(three(at - step) | three(at) | three(at + step));
      }
    }
  }

  bool has(int column, int row) const { return is_in_[index(column, row)] != 0; }
  int count() const { return static_cast<int>(std::count(is_in_.begin(), is_in_.end(), 1)); }
  bool has_all() const { return count() == grid_.columns * grid_.rows; }
  const BlockGrid& grid() const { return grid_; }

  /// A run of blocks in a row of them: pixel columns from .. to - 1.
  struct Run {
    int from, to;
  };
  /// To be called when all blocks are in, before runs() are.
  void find_runs() {
    runs_.clear();
    first_run_.assign(1, 0);
    for (int row = 0; row < grid_.rows; ++row) {
      const std::uint8_t* in = is_in_.data() + index(0, row);
      for (int column = grid_.columns - 1; column >= 0; --column) {
        const int last = column;
        while (column >= 0 && in[column] != 0) --column;
        if (last != column) runs_.push_back({grid_.first_x(column + 1), grid_.end_x(last)});
      }
      first_run_.push_back(static_cast<int>(runs_.size()));
    }
  }
  /// The runs that a row of pixels goes through, from east to west: vector code may write beyond the end of
  /// one, over what was done before then.
  std::span<const Run> runs(int y) const {
    const int row = y / BlockGrid::kSide, first = first_run_[row];
    return std::span(runs_).subspan(first, first_run_[row + 1] - first);
  }

  std::size_t memory_bytes() const { return held_bytes(is_in_, runs_, first_run_); }

 private:
  int pitch() const { return grid_.columns + 2; }
  int index(int column, int row) const { return (row + 1) * pitch() + column + 1; }

  BlockGrid grid_;
  std::vector<std::uint8_t> is_in_;  ///< with a border of blocks that are not in
  std::vector<Run> runs_;
  std::vector<int> first_run_;  ///< by row of blocks, and one more
};

}  // namespace depixel
