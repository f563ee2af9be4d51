#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "libdepixel/core/workers.hpp"
#include "libdepixel/incremental/incremental_vectorizer.hpp"
#include "libdepixel/raster/colour_model.hpp"
#include "libdepixel/raster/curve_cells.hpp"

namespace depixel {

/// Draws some tiles of a picture, at even whole scales from 4 to 16: the same pixels as CpuRaster's, bit for
/// bit.
///
/// Tiles of a row that follow each other are drawn together. The tile on their west is known to have its own
/// colour at its centre, so nothing that lies west of there need be looked at.
class TilePainter {
 public:
  /// True for grids that this is for: with the frame inside the target.
  static bool fits(const OutputGrid& grid);

  /// \param colours   the source's, in the target's order of channels.
  /// \param is_stale  padded, by tile: 1 for those to draw, else 0.
  /// \return the output pixels that were drawn.
  template <typename Model>
  std::int64_t draw(const IncrementalVectorizer& source, const std::vector<Rgba>& colours,
                    const OutputGrid& grid, const std::vector<std::uint8_t>& is_stale, Workers& workers);

  std::size_t memory_bytes() const;

 private:
  /// Tiles from .. to - 1 of a row.
  struct Run {
    int row, from, to;
  };
  /// Buffers of a thread.
  struct Scratch {
    CurveCells cells;
    /// Sums of a row of tiles, one an output pixel, and one more a row for what the last leaves to the next.
    std::tuple<std::vector<Sums32>, std::vector<Sums64>> sums;
    std::int64_t drawn_pixels = 0;
  };

  template <typename Model>
  static void draw_run(const IncrementalVectorizer& source, const std::vector<Rgba>& colours,
                       const OutputGrid& grid, const Run& run, Scratch& scratch);
  template <typename Model>
  static void add_curves(const IncrementalVectorizer& source, const std::vector<Rgba>& colours,
                         const OutputGrid& grid, const Run& run, Scratch& scratch,
                         typename Model::Sums* sums);
  template <typename Model>
  static void resolve(const OutputGrid& grid, const Run& run, Rgba colour, typename Model::Sums* sums);

  std::vector<Scratch> scratch_;  ///< one a thread
};

}  // namespace depixel
