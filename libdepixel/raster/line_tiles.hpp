#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "libdepixel/stages/planar_map.hpp"

namespace depixel {

/// Positions in a tile are in this many units to a source pixel.
constexpr int kTileUnits = 1 << 15;

/// A colour as four channels that can be added up: premultiplied, in steps of 1/kTileLevels of full strength.
using TileColour = std::array<std::int16_t, 4>;

/// Full strength: of colours as they are, 128 times 255; in linear light, 4 times kLightLevels.
constexpr int kTileLevels = 32640, kTileLightLevels = 32764;

/// A line inside a tile. Coordinates are 0..kTileUnits from the tile's top left.
struct TileLine {
  std::uint16_t x0, y0, x1, y1;
  TileColour change;  ///< from the colour on its right to the colour on its left, seen along the line
};

/// What of a map lies in one source pixel's square: the colour at its top left, and lines that change it.
///
/// The colour at a place is that at the top left, less the change of every line that starts on the left side
/// above, plus that of every line that ends there; then plus or minus the change of every line on the way
/// from the left side to the place, as it is crossed going down or up.
struct Tile {
  TileColour colour;
  std::uint32_t first, count;  ///< lines
};
static_assert(sizeof(TileLine) == 16 && sizeof(Tile) == 16);

/// A planar map cut to the square tiles of the source's pixels, for rasterising each by itself.
///
/// Lines that run along a tile's side, or level without touching its left side, change nothing inside and are
/// left out. Depends on the scale of the output only as far as curves are flattened for it.
class LineTiles {
 public:
  /// \param scale  output pixels to a source pixel, by axis.
  /// Cost: linear in pixels and segments.
  void build(const PlanarMap& map, glm::dvec2 scale, bool linear_light);

  int width() const { return width_; }
  int height() const { return height_; }
  const std::vector<Tile>& tiles() const { return tiles_; }      ///< row by row
  const std::vector<TileLine>& lines() const { return lines_; }  ///< tile by tile

  std::size_t memory_bytes() const;

 private:
  struct Found {
    int tile;
    TileLine line;
  };
  class Cutter;

  int width_ = 0, height_ = 0;
  std::vector<Tile> tiles_;
  std::vector<TileLine> lines_;
  std::vector<Found> found_;
};

}  // namespace depixel
