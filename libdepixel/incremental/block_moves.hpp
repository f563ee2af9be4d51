#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "libdepixel/core/frame_view.hpp"
#include "libdepixel/incremental/block_set.hpp"
#include "libdepixel/stages/similarity_graph.hpp"

namespace depixel {

/// How each block of a frame moved since the frame before: by which of some moves most of its pixels are what
/// they were. Layers that scroll each at its own speed, and what stands still before them, are told apart so.
class BlockMoves {
 public:
  /// Blocks of a row that moved alike: pixel columns from .. to - 1.
  struct Run {
    int from, to;
    glm::ivec2 move;
  };

  /// Compares a frame with the one before. \return whether any pixel differs.
  /// Cost: that of comparing memory.
  bool find_changed_rows(const FrameView& frame, const SimilarityGraph& before);
  /// Chooses a move for each block, and finds the blocks with pixels that it does not explain; those that it
  /// brings from outside the frame are among them. Where hardly any block moved, all stay.
  /// \param moves  to choose from; the first one where others do not explain clearly more.
  /// \pre find_changed_rows() of these frames.
  void find(const FrameView& frame, const SimilarityGraph& before, std::span<const glm::ivec2> moves);
  /// Nothing is known of a frame before: nothing moved, and all blocks changed.
  void set_unknown(const Lattice& lattice);

  const BlockGrid& grid() const { return grid_; }
  const std::vector<glm::ivec2>& moves() const { return moves_; }
  /// Index of a block's move.
  int move_index(int column, int row) const { return index_[place(column, row)]; }
  glm::ivec2 move(int column, int row) const { return moves_[move_index(column, row)]; }
  /// Whether anything is known of a frame before.
  bool is_known() const { return is_known_; }
  /// Whether any block moved.
  bool any_moved() const { return any_moved_; }
  /// Blocks with changed pixels.
  const BlockSet& changed() const { return changed_; }
  int changed_pixels() const { return changed_pixels_; }
  /// Runs in a row of blocks.
  std::span<const Run> runs(int row) const {
    return std::span(runs_).subspan(first_run_[row], first_run_[row + 1] - first_run_[row]);
  }

  /// Where a block meets what did not move with it.
  struct Seam {
    int column, row;
    glm::ivec2
        step;  ///< -1, 0 or 1 blocks along each axis: to another block, or to beyond the frame's border
  };
  /// All seams, from both sides.
  const std::vector<Seam>& seams() const { return seams_; }
  bool is_border(const Seam& seam) const {
    return move_index(seam.column + seam.step.x, seam.row + seam.step.y) == kOutside;
  }

  std::size_t memory_bytes() const {
    return held_bytes(is_row_changed_, moves_, index_, runs_, first_run_, seams_) + changed_.memory_bytes();
  }

 private:
  static constexpr std::uint8_t kOutside = 255;

  void start(const Lattice& lattice, std::span<const glm::ivec2> moves);
  void choose(const FrameView& frame, const SimilarityGraph& before, std::span<const glm::ivec2> moves);
  int count_moved() const;
  int count_differing(const FrameView& frame, const SimilarityGraph& before, int column, int row,
                      glm::ivec2 move, int most) const;
  void find_runs();
  void find_seams();
  bool is_seam(const Seam& seam) const;
  int place(int column, int row) const { return (row + 1) * (grid_.columns + 2) + column + 1; }

  BlockGrid grid_;
  std::vector<std::uint8_t> is_row_changed_;  ///< by row of pixels
  std::vector<glm::ivec2> moves_;
  std::vector<std::uint8_t> index_;  ///< by block; with a border of kOutside
  BlockSet changed_;
  std::vector<Run> runs_;
  std::vector<int> first_run_;  ///< by row of blocks, and one more
  std::vector<Seam> seams_;
  int changed_pixels_ = 0;
  bool is_known_ = false, any_moved_ = false;
};

/// The entries of a padded array that moves concern: columns x rows of them, from one on.
struct GridPart {
  int first;  ///< index of the north-western entry
  int columns, rows;
  int stride;  ///< from one row to the next
  int values;  ///< of the array, an entry

  static GridPart pixels(const Lattice& lattice) {
    return {lattice.pixel(0, 0), lattice.width(), lattice.height(), lattice.stride(), 1};
  }
  /// A corner moves with the pixel at its south-east, or the nearest one.
  static GridPart corners(const Lattice& lattice, int values = 1) {
    return {lattice.corner(0, 0), lattice.width() + 1, lattice.height() + 1, lattice.stride(), values};
  }
};

/// Moves the entries of an array as the blocks moved in which they lie; what comes from outside the part is
/// set to a value. \param to  another array; what is not of the part stays. Cost: that of copying memory.
template <typename Value>
void move_blocks(const BlockMoves& blocks, const GridPart& part, Value uncovered,
                 const std::vector<Value>& from, std::vector<Value>& to) {
  const BlockGrid& grid = blocks.grid();
  for (int y = 0; y < part.rows; ++y) {
    Value* row = to.data() + std::ptrdiff_t{part.values} * (part.first + y * part.stride);
    for (const BlockMoves::Run& run : blocks.runs(std::min(y, grid.height - 1) / BlockGrid::kSide)) {
      const int end = run.to == grid.width ? part.columns : run.to;
      const int source = y - run.move.y;
      const bool has_source = source >= 0 && source < part.rows;
      const int west = has_source ? std::clamp(run.move.x, run.from, end) : end;
      const int east = std::clamp(part.columns + run.move.x, west, end);
      const Value* source_row =
          from.data() + std::ptrdiff_t{part.values} * (part.first + source * part.stride - run.move.x);
      std::fill(row + part.values * run.from, row + part.values * west, uncovered);
      if (west < east) {
        std::copy(source_row + part.values * west, source_row + part.values * east, row + part.values * west);
      }
      std::fill(row + part.values * east, row + part.values * end, uncovered);
    }
  }
}

}  // namespace depixel
