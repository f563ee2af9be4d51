#pragma once

#include <cstdint>
#include <vector>

#include "libdepixel/incremental/map_changes.hpp"
#include "libdepixel/raster/output_grid.hpp"

namespace depixel {

/// Moves what was drawn of tiles that moved, within a picture.
class TileMover {
 public:
  /// \param grid      how the picture was drawn, and is to be.
  /// \param is_stale  padded, by tile: set to 1 for the tiles that must be drawn, and to 0 for those that
  /// show
  ///                  what they are to show: those that did not change, and those that were moved.
  /// Where there are no whole output pixels to a source pixel, and near the sides of a view that cuts the
  /// frame, nothing can be moved. \return the output pixels that were moved.
  std::int64_t move(const OutputGrid& grid, const MapChanges& changes, std::vector<std::uint8_t>& is_stale);

  std::size_t memory_bytes() const;

 private:
  /// Neighbouring tiles of a row that move together, from .. to - 1.
  struct Run {
    int row, from, to;
  };

  void find_runs(const OutputGrid& grid, const MapChanges& changes, std::vector<std::uint8_t>& is_stale);

  std::vector<std::vector<Run>> runs_;  ///< by move, from left to right and down
  std::vector<std::uint8_t> held_;      ///< output pixels on their way
};

}  // namespace depixel
