#include "libdepixel/incremental/tile_painter.hpp"

#include <algorithm>
#include <cstring>

namespace depixel {
namespace {

/// Runs with fewer tiles than this between them are drawn as one.
constexpr int kLeastRunGap = 2;

int sums_pitch(const OutputGrid& grid) {
  return grid.lattice.width() * grid.x.whole_scale() + 1;
}

}  // namespace

bool TilePainter::fits(const OutputGrid& grid) {
  const Lattice& lattice = grid.lattice;
  return CurveCells::sees_from_centres(grid) && grid.column(0) >= 0 && grid.row(0) >= 0 &&
         grid.column(lattice.width()) <= grid.target.width * kRasterSubpixels &&
         grid.row(lattice.height()) <= grid.target.height * kRasterSubpixels;
}

/// Adds what the curves that touch a run's tiles, or the one on its west, change in the run.
template <typename Model>
void TilePainter::add_curves(const IncrementalVectorizer& source, const std::vector<Rgba>& colours,
                             const OutputGrid& grid, const Run& run, Scratch& scratch,
                             typename Model::Sums* sums) {
  const Lattice& lattice = grid.lattice;
  const SplineTable& table = source.table();
  const std::ptrdiff_t scale_x = grid.x.whole_scale(), scale_y = grid.y.whole_scale();
  const int beside = run.from - 1;  // the tile whose centre is seen from, unless it lies outside the frame
  const int west = std::max(beside, 0), first = std::max(west - 1, 0);
  for (int y = std::max(run.row - 1, 0); y <= run.row + 1; ++y) {
    const int row = run.row - y, row_bits = 3 * (row + 1);
    typename Model::Sums* row_sums = sums - row * scale_y * sums_pitch(grid);
    const int* curve = source.edges().curve.data() + edge_slot(lattice.corner(first, y), false);
    for (int x = first; x <= run.to; ++x, curve += 2) {
      if ((curve[0] | curve[1]) == 0) continue;
      // Of the row's three tiles round the owner: those that matter, and the one beside.
      const int wanted = (7 << std::max(west - (x - 1), 0)) & ((1 << std::min(run.to - (x - 1), 3)) - 1);
      const int seen = beside - (x - 1);
      const int seen_bit = beside >= 0 && seen >= 0 ? 1 << seen : 0;
      for (const int southwards : {0, 1}) {
        const int number = curve[southwards];
        if (number == 0) continue;
        const int touched = table.tiles(number) >> row_bits;
        if ((touched & wanted) == 0) continue;
        const std::span<const CurveCells::Cell> cells =
            (touched & seen_bit) != 0 ? scratch.cells.seen_from(number, table.curve(number), row_bits + seen)
                                      : scratch.cells.in_row(number, table.curve(number), row);
        if (cells.empty()) continue;
        const EdgeSides sides = sides_of(lattice.corner(x, y), southwards != 0, lattice.stride());
        const auto change = Model::change(colours[sides.right], colours[sides.left]);
        for (const CurveCells::Cell& cell : cells) {
          row_sums[x * scale_x + cell.place] += Model::times(change, cell.factor);
        }
      }
    }
  }
}

/// Turns sums into pixels, and clears them.
/// \param colour  that of the tile on the run's west.
template <typename Model>
void TilePainter::resolve(const OutputGrid& grid, const Run& run, Rgba colour, typename Model::Sums* sums) {
  using Sums = typename Model::Sums;
  const int scale_x = grid.x.whole_scale(), scale_y = grid.y.whole_scale(), pitch = sums_pitch(grid);
  const int start = run.from == 0 ? 0 : run.from * scale_x - scale_x / 2;
  const int from = run.from * scale_x, to = run.to * scale_x, end = std::min(to + 2 * scale_x + 1, pitch);
  const Sums before = Model::times(Model::change(Rgba{}, colour), kFullCoverage);
  std::uint8_t* out = grid.target.pixels +
                      (grid.row(run.row) / kRasterSubpixels) * std::ptrdiff_t{grid.target.pitch} +
                      grid.column(0) / kRasterSubpixels * std::ptrdiff_t{sizeof(Rgba)};
  for (int y = 0; y < scale_y; ++y, out += grid.target.pitch, sums += pitch) {
    Sums running = before;
    for (int x = start; x < from; ++x) running += sums[x];
    int x = from;
    for (; x + kWordLanes <= to; x += kWordLanes) {
      const Sums a = running + sums[x], b = a + sums[x + 1], c = b + sums[x + 2], d = c + sums[x + 3];
      store_vector(out + std::size_t(x) * sizeof(Rgba), decode_four<Model>(a, b, c, d));
      running = d;
    }
    for (; x < to; ++x) {
      running += sums[x];
      const Rgba pixel = Model::decode(running);
      std::memcpy(out + std::size_t(x) * sizeof pixel, &pixel, sizeof pixel);
    }
    std::fill(sums + start, sums + end, Sums{});
  }
}

template <typename Model>
void TilePainter::draw_run(const IncrementalVectorizer& source, const std::vector<Rgba>& colours,
                           const OutputGrid& grid, const Run& run, Scratch& scratch) {
  auto* sums = std::get<std::vector<typename Model::Sums>>(scratch.sums).data();
  const int west = grid.lattice.pixel(std::max(run.from - 1, 0), run.row);
  add_curves<Model>(source, colours, grid, run, scratch, sums);
  resolve<Model>(grid, run, colours[west], sums);
  scratch.drawn_pixels += std::int64_t{run.to - run.from} * grid.x.whole_scale() * grid.y.whole_scale();
}

template <typename Model>
std::int64_t TilePainter::draw(const IncrementalVectorizer& source, const std::vector<Rgba>& colours,
                               const OutputGrid& grid, const std::vector<std::uint8_t>& is_stale,
                               Workers& workers) {
  const Lattice& lattice = grid.lattice;
  const int width = lattice.width(), pitch = sums_pitch(grid);
  const auto threads = static_cast<std::size_t>(workers.threads());
  if (scratch_.size() < threads) scratch_.resize(threads);
  for (Scratch& own : scratch_) {
    own.drawn_pixels = 0;
    own.cells.start(grid, pitch, source.table().generation(), source.table().size() + 1);
    auto& sums = std::get<std::vector<typename Model::Sums>>(own.sums);
    const std::size_t size = std::size_t(pitch) * grid.y.whole_scale();
    if (sums.size() < size) sums.resize(size);
  }
  workers.run(lattice.height(), [&](int row, int thread) {
    const std::uint8_t* stale = is_stale.data() + lattice.pixel(0, row);
    for (int x = 0; x < width;) {
      const auto* next = static_cast<const std::uint8_t*>(std::memchr(stale + x, 1, width - x));
      if (next == nullptr) break;
      const int from = static_cast<int>(next - stale);
      Run run{row, from, from + 1};
      for (x = run.to; x < width && x - run.to < kLeastRunGap; ++x) {
        if (stale[x] != 0) run.to = x + 1;
      }
      draw_run<Model>(source, colours, grid, run, scratch_[thread]);
    }
  });
  std::int64_t drawn = 0;
  for (const Scratch& own : scratch_) drawn += own.drawn_pixels;
  return drawn;
}

std::size_t TilePainter::memory_bytes() const {
  std::size_t bytes = held_bytes(scratch_);
  for (const Scratch& own : scratch_) {
    bytes += own.cells.memory_bytes() + held_bytes(std::get<0>(own.sums), std::get<1>(own.sums));
  }
  return bytes;
}

template std::int64_t TilePainter::draw<OpaqueColour>(const IncrementalVectorizer&, const std::vector<Rgba>&,
                                                      const OutputGrid&, const std::vector<std::uint8_t>&,
                                                      Workers&);
template std::int64_t TilePainter::draw<OpaqueLight>(const IncrementalVectorizer&, const std::vector<Rgba>&,
                                                     const OutputGrid&, const std::vector<std::uint8_t>&,
                                                     Workers&);
template std::int64_t TilePainter::draw<Translucent<false>>(const IncrementalVectorizer&,
                                                            const std::vector<Rgba>&, const OutputGrid&,
                                                            const std::vector<std::uint8_t>&, Workers&);
template std::int64_t TilePainter::draw<Translucent<true>>(const IncrementalVectorizer&,
                                                           const std::vector<Rgba>&, const OutputGrid&,
                                                           const std::vector<std::uint8_t>&, Workers&);

}  // namespace depixel
