#include "libdepixel/incremental/block_moves.hpp"

#include <algorithm>
#include <cstring>

#include "libdepixel/core/normalized_pixels.hpp"

namespace depixel {
namespace {

/// Another move than the first is chosen for a block where it explains at least so many pixels more.
constexpr int kClearlyMore = 4;

/// With a smaller part of the blocks that moved, all are taken to have stayed: that is cheaper.
constexpr double kFewestMoved = 0.03;

/// How many of some pixels of a frame differ from known ones.
int count_differing_pixels(const std::uint8_t* row, const Rgba* known, int count) {
  int x = 0;
  Word4 counts{};
  for (; x + kWordLanes <= count; x += kWordLanes) {
    const Word4 four = load_normalized(row + sizeof(Rgba) * x);
    counts -= reinterpret_cast<Word4>(four != load_vector<Word4>(known + x));
  }
  auto differing = static_cast<int>(counts[0] + counts[1] + counts[2] + counts[3]);
  for (; x < count; ++x) {
    Rgba pixel;
    std::memcpy(&pixel, row + sizeof(Rgba) * x, sizeof pixel);
    differing += normalized(pixel) == known[x] ? 0 : 1;
  }
  return differing;
}

/// Whether a whole block of a frame is known ones, row by row.
bool is_known_block(const std::uint8_t* row, std::ptrdiff_t pitch, const Rgba* known, int stride) {
  static_assert(BlockGrid::kSide == 2 * kWordLanes);
  Word4 differing{};
  for (int y = 0; y < BlockGrid::kSide; ++y, row += pitch, known += stride) {
    differing |= load_normalized(row) ^ load_vector<Word4>(known);
    differing |= load_normalized(row + sizeof(Word4)) ^ load_vector<Word4>(known + kWordLanes);
  }
  return is_zero(differing);
}

}  // namespace

void BlockMoves::start(const Lattice& lattice, std::span<const glm::ivec2> moves) {
  grid_ = BlockGrid(lattice);
  moves_.assign(moves.begin(), moves.end());
  index_.assign(std::size_t(grid_.columns + 2) * (grid_.rows + 2), kOutside);
  changed_.reset(grid_);
  is_known_ = true;
  changed_pixels_ = 0;
}

void BlockMoves::set_unknown(const Lattice& lattice) {
  const glm::ivec2 none(0);
  start(lattice, {&none, 1});
  is_known_ = false;
  changed_.add_all();
  for (int row = 0; row < grid_.rows; ++row) std::fill_n(index_.begin() + place(0, row), grid_.columns, 0);
  changed_pixels_ = lattice.width() * lattice.height();
  find_runs();
}

bool BlockMoves::find_changed_rows(const FrameView& frame, const SimilarityGraph& before) {
  is_row_changed_.resize(frame.height);
  bool any = false;
  for (int y = 0; y < frame.height; ++y) {
    const std::uint8_t* row = frame.pixels + y * frame.pitch;
    const Rgba* known = before.pixels.data() + before.lattice.pixel(0, y);
    const bool is_changed = std::memcmp(row, known, sizeof(Rgba) * frame.width) != 0 &&
                            count_differing_pixels(row, known, frame.width) != 0;
    is_row_changed_[y] = is_changed ? 1 : 0;
    any |= is_changed;
  }
  return any;
}

/// How many pixels of a block a move does not explain; at least `most` where they are as many.
int BlockMoves::count_differing(const FrameView& frame, const SimilarityGraph& before, int column, int row,
                                glm::ivec2 move, int most) const {
  const int from = grid_.first_x(column), to = grid_.end_x(column);
  const int west = std::clamp(move.x, from, to), east = std::clamp(frame.width + move.x, west, to);
  const int north = grid_.first_y(row), south = grid_.end_y(row);
  const bool stays = move == glm::ivec2(0);
  const bool is_whole = !stays && east - west == BlockGrid::kSide && south - north == BlockGrid::kSide &&
                        north >= move.y && south <= frame.height + move.y;
  if (is_whole && is_known_block(frame.pixels + north * frame.pitch + sizeof(Rgba) * west, frame.pitch,
                                 before.pixels.data() + before.lattice.pixel(west - move.x, north - move.y),
                                 before.lattice.stride())) {
    return 0;
  }
  int differing = 0;
  for (int y = north; y < south && differing < most; ++y) {
    if (stays && is_row_changed_[y] == 0) continue;
    const int source = y - move.y;
    if (source < 0 || source >= frame.height) {
      differing += to - from;
      continue;
    }
    differing += (to - from) - (east - west) +
                 count_differing_pixels(frame.pixels + y * frame.pitch + sizeof(Rgba) * west,
                                        before.pixels.data() + before.lattice.pixel(west - move.x, source),
                                        east - west);
  }
  return differing;
}

void BlockMoves::find(const FrameView& frame, const SimilarityGraph& before,
                      std::span<const glm::ivec2> moves) {
  const glm::ivec2 none(0);
  const bool is_still = moves.size() == 1 && moves[0] == none;
  choose(frame, before, moves);
  if (!is_still && count_moved() < kFewestMoved * grid_.columns * grid_.rows)
    choose(frame, before, {&none, 1});
  find_runs();
}

int BlockMoves::count_moved() const {
  int moved = 0;
  for (const std::uint8_t index : index_)
    moved += index != kOutside && moves_[index] != glm::ivec2(0) ? 1 : 0;
  return moved;
}

void BlockMoves::choose(const FrameView& frame, const SimilarityGraph& before,
                        std::span<const glm::ivec2> moves) {
  start(before.lattice, moves);
  const bool is_still = moves.size() == 1 && moves[0] == glm::ivec2(0);
  for (int row = 0; row < grid_.rows; ++row) {
    std::fill_n(index_.begin() + place(0, row), grid_.columns, 0);
    const auto first_y = is_row_changed_.begin() + grid_.first_y(row);
    if (is_still && std::find(first_y, is_row_changed_.begin() + grid_.end_y(row), 1) ==
                        is_row_changed_.begin() + grid_.end_y(row)) {
      continue;
    }
    for (int column = 0; column < grid_.columns; ++column) {
      constexpr int kAll = BlockGrid::kSide * BlockGrid::kSide;
      int best = 0, fewest = count_differing(frame, before, column, row, moves[0], kAll);
      for (std::size_t i = 1; i < moves.size() && fewest >= kClearlyMore; ++i) {
        const int most = fewest - kClearlyMore + 1;
        const int differing = count_differing(frame, before, column, row, moves[i], most);
        if (differing >= most) continue;
        fewest = differing;
        best = static_cast<int>(i);
      }
      index_[place(column, row)] = static_cast<std::uint8_t>(best);
      if (fewest == 0) continue;
      changed_.add(column, row);
      changed_pixels_ += fewest;
    }
  }
}

void BlockMoves::find_runs() {
  changed_.find_runs();
  runs_.clear();
  first_run_.assign(1, 0);
  any_moved_ = false;
  for (int row = 0; row < grid_.rows; ++row) {
    for (int column = 0; column < grid_.columns;) {
      const int first = column;
      while (column < grid_.columns && move_index(column, row) == move_index(first, row)) ++column;
      runs_.push_back({grid_.first_x(first), grid_.end_x(column - 1), move(first, row)});
      any_moved_ |= runs_.back().move != glm::ivec2(0);
    }
    first_run_.push_back(static_cast<int>(runs_.size()));
  }
  find_seams();
}

void BlockMoves::find_seams() {
  seams_.clear();
  if (!any_moved_) return;
  const int pitch = grid_.columns + 2;
  for (int row = 0; row < grid_.rows; ++row) {
    for (int column = 0; column < grid_.columns; ++column) {
      const std::uint8_t* own = index_.data() + place(column, row);
      const auto differ = [&](const std::uint8_t* at) {
        return (at[-1] ^ own[0]) | (at[0] ^ own[0]) | (at[1] ^ own[0]);
      };
      if ((differ(own - pitch) | differ(own) | differ(own + pitch)) == 0) continue;
      for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
          const Seam seam{column, row, {x, y}};
          if (is_seam(seam)) seams_.push_back(seam);
        }
      }
    }
  }
}

bool BlockMoves::is_seam(const Seam& seam) const {
  const int x = seam.column + seam.step.x, y = seam.row + seam.step.y;
  if (!is_border(seam)) return move_index(x, y) != move_index(seam.column, seam.row);
  const glm::ivec2 own = move(seam.column, seam.row);
  return (own.x != 0 && (x < 0 || x >= grid_.columns)) || (own.y != 0 && (y < 0 || y >= grid_.rows));
}

}  // namespace depixel
