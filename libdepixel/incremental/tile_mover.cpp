#include "libdepixel/incremental/tile_mover.hpp"

#include <algorithm>
#include <cstring>

#include "libdepixel/core/color.hpp"

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

}  // namespace

/// Tiles are taken against the direction of the move, so that in one move none is overwritten before it is
/// read.
void TileMover::find_runs(const OutputGrid& grid, const MapChanges& changes,
                          std::vector<std::uint8_t>& is_stale) {
  const int scale_x = grid.x.whole_scale(), scale_y = grid.y.whole_scale();
  const Movable columns(grid.column(0) / kRasterSubpixels, scale_x, grid.lattice.width(), grid.target.width,
                        kCutMargin);
  const Movable rows(grid.row(0) / kRasterSubpixels, scale_y, grid.lattice.height(), grid.target.height, 0);
  for (std::size_t move = 0; move < changes.moves.size(); ++move) {
    const auto wanted = static_cast<std::uint8_t>(MapChanges::kMoved + move);
    const glm::ivec2 by = changes.moves[move];
    const Movable across = columns.moved_by(by.x), down = rows.moved_by(by.y);
    for (int i = 0; i < down.to - down.from; ++i) {
      const int y = by.y > 0 ? down.to - 1 - i : down.from + i;
      const std::size_t first_in_row = runs_.size();
      const int row = grid.lattice.pixel(0, y);
      const std::uint8_t* tiles = changes.tiles.data() + row;
      for (int x = across.from; x < across.to; ++x) {
        if (tiles[x] != wanted) continue;
        const int from = x;
        while (x < across.to && tiles[x] == wanted) ++x;
        runs_.push_back({y, from, x, move});
        std::fill(is_stale.begin() + row + from, is_stale.begin() + row + x, std::uint8_t{0});
      }
      if (by.x > 0) std::reverse(runs_.begin() + static_cast<std::ptrdiff_t>(first_in_row), runs_.end());
    }
  }
}

std::int64_t TileMover::move(const OutputGrid& grid, const MapChanges& changes,
                             std::vector<std::uint8_t>& is_stale) {
  is_stale.resize(changes.tiles.size());
  std::transform(changes.tiles.begin(), changes.tiles.end(), is_stale.begin(), [](std::uint8_t tile) {
    return static_cast<std::uint8_t>(tile == MapChanges::kSame ? 0 : 1);
  });
  const int scale_x = grid.x.whole_scale(), scale_y = grid.y.whole_scale();
  runs_.clear();
  if (scale_x == 0 || scale_y == 0 || changes.moved_tiles == 0) return 0;
  find_runs(grid, changes, is_stale);
  if (runs_.empty()) return 0;

  const std::ptrdiff_t pitch = grid.target.pitch;
  std::uint8_t* origin = grid.target.pixels + grid.row(0) / kRasterSubpixels * pitch +
                         grid.column(0) / kRasterSubpixels * std::ptrdiff_t{sizeof(Rgba)};
  const auto for_each_row = [&](const Run& run, auto visit) {
    const glm::ivec2 by = changes.moves[run.move];
    std::uint8_t* to = origin + std::ptrdiff_t{run.row} * scale_y * pitch +
                       std::ptrdiff_t{run.from} * scale_x * std::ptrdiff_t{sizeof(Rgba)};
    const std::uint8_t* from = to - std::ptrdiff_t{by.y} * scale_y * pitch -
                               std::ptrdiff_t{by.x} * scale_x * std::ptrdiff_t{sizeof(Rgba)};
    const std::size_t bytes = std::size_t(run.to - run.from) * scale_x * sizeof(Rgba);
    for (int row = 0; row < scale_y; ++row) visit(to + row * pitch, from + row * pitch, bytes);
  };
  // One move is done in place, the first and largest; the pixels of the others are held until it is done.
  const std::size_t in_place = runs_.front().move;
  std::int64_t pixels = 0;
  std::size_t held_bytes = 0;
  for (const Run& run : runs_) {
    const std::size_t area = std::size_t(run.to - run.from) * scale_x * scale_y;
    pixels += static_cast<std::int64_t>(area);
    if (run.move != in_place) held_bytes += area * sizeof(Rgba);
  }
  held_.resize(std::max(held_.size(), held_bytes));
  std::uint8_t* held = held_.data();
  for (const Run& run : runs_) {
    if (run.move == in_place) continue;
    for_each_row(run, [&](std::uint8_t*, const std::uint8_t* from, std::size_t bytes) {
      std::memcpy(held, from, bytes);
      held += bytes;
    });
  }
  for (const Run& run : runs_) {
    if (run.move != in_place) continue;
    for_each_row(run, [](std::uint8_t* to, const std::uint8_t* from, std::size_t bytes) {
      std::memmove(to, from, bytes);
    });
  }
  held = held_.data();
  for (const Run& run : runs_) {
    if (run.move == in_place) continue;
    for_each_row(run, [&](std::uint8_t* to, const std::uint8_t*, std::size_t bytes) {
      std::memcpy(to, held, bytes);
      held += bytes;
    });
  }
  return pixels;
}

}  // namespace depixel
