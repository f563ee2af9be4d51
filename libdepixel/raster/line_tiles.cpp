#include "libdepixel/raster/line_tiles.hpp"

#include <algorithm>
#include <bit>

#include "libdepixel/core/light.hpp"
#include "libdepixel/core/memory.hpp"
#include "libdepixel/raster/flatten.hpp"

namespace depixel {
namespace {

constexpr int kShift = std::countr_zero(static_cast<unsigned>(kTileUnits));
constexpr int kUnitsToSubpixel = kTileUnits / kSubpixels;

TileColour encode(Rgba c, TileEncoding encoding) {
  if (encoding == TileEncoding::regions) {
    const auto halves = std::bit_cast<std::array<std::int16_t, 2>>(c);
    return {halves[0], halves[1], 0, 0};
  }
  const bool linear_light = encoding == TileEncoding::light;
  const auto channel = [&](std::uint8_t level) {
    const int full =
        linear_light ? kTileLightLevels / kLightLevels * to_light(level) : kTileLevels / 255 * level;
    return static_cast<std::int16_t>(c.a == 255 ? full : (full * c.a + 127) / 255);
  };
  const int alpha = ((linear_light ? kTileLightLevels : kTileLevels) * c.a + 127) / 255;
  return {channel(c.r), channel(c.g), channel(c.b), static_cast<std::int16_t>(alpha)};
}

TileColour sum(const TileColour& a, const TileColour& b) {
  TileColour result;
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = static_cast<std::int16_t>(a[i] + b[i]);
  return result;
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

/// Cuts lines at the sides of tiles and files the pieces of those that are stale.
class LineTiles::Cutter {
 public:
  explicit Cutter(LineTiles& tiles) : tiles_(tiles) {}

  void cut(const Segment& s, Rgba left, Rgba right) {
    const TileColour to = encode(left, tiles_.encoding_), from = encode(right, tiles_.encoding_);
    change_ = difference(to, from);
    told_ = tiles_.encoding_ == TileEncoding::regions ? TileColour{to[0], to[1], from[0], from[1]} : change_;
    const int pieces = flattening_pieces(s.p0, s.p1, s.p2, s.p3, tiles_.scale_);
    flatten(s.p0 * kUnitsToSubpixel, s.p1 * kUnitsToSubpixel, s.p2 * kUnitsToSubpixel,
            s.p3 * kUnitsToSubpixel, pieces, [&](glm::ivec2 a, glm::ivec2 b) { add(a, b); });
  }

 private:
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
    const int tile = row * tiles_.width_ + column;
    // A line that comes from the tile's top changes the colour at the top left of all tiles to the east. It
    // is added to the next one here, and summed up at the end.
    if (a.y != b.y && (a.y == 0 || b.y == 0) && column + 1 < tiles_.width_ && tiles_.is_stale_[tile + 1]) {
      TileColour& colour = tiles_.tiles_[tile + 1].colour;
      colour = a.y == 0 ? sum(colour, change_) : difference(colour, change_);
    }
    if ((a.x == kTileUnits && b.x == kTileUnits) || tiles_.is_stale_[tile] == 0) return;
    // What meets the left side in the top left corner itself is part of the colour there already.
    if (a.x == 0 && a.y == 0) a.x = 1;
    if (b.x == 0 && b.y == 0) b.x = 1;
    if (a.y == b.y && a.x != 0 && b.x != 0) return;
    const auto narrow = [](int v) { return static_cast<std::uint16_t>(v); };
    ++tiles_.tiles_[tile].count;
    tiles_.found_.push_back({tile, {narrow(a.x), narrow(a.y), narrow(b.x), narrow(b.y), told_}});
  }

  LineTiles& tiles_;
  TileColour change_{}, told_{};  ///< the second is what lines are told
};

void LineTiles::build(const PlanarMap& map, glm::dvec2 scale, TileEncoding encoding) {
  const Lattice& lattice = map.lattice;
  width_ = lattice.width();
  height_ = lattice.height();
  scale_ = scale;
  encoding_ = encoding;
  tiles_.assign(std::size_t(width_) * height_, Tile{});
  is_stale_.assign(tiles_.size(), 1);
  found_.clear();
  used_lines_ = 0;
  Cutter cutter(*this);
  for (const Segment& s : map.segments) cutter.cut(s, map.left_colour(s), map.right_colour(s));
  settle(lattice, map.colours, 0);
}

/// Moves tiles, and empties those that are to be cut.
void LineTiles::start_update(const Lattice& lattice, const std::vector<std::uint8_t>& fates,
                             const std::vector<glm::ivec2>& moves) {
  is_near_.assign(lattice.size(), 0);
  std::fill(is_stale_.begin(), is_stale_.end(), std::uint8_t{0});
  if (!moves.empty()) tiles_before_ = tiles_;
  for (int y = 0; y < height_; ++y) {
    const int first = lattice.pixel(0, y);
    if (are_zero(fates.data() + first, width_)) continue;
    for (int x = 0; x < width_; ++x) {
      const std::uint8_t fate = fates[first + x];
      if (fate == kKept) continue;
      const int i = y * width_ + x;
      used_lines_ -= tiles_[i].count;
      if (fate == kCut) {
        tiles_[i] = {};
        is_stale_[i] = 1;
        // Lines from the top of the tile on the west change the colour at the top left of this one.
        is_near_[first + x - 1] = is_near_[first + x] = 1;
      } else {
        const glm::ivec2 move = moves[fate - kMoved];
        tiles_[i] = tiles_before_[i - move.y * width_ - move.x];
        used_lines_ += tiles_[i].count;
      }
    }
  }
}

/// Cuts the edges that leave a row of corners, where they touch tiles that matter.
void LineTiles::cut_near(int row, const EdgeMap& edges, const SplineTable& table,
                         const std::vector<Rgba>& colours, Cutter& cutter) const {
  const Lattice& lattice = edges.lattice;
  const int stride = lattice.stride();
  const std::uint8_t* near = is_near_.data() + lattice.pixel(0, row);
  const auto is_row_far = [&](int y) { return are_zero(is_near_.data() + lattice.pixel(-1, y), width_ + 1); };
  if (is_row_far(row - 1) && is_row_far(row) && is_row_far(row + 1)) return;
  // The tiles round an edge's owner, as a TileMask has them.
  constexpr unsigned kEastern = 0b100100100;
  const auto eastern = [&](int x) {
    return static_cast<unsigned>(near[x + 1 - stride] << 2 | near[x + 1] << 5 | near[x + 1 + stride] << 8);
  };
  unsigned wanted = eastern(-2) >> 1 | eastern(-1);
  for (int x = 0; x <= width_; ++x) {
    wanted = (wanted >> 1 & ~kEastern) | eastern(x);
    if (wanted == 0) continue;
    const int corner = lattice.corner(x, row);
    for (const bool southwards : {false, true}) {
      const int number = edges.curve[edge_slot(corner, southwards)];
      if (number == 0 || (table.tiles(number) & wanted) == 0) continue;
      const Segment s = segment_of(table.curve(number), {x, row}, corner, southwards, stride);
      cutter.cut(s, colours[s.left], colours[s.right]);
    }
  }
}

void LineTiles::update(const EdgeMap& edges, const SplineTable& table, const std::vector<Rgba>& colours,
                       const std::vector<std::uint8_t>& fates, const std::vector<glm::ivec2>& moves) {
  start_update(edges.lattice, fates, moves);
  found_.clear();
  Cutter cutter(*this);
  for (int row = 0; row <= height_; ++row) cut_near(row, edges, table, colours, cutter);
  settle(edges.lattice, colours, lines_.size());
}

/// Sums up the colours of stale tiles, and lays out the lines that were found for them, from a line on.
void LineTiles::settle(const Lattice& lattice, const std::vector<Rgba>& colours, std::size_t first_line) {
  auto next = static_cast<std::uint32_t>(first_line);
  for (int y = 0, row = 0; y < height_; ++y, row += width_) {
    if (are_zero(is_stale_.data() + row, width_)) continue;
    TileColour colour = encode(colours[lattice.pixel(0, y)], encoding_);
    for (int i = row; i < row + width_; ++i) {
      Tile& tile = tiles_[i];
      colour = is_stale_[i] != 0 ? sum(colour, tile.colour) : tile.colour;
      if (is_stale_[i] == 0) continue;
      tile.colour = colour;
      next += tile.count;
      tile.first = next;
    }
  }
  lines_.resize(next);
  used_lines_ += found_.size();
  // From the back: `first` is a tile's end at first.
  std::for_each(found_.rbegin(), found_.rend(),
                [&](const Found& found) { lines_[--tiles_[found.tile].first] = found.line; });
}

void LineTiles::compact() {
  spare_.resize(used_lines_);
  std::uint32_t next = 0;
  for (Tile& tile : tiles_) {
    std::copy_n(lines_.begin() + tile.first, tile.count, spare_.begin() + next);
    tile.first = next;
    next += tile.count;
  }
  lines_.swap(spare_);
}

bool operator==(const LineTiles& a, const LineTiles& b) {
  const auto is_same = [&](const Tile& tile, const Tile& other) {
    const auto first = a.lines_.begin() + tile.first;
    return tile.colour == other.colour && tile.count == other.count &&
           std::equal(first, first + tile.count, b.lines_.begin() + other.first);
  };
  return a.width_ == b.width_ &&
         std::equal(a.tiles_.begin(), a.tiles_.end(), b.tiles_.begin(), b.tiles_.end(), is_same);
}

std::size_t LineTiles::memory_bytes() const {
  return held_bytes(tiles_, tiles_before_, lines_, spare_, found_, is_stale_, is_near_);
}

}  // namespace depixel
