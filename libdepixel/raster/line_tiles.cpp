#include "libdepixel/raster/line_tiles.hpp"

#include <algorithm>
#include <bit>

#include "libdepixel/core/memory.hpp"
#include "libdepixel/raster/flatten.hpp"
#include "libdepixel/raster/light.hpp"

namespace depixel {
namespace {

constexpr int kShift = std::countr_zero(static_cast<unsigned>(kTileUnits));
constexpr int kUnitsToSubpixel = kTileUnits / kSubpixels;

TileColour encode(Rgba c, bool linear_light) {
  const auto channel = [&](std::uint8_t level) {
    const int full =
        linear_light ? kTileLightLevels / kLightLevels * to_light(level) : kTileLevels / 255 * level;
    return static_cast<std::int16_t>(c.a == 255 ? full : (full * c.a + 127) / 255);
  };
  const int alpha = ((linear_light ? kTileLightLevels : kTileLevels) * c.a + 127) / 255;
  return {channel(c.r), channel(c.g), channel(c.b), static_cast<std::int16_t>(alpha)};
}

TileColour difference(const TileColour& a, const TileColour& b) {
  TileColour result;
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = static_cast<std::int16_t>(a[i] - b[i]);
  return result;
}

/// Where the line from a to b meets a level between theirs; the same whichever way round it is given.
int meet(int a_across, int a_along, int b_across, int b_along, int level) {
  if (a_along > b_along) {
    std::swap(a_across, b_across);
    std::swap(a_along, b_along);
  }
  const std::int64_t way = std::int64_t{b_across - a_across} * (level - a_along);
  return a_across + static_cast<int>(way / (b_along - a_along));
}

}  // namespace

/// Cuts lines at the sides of tiles and files the pieces.
class LineTiles::Cutter {
 public:
  Cutter(LineTiles& tiles, std::vector<Found>& found) : tiles_(tiles), found_(found) {}

  void set_change(const TileColour& change) { change_ = change; }

  /// Cuts at the rows of tiles. A level line on a side belongs to either row: it changes neither.
  void add(glm::ivec2 a, glm::ivec2 b) {
    const int low = std::min(a.y, b.y), high = std::max(a.y, b.y);
    int row = std::min(low >> kShift, tiles_.height_ - 1);
    const int last = std::max(row, (high - 1) >> kShift);
    if (row == last) {
      add_in_row(a, b, row);
      return;
    }
    const bool is_upwards = a.y > b.y;
    glm::ivec2 top = is_upwards ? b : a;
    const glm::ivec2 end = is_upwards ? a : b;
    for (; row <= last; ++row) {
      const int side = (row + 1) << kShift;
      const glm::ivec2 bottom = row == last ? end : glm::ivec2(meet(a.x, a.y, b.x, b.y, side), side);
      is_upwards ? add_in_row(bottom, top, row) : add_in_row(top, bottom, row);
      top = bottom;
    }
  }

 private:
  /// Cuts at the columns of tiles. An upright line on a side belongs to the tile on its west.
  void add_in_row(glm::ivec2 a, glm::ivec2 b, int row) {
    const int low = std::min(a.x, b.x), high = std::max(a.x, b.x);
    const int last = (high - 1) >> kShift;  // -1 for a line on the picture's western border
    int column = std::min(low >> kShift, last);
    if (column == last) {
      file(a, b, column, row);
      return;
    }
    const bool is_westwards = a.x > b.x;
    glm::ivec2 west = is_westwards ? b : a;
    const glm::ivec2 end = is_westwards ? a : b;
    for (; column <= last; ++column) {
      const int side = (column + 1) << kShift;
      const glm::ivec2 east = column == last ? end : glm::ivec2(side, meet(a.y, a.x, b.y, b.x, side));
      is_westwards ? file(east, west, column, row) : file(west, east, column, row);
      west = east;
    }
  }

  void file(glm::ivec2 a, glm::ivec2 b, int column, int row) {
    const glm::ivec2 corner(column << kShift, row << kShift);
    a -= corner;
    b -= corner;
    // A line that comes from the tile's top changes the colour at the top left of all tiles to the east. It
    // is added to the next one here, and summed up at the end.
    if (a.y != b.y && (a.y == 0 || b.y == 0) && column + 1 < tiles_.width_) {
      TileColour& colour = tiles_.tiles_[std::size_t(row) * tiles_.width_ + column + 1].colour;
      for (std::size_t i = 0; i < colour.size(); ++i) {
        colour[i] = static_cast<std::int16_t>(a.y == 0 ? colour[i] + change_[i] : colour[i] - change_[i]);
      }
    }
    if (a.x == kTileUnits && b.x == kTileUnits) return;
    // What meets the left side in the top left corner itself is part of the colour there already.
    if (a.x == 0 && a.y == 0) a.x = 1;
    if (b.x == 0 && b.y == 0) b.x = 1;
    if (a.y == b.y && a.x != 0 && b.x != 0) return;
    const auto narrow = [](int v) { return static_cast<std::uint16_t>(v); };
    const int tile = row * tiles_.width_ + column;
    ++tiles_.tiles_[tile].count;
    found_.push_back({tile, {narrow(a.x), narrow(a.y), narrow(b.x), narrow(b.y), change_}});
  }

  LineTiles& tiles_;
  std::vector<Found>& found_;
  TileColour change_{};
};

void LineTiles::build(const PlanarMap& map, glm::dvec2 scale, bool linear_light) {
  const Lattice& lattice = map.lattice;
  width_ = lattice.width();
  height_ = lattice.height();
  tiles_.assign(std::size_t(width_) * height_, Tile{});
  found_.clear();
  Cutter cutter(*this, found_);
  for (const Segment& s : map.segments) {
    cutter.set_change(
        difference(encode(map.left_colour(s), linear_light), encode(map.right_colour(s), linear_light)));
    const int pieces = flattening_pieces(s.p0, s.p1, s.p2, s.p3, scale);
    flatten(s.p0 * kUnitsToSubpixel, s.p1 * kUnitsToSubpixel, s.p2 * kUnitsToSubpixel,
            s.p3 * kUnitsToSubpixel, pieces, [&](glm::ivec2 a, glm::ivec2 b) { cutter.add(a, b); });
  }
  std::uint32_t first = 0;
  for (int y = 0; y < height_; ++y) {
    TileColour colour = encode(map.colours[lattice.pixel(0, y)], linear_light);
    for (int x = 0; x < width_; ++x) {
      Tile& tile = tiles_[std::size_t(y) * width_ + x];
      for (std::size_t i = 0; i < colour.size(); ++i) {
        colour[i] = static_cast<std::int16_t>(colour[i] + tile.colour[i]);
      }
      tile.colour = colour;
      tile.first = first;
      first += tile.count;
    }
  }
  lines_.resize(found_.size());
  for (const Found& found : found_) lines_[tiles_[found.tile].first++] = found.line;
  for (Tile& tile : tiles_) tile.first -= tile.count;
}

std::size_t LineTiles::memory_bytes() const {
  return held_bytes(tiles_, lines_, found_);
}

}  // namespace depixel
