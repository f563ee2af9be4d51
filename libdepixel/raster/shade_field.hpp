#pragma once

#include <vector>

#include "libdepixel/raster/output_grid.hpp"
#include "libdepixel/stages/shading.hpp"

namespace depixel {

/// The colours of shaded regions at the centres of output pixels; see Shading. Integers, so the same bits
/// whatever the order of work. Keeps its buffers.
class ShadeField {
 public:
  /// \param colours, shades  of the map and its shading, in the target's order of channels; all are read
  /// until the next
  ///                         call.
  void start(const Shading& shading, const std::vector<Rgba>& colours, const std::vector<Rgba>& shades,
             const OutputGrid& grid);

  /// Whether anything may be shaded in some output rows.
  bool is_shaded(int first_row, int end_row) const;

  /// \param region  the region's colour on the map.
  Rgba at(int column, int row, Rgba region) const;

  /// Writes a region's colours to a part of a row: columns from .. to - 1.
  /// \param out  the row's column 0.
  void fill(int row, int from, int to, Rgba region, std::uint8_t* out) const;

  std::size_t memory_bytes() const { return held_bytes(columns_, rows_, is_row_shaded_); }

 private:
  /// Between which pixels an output pixel's centre lies, along an axis: those before and after a lattice
  /// line.
  struct Place {
    int line;    ///< 0 to the frame's width or height
    int weight;  ///< of the pixel after it, of kWeights; neither weighs nothing
  };
  /// What a region has between the centres of a block's pixels.
  struct Mixture;
  class MixtureRow;

  static void place(const ToOutput& axis, int pixels, int size, std::vector<Place>& places);
  Mixture mixture(int block, Rgba region) const;

  const Shading* shading_ = nullptr;
  const std::vector<Rgba>*colours_ = nullptr, *shades_ = nullptr;
  Lattice lattice_;
  std::vector<Place> columns_, rows_;        ///< by output pixel
  std::vector<std::uint8_t> is_row_shaded_;  ///< by row of blocks
};

}  // namespace depixel
