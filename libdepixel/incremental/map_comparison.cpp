#include "libdepixel/incremental/map_comparison.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "libdepixel/core/simd.hpp"

namespace depixel {
namespace {

/// The slots of the four edges round a pixel.
std::array<int, 4> edges_round(int pixel, int stride) {
  const int north_west = pixel - stride - 1;
  return {edge_slot(north_west, false), edge_slot(pixel - 1, false), edge_slot(north_west, true),
          edge_slot(pixel - stride, true)};
}

template <typename Value>
void for_each_difference(const Value* a, const Value* b, int count, const auto& visit) {
  static_assert(sizeof(Value) == sizeof(std::uint32_t));
  int i = 0;
  for (; i + kWordLanes <= count; i += kWordLanes) {
    const Word4 differing = load_vector<Word4>(a + i) ^ load_vector<Word4>(b + i);
    std::array<std::uint64_t, 2> halves;
    std::memcpy(halves.data(), &differing, sizeof differing);
    if ((halves[0] | halves[1]) == 0) continue;
    for (int k = i; k < i + kWordLanes; ++k) {
      if (!(a[k] == b[k])) visit(k);
    }
  }
  for (; i < count; ++i) {
    if (!(a[i] == b[i])) visit(i);
  }
}

/// Where less than one part in so many of the tiles is new, looking for moves costs more than it saves.
constexpr int kLeastPart = 32;

/// Whether some of the new curves, taken as samples, were elsewhere before.
bool is_likely(const MapPair& maps, std::span<const SetCurve> set, glm::ivec2 move) {
  constexpr std::size_t kSamples = 128;
  constexpr int kFewest = 8;
  const int offset = 2 * (move.y * maps.lattice.stride() + move.x),
            size = static_cast<int>(maps.curve.size());
  const std::size_t step = std::max<std::size_t>(1, set.size() / kSamples);
  int samples = 0, found = 0;
  for (std::size_t i = 0; i < set.size(); i += step) {
    const int number = maps.curve[set[i].slot], from = set[i].slot - offset;
    if (number == 0 || from < 0 || from >= size) continue;
    ++samples;
    found += number == maps.curve_before[from] ? 1 : 0;
  }
  return found * kFewest > samples;
}

}  // namespace

void MapComparison::mark(const MapPair& maps, int slot, int now, int before) {
  std::uint8_t* tiles = differs_.data() + slot / 2;
  auto touched = static_cast<unsigned>(maps.table.tiles(now) | maps.table.tiles(before));
  for (; touched != 0; touched &= touched - 1) tiles[tile_offsets_[std::countr_zero(touched)]] = 1;
}

void MapComparison::find_new(const MapPair& maps, glm::ivec2 move, std::span<const SetCurve> set,
                             const RowSpans& colours, RuleSet rules, MapChanges& changes) {
  const Lattice& lattice = maps.lattice;
  const bool is_moved = move != glm::ivec2(0);
  changes.set_nothing();
  changes.tiles.assign(lattice.size(), MapChanges::kSame);
  differs_.assign(lattice.size(), 0);
  for (int bit = 0; bit < 9; ++bit) tile_offsets_[bit] = bit / 3 * lattice.stride() + bit % 3;
  const int offset = move.y * lattice.stride() + move.x;
  if (is_moved) {
    changes.moves.push_back(move);
    cover(lattice, move, changes.tiles);
    mark_lost(maps, move);
  }
  if (rules.has(Rule::tiles_by_curves)) {
    for (const SetCurve& curve : set) {
      const int now = maps.curve[curve.slot];
      if (now != curve.before) mark(maps, curve.slot, now, curve.before);
    }
  }
  const auto mark_colour = [&](int pixel) {
    if (rules.has(Rule::tiles_by_colours)) differs_[pixel] = 1;
    if (!rules.has(Rule::tiles_by_side_colours)) return;
    for (const int slot : edges_round(pixel, lattice.stride())) mark(maps, slot, maps.curve[slot], 0);
  };
  for (int y = 0; y < colours.rows(); ++y) {
    // Where the move brings colours from within the frame, they are compared; elsewhere all are new.
    const bool has_source = y >= move.y && y < lattice.height() + move.y;
    const Span span = colours[y];
    const int west = has_source ? std::clamp(std::max(0, move.x), span.from, span.to) : span.to;
    const int east = std::clamp(std::min(lattice.width(), lattice.width() + move.x), west, span.to);
    const int first = lattice.pixel(west, y);
    for (int x = span.from; x < west; ++x) mark_colour(lattice.pixel(x, y));
    for_each_difference(maps.colours.data() + first, maps.colours_before.data() + first - offset, east - west,
                        [&](int x) { mark_colour(first + x); });
    for (int x = east; x < span.to; ++x) mark_colour(lattice.pixel(x, y));
  }
  take_new(lattice, changes.tiles);
  if (is_moved) keep_flat(maps, changes.tiles);
  count(lattice, changes);
}

/// Marks edges that a move takes out of the frame, but not farther than to its side: their curves may have
/// reached into tiles that stay.
void MapComparison::mark_lost(const MapPair& maps, glm::ivec2 move) {
  const Lattice& lattice = maps.lattice;
  const auto mark_one = [&](glm::ivec2 owner, bool southwards) {
    const glm::ivec2 from = owner - move;
    if (from.x < 0 || from.y < 0 || from.x > lattice.width() || from.y > lattice.height()) return;
    const int before = maps.curve_before[edge_slot(lattice.corner(from.x, from.y), southwards)];
    mark(maps, edge_slot(lattice.corner(owner.x, owner.y), southwards), 0, before);
  };
  for (int y = 0; y <= lattice.height(); ++y) mark_one({-1, y}, false);
  for (int x = 0; x <= lattice.width(); ++x) mark_one({x, -1}, true);
}

/// Fills in what a move brings: its own value, and kNew in tiles that it uncovers.
void MapComparison::cover(const Lattice& lattice, glm::ivec2 move, std::vector<std::uint8_t>& tiles) {
  for (int y = 0; y < lattice.height(); ++y) {
    const auto row = tiles.begin() + lattice.pixel(0, y);
    std::fill_n(row, lattice.width(), MapChanges::kNew);
    if (y < move.y || y >= lattice.height() + move.y) continue;
    const int west = std::max(0, move.x), east = std::min(lattice.width(), lattice.width() + move.x);
    if (west < east) std::fill(row + west, row + east, MapChanges::kMoved);
  }
}

/// Tiles of one colour, without curves, that are what they were although the map moved need not be moved.
void MapComparison::keep_flat(const MapPair& maps, std::vector<std::uint8_t>& tiles) {
  const Lattice& lattice = maps.lattice;
  const int stride = lattice.stride();
  const auto load = [](const auto& values, int i) { return load_vector<Byte16>(values.data() + i); };
  const auto occupied = [&](const std::vector<CornerCode>& codes, int pixel) {
    const int north_west = pixel - stride - 1;
    return load(codes, north_west) | load(codes, north_west + 1) | load(codes, pixel - 1) |
           load(codes, pixel);
  };
  for (int y = 0; y < lattice.height(); ++y) {
    const int first = lattice.pixel(0, y);
    for (int x = 0; x < lattice.width(); x += sizeof(Byte16)) {  // may write into the padding
      const int pixel = first + x;
      const auto recoloured = [&](int k) -> Word4 {
        const auto now = load_vector<Word4>(maps.colours.data() + pixel + k);
        const auto before = load_vector<Word4>(maps.colours_before.data() + pixel + k);
        return reinterpret_cast<Word4>(now != before) & 1;
      };
      const Byte16 differs = occupied(maps.codes, pixel) | occupied(maps.codes_before, pixel) |
                             pack_words(recoloured(0), recoloured(4), recoloured(8), recoloured(12));
      const Byte16 tile = load(tiles, pixel);
      const auto stays = (differs == 0) & (tile != MapChanges::kNew);
      store_vector(tiles.data() + pixel, tile & ~reinterpret_cast<Byte16>(stays));
    }
  }
}

void MapComparison::count(const Lattice& lattice, MapChanges& changes) {
  changes.new_tiles = changes.moved_tiles = 0;
  for (int y = 0; y < lattice.height(); ++y) {
    const std::uint8_t* row = changes.tiles.data() + lattice.pixel(0, y);
    int fresh = 0, moved = 0;
    for (int x = 0; x < lattice.width(); ++x) {
      fresh += row[x] == MapChanges::kNew ? 1 : 0;
      moved += row[x] >= MapChanges::kMoved ? 1 : 0;
    }
    changes.new_tiles += fresh;
    changes.moved_tiles += moved;
  }
}

/// Tiles that differ are new.
void MapComparison::take_new(const Lattice& lattice, std::vector<std::uint8_t>& tiles) const {
  for (int y = 0; y < lattice.height(); ++y) {
    const int first = lattice.pixel(0, y);
    for (int x = first; x < first + lattice.width(); x += sizeof(Byte16)) {  // may write into the padding
      const auto differs = load_vector<Byte16>(differs_.data() + x) != 0;
      const auto tile = load_vector<Byte16>(tiles.data() + x);
      store_vector(tiles.data() + x, differs ? Byte16{} + MapChanges::kNew : tile);
    }
  }
}

/// Whether a tile is what one at some offset before it was: the tile's colour, the curves that touch it, and
/// the colours on their sides.
bool MapComparison::is_moved(const MapPair& maps, int tile, int offset) {
  const int stride = maps.lattice.stride();
  if (maps.colours[tile] != maps.colours_before[tile - offset]) return false;
  // Curves are owned by the nine corners round the one at the tile's north-west; for the first of them, bit 8
  // of a mask is the tile, for the next, bit 7.
  const int first_owner = tile - 2 * stride - 2;
  for (int row = 0, bit = 8; row < 3; ++row) {
    for (int column = 0; column < 3; ++column, --bit) {
      const int slot = edge_slot(first_owner + row * stride + column, false);
      const int *now = maps.curve.data() + slot, *before = maps.curve_before.data() + slot - 2 * offset;
      if (((now[0] ^ before[0]) | (now[1] ^ before[1])) == 0) continue;
      for (const int southwards : {0, 1}) {
        if (now[southwards] == before[southwards]) continue;
        const TileMask touched = maps.table.tiles(now[southwards]) | maps.table.tiles(before[southwards]);
        if ((touched >> bit & 1) != 0) return false;
      }
    }
  }
  return has_moved_sides(maps, tile, offset);
}

/// Whether the curves in a tile, which are those before, have the colours on their sides that they had.
bool MapComparison::has_moved_sides(const MapPair& maps, int tile, int offset) {
  const int stride = maps.lattice.stride(), first_owner = tile - 2 * stride - 2;
  bool is_same = true;
  for (int row = 0; row < 4; ++row) {
    const int first = first_owner + row * stride;
    is_same &= std::memcmp(maps.colours.data() + first, maps.colours_before.data() + first - offset,
                           4 * sizeof(Rgba)) == 0;
  }
  if (is_same) return true;
  const auto differs = [&](int pixel) { return maps.colours[pixel] != maps.colours_before[pixel - offset]; };
  for (int row = 0, bit = 8; row < 3; ++row) {
    for (int column = 0; column < 3; ++column, --bit) {
      const int owner = first_owner + row * stride + column;
      for (const bool southwards : {false, true}) {
        const int number = maps.curve[edge_slot(owner, southwards)];
        if ((maps.table.tiles(number) >> bit & 1) == 0) continue;
        const EdgeSides sides = sides_of(owner, southwards, stride);
        if (differs(sides.left) || differs(sides.right)) return false;
      }
    }
  }
  return true;
}

/// Gives new tiles that are what a move brings its value.
void MapComparison::take_moved(const MapPair& maps, glm::ivec2 move, MapChanges& changes) {
  constexpr int kAtOnce = sizeof(Byte16);
  const Lattice& lattice = maps.lattice;
  const bool stays = move == glm::ivec2(0);
  const auto value =
      stays ? MapChanges::kSame : static_cast<std::uint8_t>(MapChanges::kMoved + changes.moves.size());
  const int offset = move.y * lattice.stride() + move.x;
  // Tiles that have one before.
  const int west = std::max(0, move.x), east = std::min(lattice.width(), lattice.width() + move.x);
  const int north = std::max(0, move.y), south = std::min(lattice.height(), lattice.height() + move.y);
  int taken = 0;
  for (int y = north; y < south; ++y) {
    const int first = lattice.pixel(0, y);
    for (int x = west; x < east; x += kAtOnce) {
      const auto is_new = load_vector<Byte16>(changes.tiles.data() + first + x) == MapChanges::kNew;
      std::uint32_t bits = gather_bits(reinterpret_cast<Byte16>(is_new), 0);
      if (east - x < kAtOnce) bits &= (1U << (east - x)) - 1;
      for (; bits != 0; bits &= bits - 1) {
        const int tile = first + x + std::countr_zero(bits);
        if (!is_moved(maps, tile, offset)) continue;
        changes.tiles[tile] = value;
        ++taken;
      }
    }
  }
  if (taken == 0) return;
  changes.new_tiles -= taken;
  if (stays) return;
  changes.moved_tiles += taken;
  changes.moves.push_back(move);
}

void MapComparison::find_moved(const MapPair& maps, std::span<const SetCurve> set,
                               std::span<const glm::ivec2> moves, MapChanges& changes) {
  const Lattice& lattice = maps.lattice;
  for (const glm::ivec2 move : moves) {
    const bool stays = move == glm::ivec2(0);
    if (!stays && changes.new_tiles * kLeastPart <= lattice.width() * lattice.height()) return;
    // Farther ones bring nothing, and those that were tried bring no more.
    const bool is_tried = std::find(changes.moves.begin(), changes.moves.end(), move) != changes.moves.end();
    const bool is_near = std::abs(move.x) < lattice.width() && std::abs(move.y) < lattice.height();
    if (is_tried || !is_near || (!stays && !is_likely(maps, set, move))) continue;
    take_moved(maps, move, changes);
  }
}

}  // namespace depixel
