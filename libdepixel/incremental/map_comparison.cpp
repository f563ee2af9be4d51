#include "libdepixel/incremental/map_comparison.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "libdepixel/core/simd.hpp"

namespace depixel {
namespace {

/// True where two edges have the same curve, or none.
bool is_same(const SplineTable& table, int a, int b) {
  return a == b || (a != 0 && b != 0 && table.curve(a) == table.curve(b));
}

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
    found += is_same(maps.table, number, maps.curve_before[from]) ? 1 : 0;
  }
  return found * kFewest > samples;
}

/// Eight masks that are worked on together.
using Mask8 = TileMask __attribute__((vector_size(16)));

}  // namespace

void MapComparison::mark(const MapPair& maps, int slot, int now, int before) {
  touched_[slot / 2] |= maps.table.tiles(now) | maps.table.tiles(before);
}

/// Gives the tiles that the marked edges' curves touch a value; forgets the marks.
void MapComparison::take_marks(const Lattice& lattice, std::uint8_t value, std::vector<std::uint8_t>& tiles) {
  constexpr int kLanes = sizeof(Mask8) / sizeof(TileMask);
  const int stride = lattice.stride();
  std::array<int, 9> back;  // from a tile to the owner whose mask's bit it is
  for (int bit = 0; bit < 9; ++bit) back[bit] = bit / 3 * stride + bit % 3;
  // Owners may lie a corner outside the frame.
  const int owners = lattice.width() + 3;
  const auto row_of_owners = [&](int y) { return touched_.data() + lattice.corner(-1, y); };
  const auto is_marked = [&](int y) {
    const TileMask* row = row_of_owners(y);
    return row[0] != 0 || std::memcmp(row, row + 1, (owners - 1) * sizeof(TileMask)) != 0;
  };
  bool above = is_marked(-1), at = is_marked(0), below;
  for (int y = 0; y < lattice.height(); ++y, above = at, at = below) {
    below = is_marked(y + 1);
    if (!above && !at && !below) continue;
    const int first = lattice.pixel(0, y);
    for (int x = 0; x < lattice.width(); x += kLanes) {  // may write into the padding
      Mask8 found{};
      for (int bit = 0; bit < 9; ++bit) {
        found |= load_vector<Mask8>(touched_.data() + first + x - back[bit]) >> bit;
      }
      found &= 1;
      for (int lane = 0; lane < kLanes; ++lane) {
        std::uint8_t& tile = tiles[first + x + lane];
        tile = found[lane] != 0 ? value : tile;
      }
    }
    if (above) std::fill_n(row_of_owners(y - 1), owners, TileMask{0});
  }
  for (int y = lattice.height() - 1; y <= lattice.height() + 1; ++y) {
    std::fill_n(row_of_owners(y), owners, TileMask{0});
  }
}

void MapComparison::find_new(const MapPair& maps, glm::ivec2 move, std::span<const SetCurve> set,
                             const RowSpans& colours, RuleSet rules, MapChanges& changes) {
  const Lattice& lattice = maps.lattice;
  const bool is_moved = move != glm::ivec2(0);
  changes.set_nothing();
  changes.tiles.assign(lattice.size(), MapChanges::kSame);
  touched_.resize(lattice.size());
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
    if (rules.has(Rule::tiles_by_colours)) changes.tiles[pixel] = MapChanges::kNew;
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
  take_marks(lattice, MapChanges::kNew, changes.tiles);
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

/// In each row, from the first new tile to the last.
void MapComparison::find_new_spans(const Lattice& lattice, const std::vector<std::uint8_t>& tiles) {
  new_.reset(lattice.height());
  for (int y = 0; y < lattice.height(); ++y) {
    const std::uint8_t* row = tiles.data() + lattice.pixel(0, y);
    const auto* first = static_cast<const std::uint8_t*>(std::memchr(row, MapChanges::kNew, lattice.width()));
    if (first == nullptr) continue;
    int to = lattice.width();
    while (row[to - 1] != MapChanges::kNew) --to;
    new_.set(y, {static_cast<int>(first - row), to});
  }
}

/// Marks the tiles that are not what lay by a move from them before, where new ones are, and maybe others.
void MapComparison::compare_moved(const MapPair& maps, glm::ivec2 move) {
  const Lattice& lattice = maps.lattice;
  const int stride = lattice.stride(), offset = move.y * stride + move.x;
  // Tiles that have one before: west .. east - 1, north .. south - 1.
  const int west = std::max(0, move.x), east = std::min(lattice.width(), lattice.width() + move.x);
  const int north = std::max(0, move.y), south = std::min(lattice.height(), lattice.height() + move.y);
  // Curves touch them from one corner farther on: in one of the maps that may lie in the padding, without
  // any.
  for (int y = north - 1; y <= south + 1; ++y) {
    const Span span = united(new_.around(y));
    const int from = std::max(span.from, west) - 1, to = std::min(span.to, east) + 1;
    if (span.is_empty() || from >= to) continue;
    const int first = edge_slot(lattice.corner(from, y), false);
    const int* before = maps.curve_before.data() + first - 2 * offset;
    for_each_difference(maps.curve.data() + first, before, 2 * (to - from + 1), [&](int i) {
      const int now = maps.curve[first + i];
      if (!is_same(maps.table, now, before[i])) mark(maps, first + i, now, before[i]);
    });
  }
  for (int y = north; y < south; ++y) {
    const Span span = united(new_.around(y));
    const int from = std::max(span.from - 1, west), to = std::min(span.to + 1, east);
    if (span.is_empty() || from >= to) continue;
    const int first = lattice.pixel(from, y);
    for_each_difference(maps.colours.data() + first, maps.colours_before.data() + first - offset, to - from,
                        [&](int x) {
                          differs_[first + x] = 1;
                          for (const int slot : edges_round(first + x, stride)) {
                            mark(maps, slot, maps.curve[slot], maps.curve_before[slot - 2 * offset]);
                          }
                        });
  }
  take_marks(lattice, 1, differs_);
}

/// Gives new tiles that are what a move brings its value.
void MapComparison::take_moved(const Lattice& lattice, glm::ivec2 move, MapChanges& changes) const {
  const bool stays = move == glm::ivec2(0);
  const auto value =
      stays ? MapChanges::kSame : static_cast<std::uint8_t>(MapChanges::kMoved + changes.moves.size());
  const int west = std::max(0, move.x), east = std::min(lattice.width(), lattice.width() + move.x);
  for (int y = std::max(0, move.y); y < std::min(lattice.height(), lattice.height() + move.y); ++y) {
    std::uint8_t* tiles = changes.tiles.data() + lattice.pixel(0, y);
    const std::uint8_t* differs = differs_.data() + lattice.pixel(0, y);
    for (int x = west; x < east; ++x) {
      tiles[x] = tiles[x] == MapChanges::kNew && differs[x] == 0 ? value : tiles[x];
    }
  }
  const int before = changes.new_tiles;
  count(lattice, changes);
  if (changes.new_tiles < before && !stays) changes.moves.push_back(move);
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
    find_new_spans(lattice, changes.tiles);
    differs_.assign(lattice.size(), 0);
    compare_moved(maps, move);
    take_moved(lattice, move, changes);
  }
}

}  // namespace depixel
