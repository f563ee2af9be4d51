#include "libdepixel/raster/cpu_raster.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "libdepixel/raster/flatten.hpp"

namespace depixel {
namespace {

/// Maps subpixels of the source to subpixels of the output by one rounded multiplication an axis.
class ToOutput {
 public:
  ToOutput(double scale, double origin)
      : factor_(std::llround(scale * kRasterSubpixels / kSubpixels * kOne)),
        offset_(std::llround(-origin * scale * kRasterSubpixels) * kOne + kOne / 2) {}
  int operator()(int subpixels) const { return static_cast<int>((subpixels * factor_ + offset_) >> kBits); }

 private:
  static constexpr int kBits = 28;
  static constexpr std::int64_t kOne = std::int64_t{1} << kBits;
  std::int64_t factor_, offset_;
};

bool is_opaque(const PlanarMap& map) {
  const Lattice& lattice = map.lattice;
  std::uint8_t all = 255;
  for (int y = 0; y < lattice.height(); ++y) {
    const Rgba* row = map.colours.data() + lattice.pixel(0, y);
    for (int x = 0; x < lattice.width(); ++x) all &= row[x].a;
  }
  return all == 255;
}

constexpr int kBandHeight = BandSums<OpaqueColour>::kRows * kRasterSubpixels;

}  // namespace

struct CpuRaster::Job {
  const PlanarMap& map;
  ToOutput x, y;
  glm::dvec2 scale;
  PictureView target;

  glm::ivec2 operator()(glm::ivec2 p) const { return {x(p.x), y(p.y)}; }
  int east() const { return x(map.lattice.width() * kSubpixels); }
  int south() const { return y(map.lattice.height() * kSubpixels); }
  bool covers_target() const {
    return x(0) <= 0 && y(0) <= 0 && east() >= target.width * kRasterSubpixels &&
           south() >= target.height * kRasterSubpixels;
  }
};

/// Counting sort of the segments by the bands they touch. Level segments are left out: they change no sum.
void CpuRaster::sort_into_bands(const Job& job, int bands) {
  const std::vector<Segment>& segments = job.map.segments;
  ranges_.resize(segments.size());
  first_.assign(bands + 1, 0);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    const int low = job.y(std::min(std::min(s.p0.y, s.p1.y), std::min(s.p2.y, s.p3.y)));
    const int high = job.y(std::max(std::max(s.p0.y, s.p1.y), std::max(s.p2.y, s.p3.y)));
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

template <typename Model>
void CpuRaster::draw_band(const Job& job, int band, BandSums<Model>& sums) const {
  const PlanarMap& map = job.map;
  const Lattice& lattice = map.lattice;
  const int first_row = band * BandSums<Model>::kRows;
  const int rows = std::min(BandSums<Model>::kRows, job.target.height - first_row);
  sums.start(first_row, rows);
  for (int i = first_[band]; i < first_[band + 1]; ++i) {
    const Segment& s = map.segments[order_[i]];
    const auto change = Model::change(map.right_colour(s), map.left_colour(s));
    flatten(job(s.p0), job(s.p1), job(s.p2), job(s.p3), flattening_pieces(s.p0, s.p1, s.p2, s.p3, job.scale),
            [&](glm::ivec2 a, glm::ivec2 b) { sums.add_line(a.x, a.y, b.x, b.y, change); });
  }
  // The border: on the left, the picture begins; on the right, it ends.
  const int west = job.x(0), east = job.east();
  const int top = first_row * kRasterSubpixels, bottom = top + rows * kRasterSubpixels;
  for (int y = 0; y < lattice.height(); ++y) {
    const int y0 = job.y(y * kSubpixels), y1 = job.y((y + 1) * kSubpixels);
    if (y1 <= top || y0 >= bottom) continue;
    sums.add_line(west, y0, west, y1, Model::change(Rgba{}, map.colours[lattice.pixel(0, y)]));
    sums.add_line(east, y0, east, y1,
                  Model::change(map.colours[lattice.pixel(lattice.width() - 1, y)], Rgba{}));
  }
  for (int row = 0; row < rows; ++row) {
    sums.resolve(row, job.target.pixels + (first_row + row) * job.target.pitch);
  }
}

template <typename Model>
void CpuRaster::draw_bands(const Job& job, int bands, int threads) {
  auto& sums = std::get<std::vector<BandSums<Model>>>(sums_);
  threads = std::clamp(threads, 1, bands);
  if (static_cast<int>(sums.size()) < threads) sums.resize(threads);
  std::atomic<int> next{0};
  const auto work = [&](BandSums<Model>& own) {
    own.resize(job.target.width);
    for (int band = next++; band < bands; band = next++) draw_band(job, band, own);
  };
  std::vector<std::jthread> helpers;
  for (int i = 1; i < threads; ++i) helpers.emplace_back(work, std::ref(sums[i]));
  work(sums[0]);
}

void CpuRaster::draw(const PlanarMap& map, const View& view, bool linear_light, int threads,
                     const PictureView& target) {
  if (target.width <= 0 || target.height <= 0) return;
  const Job job{map,
                ToOutput(view.scale_x, view.origin_x),
                ToOutput(view.scale_y, view.origin_y),
                {view.scale_x, view.scale_y},
                target};
  const int bands = (target.height + BandSums<OpaqueColour>::kRows - 1) / BandSums<OpaqueColour>::kRows;
  sort_into_bands(job, bands);
  if (job.covers_target() && is_opaque(map)) {
    linear_light ? draw_bands<OpaqueLight>(job, bands, threads)
                 : draw_bands<OpaqueColour>(job, bands, threads);
  } else {
    linear_light ? draw_bands<Translucent<true>>(job, bands, threads)
                 : draw_bands<Translucent<false>>(job, bands, threads);
  }
}

}  // namespace depixel
