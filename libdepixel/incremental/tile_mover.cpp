#include "libdepixel/incremental/tile_mover.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

#include "libdepixel/core/color.hpp"
#include "libdepixel/core/simd.hpp"

namespace depixel {
namespace {

/// Where a view cuts the frame, lines are cut too, and rounded there: what lies within this many tiles of the
/// cut may differ from what it is elsewhere. No line is longer than two tiles.
constexpr int kCutMargin = 2;

/// The tiles along an axis that lie in the picture with all their pixels and whose pixels are what they would
/// be elsewhere: from .. to - 1.
struct Movable {
  int from, to;

  /// \param first_px  output pixel at which tile 0 begins.
  Movable(int first_px, int scale, int tiles, int target_px, int margin)
      : from(first_px >= 0 ? 0 : -(first_px / scale) + margin + 1),
        to(first_px + tiles * scale <= target_px ? tiles : (target_px - first_px) / scale - margin) {}

  /// Those that a move also brings from such tiles.
  Movable moved_by(int move) const {
    Movable both = *this;
    both.from += std::max(move, 0);
    both.to += std::min(move, 0);
    return both;
  }
};

/// Where the run of equal bytes that begins at `from` ends, at most at `end`. May read up to seven bytes
/// beyond.
int run_end(const std::uint8_t* bytes, int from, int end) {
  constexpr int kAtOnce = sizeof(std::uint64_t);
  constexpr std::uint64_t kEach = 0x0101'0101'0101'0101;
  const std::uint64_t alike = kEach * bytes[from];
  for (int x = from + 1; x < end; x += kAtOnce) {
    const std::uint64_t differs = load_bytes(bytes + x) ^ alike;
    if (differs != 0) return std::min(x + std::countr_zero(differs) / 8, end);
  }
  return end;
}

}  // namespace

/// Of what moved, tiles that cannot be moved become stale.
void TileMover::find_runs(const OutputGrid& grid, const MapChanges& changes,
                          std::vector<std::uint8_t>& is_stale) {
  const Lattice& lattice = grid.lattice;
  const Movable columns(grid.column(0) / kRasterSubpixels, grid.x.whole_scale(), lattice.width(),
                        grid.target.width, kCutMargin);
  const Movable rows(grid.row(0) / kRasterSubpixels, grid.y.whole_scale(), lattice.height(),
                     grid.target.height, 0);
  if (runs_.size() < changes.moves.size()) runs_.resize(changes.moves.size());
  for (int y = 0; y < lattice.height(); ++y) {
    const int row = lattice.pixel(0, y);
    const std::uint8_t* tiles = changes.tiles.data() + row;
    for (int x = 0; x < lattice.width();) {
      const Run whole{y, x, run_end(tiles, x, lattice.width())};
      x = whole.to;
      if (tiles[whole.from] < MapChanges::kMoved) continue;
      const std::size_t move = tiles[whole.from] - MapChanges::kMoved;
      const Movable across = columns.moved_by(changes.moves[move].x),
                    down = rows.moved_by(changes.moves[move].y);
      Run run{y, std::max(whole.from, across.from), std::min(whole.to, across.to)};
      if (run.from >= run.to || y < down.from || y >= down.to) run.from = run.to = whole.from;
      std::fill(is_stale.begin() + row + whole.from, is_stale.begin() + row + run.from, std::uint8_t{1});
      std::fill(is_stale.begin() + row + run.to, is_stale.begin() + row + whole.to, std::uint8_t{1});
      if (run.from < run.to) runs_[move].push_back(run);
    }
  }
}

std::int64_t TileMover::move(const OutputGrid& grid, const MapChanges& changes,
                             std::vector<std::uint8_t>& is_stale) {
  const int scale_x = grid.x.whole_scale(), scale_y = grid.y.whole_scale();
  const bool can_move = scale_x != 0 && scale_y != 0 && changes.moved_tiles != 0;
  const std::uint8_t last_stale = can_move ? MapChanges::kNew : std::numeric_limits<std::uint8_t>::max();
  is_stale.resize(changes.tiles.size());
  std::transform(changes.tiles.begin(), changes.tiles.end(), is_stale.begin(), [&](std::uint8_t tile) {
    return static_cast<std::uint8_t>(tile != MapChanges::kSame && tile <= last_stale ? 1 : 0);
  });
  if (!can_move) return 0;
  for (std::vector<Run>& runs : runs_) runs.clear();
  find_runs(grid, changes, is_stale);

  const std::ptrdiff_t pitch = grid.target.pitch;
  constexpr std::ptrdiff_t kPixel = sizeof(Rgba);
  std::uint8_t* origin = grid.target.pixels + grid.row(0) / kRasterSubpixels * pitch +
                         grid.column(0) / kRasterSubpixels * kPixel;
  // Visits the rows of output pixels of a move's runs, against the direction of the move, so that none is
  // overwritten before it is read.
  const auto for_each_row = [&](std::size_t move, auto visit) {
    const glm::ivec2 by = changes.moves[move];
    const std::ptrdiff_t back = -(std::ptrdiff_t{by.y} * scale_y * pitch + by.x * scale_x * kPixel);
    const std::vector<Run>& runs = runs_[move];
    const bool is_backwards = by.y > 0 || (by.y == 0 && by.x > 0);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const Run& run = runs[is_backwards ? runs.size() - 1 - i : i];
      std::uint8_t* to = origin + std::ptrdiff_t{run.row} * scale_y * pitch + run.from * scale_x * kPixel;
      const std::size_t bytes = std::size_t(run.to - run.from) * scale_x * kPixel;
      for (int row = 0; row < scale_y; ++row, to += pitch) visit(to, to + back, bytes);
    }
  };
  // The largest move is done in place; the pixels of the others are held until it is done.
  std::size_t tiles = 0, most = 0, largest = 0;
  for (std::size_t move = 0; move < changes.moves.size(); ++move) {
    std::size_t own = 0;
    for (const Run& run : runs_[move]) own += run.to - run.from;
    tiles += own;
    if (own <= most) continue;
    most = own;
    largest = move;
  }
  const std::size_t held_tiles = tiles - most;
  const auto for_each_held_row = [&](auto visit) {
    for (std::size_t move = 0; move < changes.moves.size(); ++move) {
      if (move != largest) for_each_row(move, visit);
    }
  };
  held_.resize(std::max(held_.size(), held_tiles * scale_x * scale_y * kPixel));
  std::uint8_t* held = held_.data();
  for_each_held_row([&](std::uint8_t*, const std::uint8_t* from, std::size_t bytes) {
    std::memcpy(held, from, bytes);
    held += bytes;
  });
  for_each_row(largest, [](std::uint8_t* to, const std::uint8_t* from, std::size_t bytes) {
    std::memmove(to, from, bytes);
  });
  held = held_.data();
  for_each_held_row([&](std::uint8_t* to, const std::uint8_t*, std::size_t bytes) {
    std::memcpy(to, held, bytes);
    held += bytes;
  });
  return static_cast<std::int64_t>(tiles) * scale_x * scale_y;
}

std::size_t TileMover::memory_bytes() const {
  std::size_t bytes = held_bytes(runs_, held_);
  for (const std::vector<Run>& runs : runs_) bytes += held_bytes(runs);
  return bytes;
}

}  // namespace depixel
