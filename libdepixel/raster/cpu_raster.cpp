#include "libdepixel/raster/cpu_raster.hpp"

#include <algorithm>

#include "libdepixel/raster/flatten.hpp"

namespace depixel {
namespace {

constexpr int kBandHeight = BandSums<OpaqueColour>::kRows * kRasterSubpixels;

}  // namespace

/// Counting sort of the segments by the bands they touch. Level segments are left out: they change no sum.
void CpuRaster::sort_into_bands(const PlanarMap& map, const OutputGrid& grid, int bands) {
  const std::vector<Segment>& segments = map.segments;
  ranges_.resize(segments.size());
  first_.assign(bands + 1, 0);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    const int low = grid.y(std::min(std::min(s.p0.y, s.p1.y), std::min(s.p2.y, s.p3.y)));
    const int high = grid.y(std::max(std::max(s.p0.y, s.p1.y), std::max(s.p2.y, s.p3.y)));
    const bool is_seen = low < high && high > 0 && low < bands * kBandHeight;
    ranges_[i] =
        is_seen ? BandRange{std::max(low, 0) / kBandHeight, std::min((high - 1) / kBandHeight, bands - 1)}
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
void CpuRaster::draw_band(const PlanarMap& map, const std::vector<Rgba>& colours, const OutputGrid& grid,
                          int band, Sums& sums) const {
  const Lattice& lattice = map.lattice;
  const int first_row = band * Sums::kRows;
  const int rows = std::min(Sums::kRows, grid.target.height - first_row);
  sums.resize(grid.target.width);
  sums.start(first_row, rows);
  for (int i = first_[band]; i < first_[band + 1]; ++i) {
    const Segment& s = map.segments[order_[i]];
    const auto change = Sums::change(colours[s.right], colours[s.left]);
    flatten(grid(s.p0), grid(s.p1), grid(s.p2), grid(s.p3),
            flattening_pieces(s.p0, s.p1, s.p2, s.p3, grid.scale),
            [&](glm::ivec2 a, glm::ivec2 b) { sums.add_line(a.x, a.y, b.x, b.y, change); });
  }
  // The border: on the left, the picture begins; on the right, it ends.
  const int west = grid.column(0), east = grid.column(lattice.width());
  const int top = first_row * kRasterSubpixels, bottom = top + rows * kRasterSubpixels;
  for (int y = 0; y < lattice.height(); ++y) {
    const int y0 = grid.row(y), y1 = grid.row(y + 1);
    if (y1 <= top || y0 >= bottom) continue;
    sums.add_line(west, y0, west, y1, Sums::change(Rgba{}, colours[lattice.pixel(0, y)]));
    sums.add_line(east, y0, east, y1, Sums::change(colours[lattice.pixel(lattice.width() - 1, y)], Rgba{}));
  }
  for (int row = 0; row < rows; ++row) {
    sums.resolve(row, grid.target.pixels + (first_row + row) * grid.target.pitch);
  }
}

template <typename Model>
void CpuRaster::draw_bands(const PlanarMap& map, const std::vector<Rgba>& colours, const OutputGrid& grid,
                           int bands) {
  auto& sums = std::get<std::vector<RasterSums<Model>>>(sums_);
  const auto threads = static_cast<std::size_t>(workers_.threads());
  if (sums.size() < threads) sums.resize(threads);
  workers_.run(bands, [&](int band, int thread) {
    const int first_row = band * BandSums<Model>::kRows;
    const int end_row = std::min(first_row + BandSums<Model>::kRows, grid.target.height);
    if (map.shading.any && field_.is_shaded(first_row, end_row)) {
      sums[thread].shaded.shade_by(field_, 0);
      draw_band(map, colours, grid, band, sums[thread].shaded);
    } else {
      draw_band(map, colours, grid, band, sums[thread].even);
    }
  });
}

void CpuRaster::draw(const PlanarMap& map, const View& view, bool linear_light, int threads,
                     const PictureView& target) {
  if (target.width <= 0 || target.height <= 0) return;
  workers_.set_threads(threads);
  const OutputGrid grid(view, map.lattice, target);
  const int bands = (target.height + BandSums<OpaqueColour>::kRows - 1) / BandSums<OpaqueColour>::kRows;
  sort_into_bands(map, grid, bands);
  const std::vector<Rgba>& colours = colours_.of(map.colours, target.order);
  if (map.shading.any) field_.start(map.shading, colours, shades_.of(map.shading.shades, target.order), grid);
  if (grid.covers_target() && is_opaque(map.lattice, map.colours)) {
    linear_light ? draw_bands<OpaqueLight>(map, colours, grid, bands)
                 : draw_bands<OpaqueColour>(map, colours, grid, bands);
  } else {
    linear_light ? draw_bands<Translucent<true>>(map, colours, grid, bands)
                 : draw_bands<Translucent<false>>(map, colours, grid, bands);
  }
}

std::size_t CpuRaster::memory_bytes() const {
  return held_bytes(ranges_, order_, first_, next_) + colours_.memory_bytes() + shades_.memory_bytes() +
         field_.memory_bytes();
}

}  // namespace depixel
