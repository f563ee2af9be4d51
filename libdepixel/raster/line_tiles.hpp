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

/// What tiles know of colours: the colours, as they are or in linear light; or, for shaded maps, which region
/// it is, by its colour on the map. A region is two channels, its colour's four bytes; a line then has the
/// region on its left and the one on its right.
enum class TileEncoding { levels, light, regions };

/// A line inside a tile. Coordinates are 0..kTileUnits from the tile's top left.
struct TileLine {
  std::uint16_t x0, y0, x1, y1;
  TileColour change;  ///< from the colour on its right to the colour on its left, seen along the line; or
                      ///< both regions

  friend bool operator==(const TileLine&, const TileLine&) = default;
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
  /// Cuts a map.
  /// \param scale  output pixels to a source pixel, by axis.
  /// Cost: linear in pixels and segments.
  void build(const PlanarMap& map, glm::dvec2 scale, TileEncoding encoding);

  /// What is in a tile after update(): what was in it; what is cut for it; or, from kMoved on, what was in
  /// the tile that lies by -moves[fate - kMoved] from it.
  static constexpr std::uint8_t kKept = 0, kCut = 1, kMoved = 2;

  /// Makes the tiles those of another map of the same size: they hold what build() would give them, to the
  /// bit, if what is kept and moved is the same in both maps. New lines come after all that were there; lines
  /// may be shared by tiles, and those of tiles that went stay, and are nobody's.
  /// \param colours  as of a PlanarMap.
  /// \param fates    padded, by pixel; what it holds for the padding is ignored.
  /// Cost: an operation a tile; where some are cut, a few a corner of such rows and the cutting of segments.
  void update(const EdgeMap& edges, const SplineTable& table, const std::vector<Rgba>& colours,
              const std::vector<std::uint8_t>& fates, const std::vector<glm::ivec2>& moves);
  /// Makes the lines lie as after build().
  void compact();

  int width() const { return width_; }
  int height() const { return height_; }
  const std::vector<Tile>& tiles() const { return tiles_; }      ///< row by row
  const std::vector<TileLine>& lines() const { return lines_; }  ///< after build(), tile by tile
  std::size_t used_lines() const { return used_lines_; }         ///< of all tiles

  /// Whether two hold the same tiles; where in lines() their lines lie does not matter.
  friend bool operator==(const LineTiles& a, const LineTiles& b);

  std::size_t memory_bytes() const;

 private:
  struct Found {
    int tile;
    TileLine line;
  };
  class Cutter;

  void start_update(const Lattice& lattice, const std::vector<std::uint8_t>& fates,
                    const std::vector<glm::ivec2>& moves);
  void cut_near(int row, const EdgeMap& edges, const SplineTable& table, const std::vector<Rgba>& colours,
                Cutter& cutter) const;
  void settle(const Lattice& lattice, const std::vector<Rgba>& colours, std::size_t first_line);

  int width_ = 0, height_ = 0;
  glm::dvec2 scale_{0};
  TileEncoding encoding_ = TileEncoding::levels;
  std::vector<Tile> tiles_, tiles_before_;
  std::vector<TileLine> lines_, spare_;
  std::size_t used_lines_ = 0;
  std::vector<Found> found_;
  std::vector<std::uint8_t> is_stale_;  ///< by tile: 1 where it is being cut
  std::vector<std::uint8_t> is_near_;   ///< padded: 1 where lines in a tile matter to stale ones
};

}  // namespace depixel
