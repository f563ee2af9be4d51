#include "libdepixel/incremental/picture_updater.hpp"

#include <algorithm>
#include <cstring>

#include "libdepixel/raster/flatten.hpp"

namespace depixel {
namespace {

/// Strips are about this many rows of tiles high: with more, a curve is flattened less often, with fewer,
/// less is drawn that did not change.
constexpr int kStripTiles = 2;
/// Windows with fewer tiles than this between them are drawn as one.
constexpr int kLeastGap = 3;
/// Curves that are drawn with a window end at most this many tiles beyond it: those of the next tile, into
/// which the window's last pixels may reach, are owned by corners one further on.
constexpr int kBeyondWindow = 3;

int floor_px(int subpixels) {
  return subpixels >> 8;
}
int ceil_px(int subpixels) {
  return (subpixels + kRasterSubpixels - 1) >> 8;
}
static_assert(kRasterSubpixels == 1 << 8);

/// Bits of a TileMask for the rows of tiles first .. end - 1, seen from an edge whose owner lies in a row of
/// corners.
TileMask rows_mask(int owner_row, int first, int end) {
  TileMask mask = 0;
  for (int row = -1; row <= 1; ++row) {
    if (owner_row + row >= first && owner_row + row < end) mask |= static_cast<TileMask>(7 << 3 * (row + 1));
  }
  return mask;
}

void unite(const std::uint8_t* from, int count, std::uint8_t* to) {
  for (int i = 0; i < count; ++i) to[i] |= from[i];
}

}  // namespace

void PictureUpdater::draw(const IncrementalVectorizer& source, const MapChanges& changes, const View& view,
                          bool linear_light, int threads, const PictureView& target, bool is_kept) {
  drawn_pixels_ = moved_pixels_ = 0;
  if (target.width <= 0 || target.height <= 0) {
    drawn_ = {};  // what changed is told once, and no picture shows it
    return;
  }
  const OutputGrid grid(view, source.lattice(), target);
  const bool opaque = grid.covers_target() && source.is_opaque();
  const Drawn now{target, view, source.lattice(), linear_light, opaque};
  const bool is_update =
      is_kept && now == drawn_ && !changes.everything && view.scale_x >= 1 && view.scale_y >= 1;
  if (is_update && !changes.any()) return;
  drawn_ = {};  // until all is drawn
  if (is_update) {
    update(source, changes, grid, now, threads);
  } else {
    raster_.draw(source.by_edge(), view, linear_light, threads, target);
    drawn_pixels_ = std::int64_t{target.width} * target.height;
  }
  drawn_ = now;
}

void PictureUpdater::update(const IncrementalVectorizer& source, const MapChanges& changes,
                            const OutputGrid& grid, const Drawn& now, int threads) {
  if (is_updating_) {  // the last update failed, and parts of it are in these
    painter_ = {};
    sums_ = {};
  }
  is_updating_ = true;
  workers_.set_threads(threads);
  const std::vector<Rgba>& colours = colours_.of(source.colours(), grid.target.order);
  moved_pixels_ = mover_.move(grid, changes, is_stale_);
  if (source.shading().any)
    field_.start(source.shading(), colours, shades_.of(source.shading().shades, grid.target.order), grid);
  if (now.opaque) {
    now.linear_light ? draw_stale<OpaqueLight>(source, colours, grid)
                     : draw_stale<OpaqueColour>(source, colours, grid);
  } else {
    now.linear_light ? draw_stale<Translucent<true>>(source, colours, grid)
                     : draw_stale<Translucent<false>>(source, colours, grid);
  }
  is_updating_ = false;
}

void PictureUpdater::find_strips(const OutputGrid& grid) {
  const Lattice& lattice = grid.lattice;
  const int rows = std::clamp(static_cast<int>(kStripTiles * grid.scale.y), 1, kBandRows);
  strips_.clear();
  int first = 0, end = 0;
  for (int first_px = 0; first_px < grid.target.height; first_px += rows) {
    const int end_px = std::min(first_px + rows, grid.target.height);
    while (first < lattice.height() && grid.row(first + 1) <= first_px * kRasterSubpixels) ++first;
    while (end < lattice.height() && grid.row(end) < end_px * kRasterSubpixels) ++end;
    bool is_stale = false;
    for (int y = first; y < end && !is_stale; ++y) {
      is_stale = std::memchr(is_stale_.data() + lattice.pixel(0, y), 1, lattice.width()) != nullptr;
    }
    if (is_stale) strips_.push_back({first_px, end_px, first, end});
  }
}

void PictureUpdater::find_windows(const IncrementalVectorizer& source, const OutputGrid& grid,
                                  const Strip& strip, Scratch& scratch) const {
  const Lattice& lattice = grid.lattice;
  const int width = lattice.width();
  scratch.stale.assign(width, 0);
  scratch.occupied.assign(width + 1, 0);
  static_assert(sizeof(CornerCode) == 1);
  const auto* codes = reinterpret_cast<const std::uint8_t*>(source.cells().corners.data());
  for (int y = strip.first; y < strip.end; ++y) {
    unite(is_stale_.data() + lattice.pixel(0, y), width, scratch.stale.data());
  }
  for (int y = strip.first; y <= strip.end; ++y) {
    unite(codes + lattice.corner(0, y), width + 1, scratch.occupied.data());
  }
  scratch.windows.clear();
  for (int x = 0; x < width;) {
    const auto* next = static_cast<const std::uint8_t*>(std::memchr(scratch.stale.data() + x, 1, width - x));
    if (next == nullptr) break;
    const int from = static_cast<int>(next - scratch.stale.data());
    for (x = from; x < width && scratch.stale[x] != 0;) ++x;
    if (!scratch.windows.empty() && from - scratch.windows.back().to < kLeastGap) {
      scratch.windows.back().to = x;
    } else {
      scratch.windows.push_back({0, from, x});
    }
  }
  // East of this, what lies at the target's side is cut off.
  int east_end = width;
  while (grid.column(east_end) > (grid.target.width - (east_end < width ? 1 : 0)) * kRasterSubpixels)
    --east_end;
  const std::uint8_t* occupied = scratch.occupied.data();
  const auto is_clear = [&](int x) { return (occupied[x] | occupied[x + 1]) == 0; };
  for (Window& window : scratch.windows) {
    int west = window.from - 1, east = window.to;
    while (west >= 0 && !is_clear(west)) --west;
    const int nearer = window.from - west;
    while (east < std::min(width, window.to + nearer) && !is_clear(east)) ++east;
    window.clear = east <= east_end && east - window.to < nearer ? east : west;
  }
}

template <typename Sums>
void PictureUpdater::draw_window(const IncrementalVectorizer& source, const std::vector<Rgba>& colours,
                                 const OutputGrid& grid, const Strip& strip, const Window& window, Sums& sums,
                                 Scratch& scratch) const {
  const Lattice& lattice = grid.lattice;
  const bool is_clear_west = window.clear < window.from;
  const bool is_flattened = FlattenedCurves::fits(grid);
  // Corners whose edges are looked at, first .. end, and what their curves may reach. Where a source pixel is
  // not a whole number of output pixels, the first and last ones may reach into the next tiles.
  const int spill = is_flattened ? 0 : 1;
  const int first = is_clear_west ? window.clear + 1 : std::max(window.from - spill, 0);
  const int end = is_clear_west ? std::min(window.to + spill, lattice.width()) : window.clear;
  const int reach = is_clear_west ? window.to + kBeyondWindow : end;
  int left_px = floor_px(grid.column(std::max(window.from - kBeyondWindow, 0)));
  if (is_clear_west)
    left_px = window.clear < 0 ? floor_px(grid.column(0)) : ceil_px(grid.column(window.clear));
  left_px = std::max(left_px, 0);
  const int from_px = std::max(floor_px(grid.column(window.from)), left_px);
  const int to_px = std::min(ceil_px(grid.column(window.to)), grid.target.width);
  if (from_px >= to_px) return;
  const int right_px = std::min(ceil_px(grid.column(reach)) + 1, grid.target.width);
  sums.resize(right_px - left_px);
  sums.start(strip.first_px, strip.end_px - strip.first_px);
  if constexpr (requires { sums.shade_by(field_, left_px); }) sums.shade_by(field_, left_px);

  const int shift = left_px * kRasterSubpixels;
  const auto add = [&](int corner, int x, int y, int number, bool southwards) {
    const EdgeSides sides = sides_of(corner, southwards, lattice.stride());
    const auto change = Sums::change(colours[sides.right], colours[sides.left]);
    const auto add_line = [&](glm::ivec2 a, glm::ivec2 b) {
      sums.add_line(a.x - shift, a.y, b.x - shift, b.y, change);
    };
    if (!is_flattened) {
      const Segment s =
          segment_of(source.table().curve(number), {x, y}, corner, southwards, lattice.stride());
      flatten(grid(s.p0), grid(s.p1), grid(s.p2), grid(s.p3),
              flattening_pieces(s.p0, s.p1, s.p2, s.p3, grid.scale), add_line);
      return;
    }
    const glm::ivec2 owner(grid.column(x), grid.row(y));
    const std::span<const glm::i16vec2> points = scratch.flattened.points(number);
    for (std::size_t k = 1; k < points.size(); ++k) {
      add_line(owner + glm::ivec2(points[k - 1]), owner + glm::ivec2(points[k]));
    }
  };
  for (int y = std::max(strip.first - 1, 0); y <= std::min(strip.end + 1, lattice.height()); ++y) {
    const TileMask wanted = rows_mask(y, strip.first, strip.end);
    // An edge eastwards from the corner before the first touches its tile, too.
    const int west = std::max(first - 1, 0);
    const int* curve = source.edges().curve.data() + edge_slot(lattice.corner(west, y), false);
    for (int x = west; x <= end; ++x, curve += 2) {
      for (const int southwards : {0, 1}) {
        if (curve[southwards] == 0 || (x < first && southwards != 0)) continue;
        if ((source.table().tiles(curve[southwards]) & wanted) == 0) continue;
        add(lattice.corner(x, y), x, y, curve[southwards], southwards != 0);
      }
    }
  }
  // The border: on the left, the picture begins; on the right, it ends.
  const int west = grid.column(0) - shift, east = grid.column(lattice.width()) - shift;
  const bool has_west = first == 0, has_east = (is_clear_west ? window.to : window.clear) == lattice.width();
  for (int y = strip.first; y < strip.end; ++y) {
    const int y0 = grid.row(y), y1 = grid.row(y + 1);
    if (has_west) sums.add_line(west, y0, west, y1, Sums::change(Rgba{}, colours[lattice.pixel(0, y)]));
    if (has_east) {
      sums.add_line(east, y0, east, y1, Sums::change(colours[lattice.pixel(lattice.width() - 1, y)], Rgba{}));
    }
  }
  const int north = grid.row(0), south = grid.row(lattice.height());
  const bool is_border = window.clear < 0 || window.clear == lattice.width();
  const Rgba clear_colour = is_border ? Rgba{} : colours[lattice.pixel(window.clear, strip.first)];
  for (int row = strip.first_px; row < strip.end_px; ++row) {
    const int covered =
        std::max(std::min((row + 1) * kRasterSubpixels, south) - std::max(row * kRasterSubpixels, north), 0);
    const typename Sums::Start before = is_clear_west
                                            ? sums.start_from(clear_colour, covered)
                                            : sums.start_before(row - strip.first_px, clear_colour, covered);
    std::uint8_t* out = grid.target.pixels + row * grid.target.pitch + std::ptrdiff_t{4} * left_px;
    sums.resolve(row - strip.first_px, out, before, from_px - left_px, to_px - left_px);
  }
  scratch.drawn_pixels += std::int64_t{to_px - from_px} * (strip.end_px - strip.first_px);
}

template <typename Model>
void PictureUpdater::draw_stale(const IncrementalVectorizer& source, const std::vector<Rgba>& colours,
                                const OutputGrid& grid) {
  if (TilePainter::fits(grid)) {
    leave_shaded(source);
    drawn_pixels_ = painter_.draw<Model>(source, colours, grid, is_even_stale_, workers_);
    if (!source.shading().any) return;
  }
  find_strips(grid);
  draw_strips<Model>(source, colours, grid);
}

/// Parts the stale tiles into those that are shaded, which stay stale, and the others.
void PictureUpdater::leave_shaded(const IncrementalVectorizer& source) {
  if (!source.shading().any) {
    is_even_stale_.swap(is_stale_);
    return;
  }
  const Lattice& lattice = source.lattice();
  is_even_stale_.assign(is_stale_.size(), 0);
  for (int y = 0; y < lattice.height(); ++y) {
    for (int tile = lattice.pixel(0, y), end = tile + lattice.width(); tile < end; ++tile) {
      if (is_stale_[tile] == 0 || source.shading().is_shaded(tile, lattice.stride())) continue;
      std::swap(is_stale_[tile], is_even_stale_[tile]);
    }
  }
}

template <typename Sums>
void PictureUpdater::draw_windows(const IncrementalVectorizer& source, const std::vector<Rgba>& colours,
                                  const OutputGrid& grid, const Strip& strip, Sums& sums,
                                  Scratch& scratch) const {
  sums.resize(grid.target.width);  // room for all windows at once
  for (const Window& window : scratch.windows)
    draw_window(source, colours, grid, strip, window, sums, scratch);
}

template <typename Model>
void PictureUpdater::draw_strips(const IncrementalVectorizer& source, const std::vector<Rgba>& colours,
                                 const OutputGrid& grid) {
  auto& sums = std::get<std::vector<RasterSums<Model>>>(sums_);
  const auto threads = static_cast<std::size_t>(workers_.threads());
  if (sums.size() < threads) sums.resize(threads);
  if (scratch_.size() < threads) scratch_.resize(threads);
  for (Scratch& own : scratch_) {
    own.drawn_pixels = 0;
    own.flattened.start(source.table(), grid);
  }
  workers_.run(static_cast<int>(strips_.size()), [&](int part, int thread) {
    Scratch& own = scratch_[thread];
    const Strip& strip = strips_[part];
    find_windows(source, grid, strip, own);
    if (source.shading().any && field_.is_shaded(strip.first_px, strip.end_px)) {
      draw_windows(source, colours, grid, strip, sums[thread].shaded, own);
    } else {
      draw_windows(source, colours, grid, strip, sums[thread].even, own);
    }
  });
  for (const Scratch& own : scratch_) drawn_pixels_ += own.drawn_pixels;
}

std::size_t PictureUpdater::memory_bytes() const {
  std::size_t bytes = raster_.memory_bytes() + mover_.memory_bytes() + painter_.memory_bytes() +
                      held_bytes(is_stale_, is_even_stale_, strips_, scratch_) + colours_.memory_bytes() +
                      shades_.memory_bytes() + field_.memory_bytes() + depixel::memory_bytes(sums_);
  for (const Scratch& own : scratch_) {
    bytes += own.flattened.memory_bytes() + held_bytes(own.stale, own.occupied, own.windows);
  }
  return bytes;
}

}  // namespace depixel
