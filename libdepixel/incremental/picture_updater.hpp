#pragma once

#include <cstdint>
#include <vector>

#include "libdepixel/core/workers.hpp"
#include "libdepixel/incremental/incremental_vectorizer.hpp"
#include "libdepixel/incremental/tile_mover.hpp"
#include "libdepixel/incremental/tile_painter.hpp"
#include "libdepixel/raster/cpu_raster.hpp"
#include "libdepixel/raster/flattened_curves.hpp"
#include "libdepixel/raster/ordered_colours.hpp"

namespace depixel {

/// Keeps a picture of what an IncrementalVectorizer made of frame after frame: the same pixels as
/// CpuRaster's, bit for bit, but only those are written whose tiles changed.
///
/// What moved is copied. The rest is drawn by TilePainter, at even whole scales from 4 to 16; at others, in
/// windows of some rows of tiles. Beside a window lies a *clear* tile, whose four corners no visible edge
/// touches: no curve lies in it, so the sum of all that lies left of it is that tile's own colour, and
/// nothing on its other side need be looked at.
class PictureUpdater {
 public:
  /// Draws a view over the whole target.
  /// \param changes  all since the last call. Where anything else than the map differs from what it was then,
  ///                 the target's memory, the view or the way to blend, everything is drawn.
  /// \param is_kept  the target holds what the last call drew.
  void draw(const IncrementalVectorizer& source, const MapChanges& changes, const View& view,
            bool linear_light, int threads, const PictureView& target, bool is_kept);

  /// Of the last call: output pixels that were drawn, and that were copied from elsewhere in the picture.
  std::int64_t drawn_pixels() const { return drawn_pixels_; }
  std::int64_t moved_pixels() const { return moved_pixels_; }
  std::size_t memory_bytes() const;

 private:
  /// What the last picture was drawn as.
  struct Drawn {
    PictureView target;
    View view;
    Lattice lattice;
    bool linear_light = false, opaque = false;

    friend bool operator==(const Drawn&, const Drawn&) = default;
  };
  /// Tiles that are drawn together, in some rows.
  struct Window {
    int clear;     ///< column of the nearest clear tile, on either side; -1 or the frame's width: its border
    int from, to;  ///< columns of tiles, from .. to - 1
  };
  /// Some rows of output pixels, and the rows of tiles that they lie over, first .. end - 1.
  struct Strip {
    int first_px, end_px;
    int first, end;
  };
  /// Buffers of a thread.
  struct Scratch {
    std::vector<std::uint8_t> stale, occupied;  ///< by column of tiles, and of corners
    std::vector<Window> windows;
    FlattenedCurves flattened;
    std::int64_t drawn_pixels = 0;
  };

  template <typename Model>
  void draw_stale(const IncrementalVectorizer& source, const std::vector<Rgba>& colours,
                  const OutputGrid& grid);
  void leave_shaded(const IncrementalVectorizer& source);
  void update(const IncrementalVectorizer& source, const MapChanges& changes, const OutputGrid& grid,
              const Drawn& now, int threads);
  void find_strips(const OutputGrid& grid);
  void find_windows(const IncrementalVectorizer& source, const OutputGrid& grid, const Strip& strip,
                    Scratch& scratch) const;
  template <typename Model>
  void draw_strips(const IncrementalVectorizer& source, const std::vector<Rgba>& colours,
                   const OutputGrid& grid);
  template <typename Sums>
  void draw_windows(const IncrementalVectorizer& source, const std::vector<Rgba>& colours,
                    const OutputGrid& grid, const Strip& strip, Sums& sums, Scratch& scratch) const;
  template <typename Sums>
  void draw_window(const IncrementalVectorizer& source, const std::vector<Rgba>& colours,
                   const OutputGrid& grid, const Strip& strip, const Window& window, Sums& sums,
                   Scratch& scratch) const;

  Workers workers_;
  CpuRaster raster_;
  TileMover mover_;
  TilePainter painter_;
  Drawn drawn_;
  std::vector<std::uint8_t> is_stale_;       ///< padded, by tile
  std::vector<std::uint8_t> is_even_stale_;  ///< padded: those of them that are not shaded
  std::vector<Strip> strips_;                ///< those with stale tiles
  std::vector<Scratch> scratch_;             ///< one a thread
  SumsOfModels sums_;
  OrderedColours colours_, shades_;
  ShadeField field_;
  std::int64_t drawn_pixels_ = 0, moved_pixels_ = 0;
  bool is_updating_ = false;
};

}  // namespace depixel
