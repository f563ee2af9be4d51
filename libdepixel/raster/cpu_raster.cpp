#include "libdepixel/raster/cpu_raster.hpp"

#include <algorithm>

#include "libdepixel/raster/curve_to_output.hpp"
#include "libdepixel/raster/flatten.hpp"

namespace depixel {
namespace {

constexpr int kBandHeight = kBandRows * kRasterSubpixels;

int bands_of(const OutputGrid& grid) {
  return (grid.target.height + kBandRows - 1) / kBandRows;
}

/// How far a curve reaches upwards and downwards, of the ordinates of its points.
struct Reach {
  Reach(int y0, int y1, int y2, int y3)
      : top(std::min(std::min(y0, y1), std::min(y2, y3))),
        bottom(std::max(std::max(y0, y1), std::max(y2, y3))) {}
  bool is_level() const { return top == bottom; }

  int top, bottom;
};

template <typename Sums>
void add_segment(const Segment& s, const std::vector<Rgba>& colours, const OutputGrid& grid, Sums& sums) {
  const auto change = Sums::change(colours[s.right], colours[s.left]);
  flatten(grid(s.p0), grid(s.p1), grid(s.p2), grid(s.p3),
          flattening_pieces(s.p0, s.p1, s.p2, s.p3, grid.scale),
          [&](glm::ivec2 a, glm::ivec2 b) { sums.add_line(a.x, a.y, b.x, b.y, change); });
}

}  // namespace

/// Counting sort of the segments by the bands they touch. Level segments are left out.
void CpuRaster::sort_into_bands(const PlanarMap& map, const OutputGrid& grid, int bands) {
  const std::vector<Segment>& segments = map.segments;
  ranges_.resize(segments.size());
  first_.assign(bands + 1, 0);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    const Reach reach(s.p0.y, s.p1.y, s.p2.y, s.p3.y);
    const int top = grid.y(reach.top), bottom = grid.y(reach.bottom);
    const bool is_seen = top < bottom && bottom > 0 && top < bands * kBandHeight;
    ranges_[i] =
        is_seen ? BandRange{std::max(top, 0) / kBandHeight, std::min((bottom - 1) / kBandHeight, bands - 1)}
                : BandRange{0, -1};
    for (int band = ranges_[i].from; band <= ranges_[i].to; ++band) ++first_[band + 1];
  }
  for (int band = 0; band < bands; ++band) first_[band + 1] += first_[band];
  order_.resize(first_[bands]);
  next_ = first_;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (int band = ranges_[i].from; band <= ranges_[i].to; ++band)
      order_[next_[band]++] = static_cast<int>(i);
  }
}

template <typename Sums>
void CpuRaster::add_curves(const PlanarMap& map, const std::vector<Rgba>& colours, const OutputGrid& grid,
                           int band, Sums& sums) const {
  for (int i = first_[band]; i < first_[band + 1]; ++i) {
    const Segment& s = map.segments[order_[i]];
    add_segment(s, colours, grid, sums);
  }
}

/// No curve reaches a pixel beyond its edge, so only a few rows of corners matter. Level curves do not.
template <typename Sums>
void CpuRaster::add_curves(const MapByEdge& map, const std::vector<Rgba>& colours, const OutputGrid& grid,
                           int band, Sums& sums) const {
  // In subpixels of the source.
  const std::int64_t top = grid.y.first_at(band * kBandHeight + 1);
  const std::int64_t bottom = grid.y.first_at((band + 1) * kBandHeight);
  const std::int64_t height = grid.lattice.height();
  const auto first = static_cast<int>(std::clamp<std::int64_t>(top / kSubpixels - 1, 0, height));
  const auto last = static_cast<int>(std::clamp<std::int64_t>(bottom / kSubpixels + 1, 0, height));
  const bool is_whole = CurveToOutput::fits(grid);
  for (int y = first; y <= last; ++y) {
    if (is_whole) {
      add_row(map, colours, grid, y, band, sums);
      continue;
    }
    for_each_segment(map, y, [&](const Segment& s) {
      const Reach reach(s.p0.y, s.p1.y, s.p2.y, s.p3.y);
      if (reach.bottom >= top && reach.top < bottom && !reach.is_level()) add_segment(s, colours, grid, sums);
    });
  }
}

/// The same for the edges that leave a row of corners, where all has its place by whole output pixels.
template <typename Sums>
void CpuRaster::add_row(const MapByEdge& map, const std::vector<Rgba>& colours, const OutputGrid& grid, int y,
                        int band, Sums& sums) const {
  const CurveToOutput to_output(grid);
  const int stride = map.edges.lattice.stride(), row = grid.row(y);
  const int first_column = grid.column(0), step = grid.x.whole_scale() * kRasterSubpixels;
  const int top = band * kBandHeight - row, bottom = top + kBandHeight;
  for_each_visible_edge(map, y, [&](int number, int corner, int x, bool southwards) {
    const EdgeCurve& curve = map.table.curve(number);
    const CurveToOutput::Points p = to_output(curve);
    const Reach reach(p[0].y, p[1].y, p[2].y, p[3].y);
    if (reach.bottom <= top || reach.top >= bottom || reach.is_level()) return;
    const EdgeSides sides = sides_of(corner, southwards, stride);
    const auto change = Sums::change(colours[sides.right], colours[sides.left]);
    const glm::ivec2 owner(first_column + x * step, row);
    to_output.flatten(curve, p, [&](glm::ivec2 a, glm::ivec2 b) {
      sums.add_line(owner.x + a.x, owner.y + a.y, owner.x + b.x, owner.y + b.y, change);
    });
  });
}

template <typename Map, typename Sums>
void CpuRaster::draw_band(const Map& map, const std::vector<Rgba>& colours, const OutputGrid& grid, int band,
                          Sums& sums) const {
  const Lattice& lattice = grid.lattice;
  const int first_row = band * kBandRows;
  const int rows = std::min(kBandRows, grid.target.height - first_row);
  sums.resize(grid.target.width);
  sums.start(first_row, rows);
  add_curves(map, colours, grid, band, sums);
  // The border: on the left, the picture begins; on the right, it ends.
  const int west = grid.column(0), east = grid.column(lattice.width());
  const int top = first_row * kRasterSubpixels, bottom = top + rows * kRasterSubpixels;
  const auto row_at = [&](int output) {
    return static_cast<int>(
        std::clamp<std::int64_t>(grid.y.source(output) / kSubpixels, 0, lattice.height()));
  };
  for (int y = row_at(top), end = std::min(row_at(bottom) + 1, lattice.height()); y < end; ++y) {
    const int y0 = grid.row(y), y1 = grid.row(y + 1);
    sums.add_line(west, y0, west, y1, Sums::change(Rgba{}, colours[lattice.pixel(0, y)]));
    sums.add_line(east, y0, east, y1, Sums::change(colours[lattice.pixel(lattice.width() - 1, y)], Rgba{}));
  }
  for (int row = 0; row < rows; ++row) {
    sums.resolve(row, grid.target.pixels + (first_row + row) * grid.target.pitch);
  }
}

template <typename Model, typename Map>
void CpuRaster::draw_bands(const Map& map, const std::vector<Rgba>& colours, const OutputGrid& grid) {
  auto& sums = std::get<std::vector<RasterSums<Model>>>(sums_);
  const auto threads = static_cast<std::size_t>(workers_.threads());
  if (sums.size() < threads) sums.resize(threads);
  workers_.run(bands_of(grid), [&](int band, int thread) {
    const int first_row = band * kBandRows, end_row = std::min(first_row + kBandRows, grid.target.height);
    if (map.shading.any && field_.is_shaded(first_row, end_row)) {
      sums[thread].shaded.shade_by(field_, 0);
      draw_band(map, colours, grid, band, sums[thread].shaded);
    } else {
      draw_band(map, colours, grid, band, sums[thread].even);
    }
  });
}

template <typename Map>
void CpuRaster::draw_by_model(const Map& map, const OutputGrid& grid, bool linear_light) {
  if (is_drawing_) sums_ = {};  // the last picture failed, and a part of it is in them
  is_drawing_ = true;
  const std::vector<Rgba>& colours = colours_.of(map.colours, grid.target.order);
  if (map.shading.any)
    field_.start(map.shading, colours, shades_.of(map.shading.shades, grid.target.order), grid);
  if (grid.covers_target() && is_opaque(grid.lattice, map.colours)) {
    linear_light ? draw_bands<OpaqueLight>(map, colours, grid) : draw_bands<OpaqueColour>(map, colours, grid);
  } else {
    linear_light ? draw_bands<Translucent<true>>(map, colours, grid)
                 : draw_bands<Translucent<false>>(map, colours, grid);
  }
  is_drawing_ = false;
}

void CpuRaster::draw(const MapByEdge& map, const View& view, bool linear_light, int threads,
                     const PictureView& target) {
  if (target.width <= 0 || target.height <= 0) return;
  workers_.set_threads(threads);
  draw_by_model(map, OutputGrid(view, map.edges.lattice, target), linear_light);
}

void CpuRaster::draw(const PlanarMap& map, const View& view, bool linear_light, int threads,
                     const PictureView& target) {
  if (target.width <= 0 || target.height <= 0) return;
  workers_.set_threads(threads);
  const OutputGrid grid(view, map.lattice, target);
  sort_into_bands(map, grid, bands_of(grid));
  draw_by_model(map, grid, linear_light);
}

std::size_t memory_bytes(const SumsOfModels& sums) {
  std::size_t bytes = 0;
  const auto add = [&](const auto& of_threads) {
    bytes += held_bytes(of_threads);
    for (const auto& own : of_threads) bytes += own.memory_bytes();
  };
  std::apply([&](const auto&... of_model) { (add(of_model), ...); }, sums);
  return bytes;
}

std::size_t CpuRaster::memory_bytes() const {
  return held_bytes(ranges_, order_, first_, next_) + colours_.memory_bytes() + shades_.memory_bytes() +
         field_.memory_bytes() + depixel::memory_bytes(sums_);
}

}  // namespace depixel
