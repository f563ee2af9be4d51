#include "libdepixel/incremental/map_comparison.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "libdepixel/core/simd.hpp"
#include "libdepixel/incremental/byte_rows.hpp"

namespace depixel {
namespace {

/// The slots of the four edges round a pixel.
std::array<int, 4> edges_round(int pixel, int stride) {
  const int north_west = pixel - stride - 1;
  return {edge_slot(north_west, false), edge_slot(pixel - 1, false), edge_slot(north_west, true),
          edge_slot(pixel - stride, true)};
}

/// Whether sixteen bytes from two places on are equal.
bool are_equal(const void* a, const void* b) {
  return is_zero(load_vector<Byte16>(a) ^ load_vector<Byte16>(b));
}

/// What is known of a tile: nothing, that it may not be what its block's move brings, and that it is not.
constexpr std::uint8_t kMaybe = 1, kDiffers = 2;

/// Where less than one part in so many of the tiles is new, looking for moves costs more than it saves.
constexpr int kLeastPart = 32;

/// What tiles that moved so have; a move that is not known yet is to be added.
std::uint8_t value_of(glm::ivec2 move, const MapChanges& changes) {
  if (move == glm::ivec2(0)) return MapChanges::kSame;
  const auto known = std::find(changes.moves.begin(), changes.moves.end(), move);
  return static_cast<std::uint8_t>(MapChanges::kMoved + (known - changes.moves.begin()));
}

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
  for (; touched != 0; touched &= touched - 1) tiles[tile_offsets_[std::countr_zero(touched)]] = kDiffers;
}

void MapComparison::mark_tiles(const Lattice& lattice, glm::ivec2 across, glm::ivec2 down) {
  for (int y = down[0]; y < down[1]; ++y) {
    std::uint8_t* row = differs_.data() + lattice.pixel(0, y);
    std::fill(row + across[0], row + std::max(across[0], across[1]), kMaybe);
  }
}

void MapComparison::find_new(const MapPair& maps, const BlockMoves& blocks, std::span<const SetCurve> set,
                             std::span<const int> colours, RuleSet rules, MapChanges& changes) {
  const Lattice& lattice = maps.lattice;
  changes.set_nothing();
  changes.tiles.assign(lattice.size(), MapChanges::kSame);
  differs_.assign(lattice.size(), 0);
  for (int bit = 0; bit < 9; ++bit) tile_offsets_[bit] = bit / 3 * lattice.stride() + bit % 3;
  if (blocks.any_moved()) cover(lattice, blocks, changes);
  if (rules.has(Rule::tiles_by_curves)) {
    for (const SetCurve& curve : set) {
      const int now = maps.curve[curve.slot];
      if (now != curve.before) mark(maps, curve.slot, now, curve.before);
    }
  }
  for (const int pixel : colours) {
    if (rules.has(Rule::tiles_by_colours)) differs_[pixel] = kDiffers;
    if (!rules.has(Rule::tiles_by_side_colours)) continue;
    for (const int slot : edges_round(pixel, lattice.stride())) mark(maps, slot, maps.curve[slot], 0);
  }
  if (rules.has(Rule::tiles_by_seams)) {
    mark_lost(maps, blocks);
    mark_seams(lattice, blocks);
  }
  take_new(lattice, changes.tiles);
  if (blocks.any_moved()) keep_flat(maps, changes.tiles);
  if (rules.has(Rule::tiles_by_shading)) take_new_shading(maps, changes);
  count(lattice, changes);
}

/// Gives each tile the value of its block's move, and marks those that moves uncover.
void MapComparison::cover(const Lattice& lattice, const BlockMoves& blocks, MapChanges& changes) {
  const BlockGrid& grid = blocks.grid();
  for (int y = 0; y < lattice.height(); ++y) {
    std::uint8_t* tiles = changes.tiles.data() + lattice.pixel(0, y);
    for (const BlockMoves::Run& run : blocks.runs(y / BlockGrid::kSide)) {
      const std::uint8_t value = value_of(run.move, changes);
      if (value == MapChanges::kMoved + changes.moves.size()) changes.moves.push_back(run.move);
      std::fill(tiles + run.from, tiles + run.to, value);
      const bool has_source = y >= run.move.y && y < grid.height + run.move.y;
      const int west = has_source ? std::clamp(run.move.x, run.from, run.to) : run.to;
      const int east = std::clamp(grid.width + run.move.x, west, run.to);
      mark_tiles(lattice, {run.from, west}, {y, y + 1});
      mark_tiles(lattice, {east, run.to}, {y, y + 1});
    }
  }
}

/// Rule::tiles_by_seams: marks tiles, whatever they were marked as before, into which curves may reach from
/// beyond a seam, or whose curves may have a side there.
void MapComparison::mark_seams(const Lattice& lattice, const BlockMoves& blocks) {
  // A tile's curves have their sides from two pixels before it to one behind it.
  constexpr int kBefore = 2, kBehind = 1;
  const BlockGrid& grid = blocks.grid();
  const auto side = [](int step, int first, int end) {
    return step < 0   ? glm::ivec2(first, std::min(first + kBefore, end))
           : step > 0 ? glm::ivec2(end - kBehind, end)
                      : glm::ivec2(first, end);
  };
  for (const BlockMoves::Seam& seam : blocks.seams()) {
    const auto& [column, row, step] = seam;
    if (blocks.is_border(seam)) continue;  // see mark_lost()
    mark_tiles(lattice, side(step.x, grid.first_x(column), grid.end_x(column)),
               side(step.y, grid.first_y(row), grid.end_y(row)));
  }
}

/// Rule::tiles_by_seams, at the frame's border: marks tiles into which curves reached whose edges moved out
/// of the frame, by a pixel. Those that are still in it, on the border, are among the edges that changed.
void MapComparison::mark_lost(const MapPair& maps, const BlockMoves& blocks) {
  const Lattice& lattice = maps.lattice;
  const auto mark_one = [&](glm::ivec2 owner, glm::ivec2 move, bool southwards) {
    const glm::ivec2 from = owner - move;
    if (from.x < 0 || from.y < 0 || from.x > lattice.width() || from.y > lattice.height()) return;
    const int before = maps.curve_before[edge_slot(lattice.corner(from.x, from.y), southwards)];
    mark(maps, edge_slot(lattice.corner(owner.x, owner.y), southwards), 0, before);
  };
  const BlockGrid& grid = blocks.grid();
  for (const BlockMoves::Seam& seam : blocks.seams()) {
    if (!blocks.is_border(seam)) continue;
    const glm::ivec2 move = blocks.move(seam.column, seam.row);
    const int first_x = grid.first_x(seam.column), end_x = grid.end_x(seam.column);
    const int first_y = grid.first_y(seam.row), end_y = grid.end_y(seam.row);
    if (seam.step == glm::ivec2(-1, 0)) {
      for (int y = first_y; y <= end_y; ++y) mark_one({-1, y}, move, false);
    } else if (seam.step == glm::ivec2(0, -1)) {
      for (int x = first_x; x <= end_x; ++x) mark_one({x, -1}, move, true);
    }
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
    const int first = lattice.pixel(0, y), end = first + lattice.width();
    for (int x = first; x < end; x += sizeof(Byte16)) {
      const auto differs = load_vector<Byte16>(differs_.data() + x) != 0;
      const auto tile = load_vector<Byte16>(tiles.data() + x);
      store_vector(tiles.data() + x, differs ? Byte16{} + MapChanges::kNew : tile);
    }
    std::fill_n(tiles.begin() + end, sizeof(Byte16) - 1, MapChanges::kSame);  // what of that was padding
  }
}

/// Rule::tiles_by_shading: tiles that are not shaded as those that they are said to be were are new.
void MapComparison::take_new_shading(const MapPair& maps, MapChanges& changes) {
  if (!maps.shading.any && !maps.shading_before.any) return;
  const Lattice& lattice = maps.lattice;
  for (int y = 0; y < lattice.height(); ++y) {
    const int first = lattice.pixel(0, y);
    for (int tile = first; tile < first + lattice.width(); ++tile) {
      const std::uint8_t fate = changes.tiles[tile];
      if (fate == MapChanges::kNew) continue;
      const glm::ivec2 move =
          fate == MapChanges::kSame ? glm::ivec2(0) : changes.moves[fate - MapChanges::kMoved];
      if (!is_shading_moved(maps, tile, move.y * lattice.stride() + move.x))
        changes.tiles[tile] = MapChanges::kNew;
    }
  }
}

/// Whether colours run in a tile as in one at some offset before it.
bool MapComparison::is_shading_moved(const MapPair& maps, int tile, int offset) {
  if (!maps.shading.any && !maps.shading_before.any) return true;
  const int stride = maps.lattice.stride();
  const auto block = [](const Shading& shading, int i) {
    return shading.any ? shading.blocks[i] : std::uint8_t{0};
  };
  int shaded = 0;
  for (const int corner : {tile - stride - 1, tile - stride, tile - 1, tile}) {
    const std::uint8_t now = block(maps.shading, corner);
    if (now != block(maps.shading_before, corner - offset)) return false;
    shaded |= now;
  }
  if (shaded == 0) return true;
  constexpr std::size_t kThree = 3 * sizeof(Rgba);
  const auto are_equal = [&](const std::vector<Rgba>& now, const std::vector<Rgba>& before, int pixel) {
    return std::memcmp(now.data() + pixel, before.data() + pixel - offset, kThree) == 0;
  };
  for (const int pixel : {tile - stride - 1, tile - 1, tile + stride - 1}) {
    if (!are_equal(maps.colours, maps.colours_before, pixel) ||
        !are_equal(maps.shading.shades, maps.shading_before.shades, pixel))
      return false;
  }
  return true;
}

/// Whether a tile is what one at some offset before it was: the tile's colour, the curves that touch it, and
/// the colours on their sides.
bool MapComparison::is_moved(const MapPair& maps, int tile, int offset) {
  const int stride = maps.lattice.stride();
  if (maps.colours[tile] != maps.colours_before[tile - offset]) return false;
  // Curves are owned by the nine corners round the one at the tile's north-west; for the first of them, bit 8
  // of a mask is the tile, for the next, bit 7.
  const int first_owner = tile - 2 * stride - 2;
  bool is_same = true;
  for (int row = 0; row < 3; ++row) {
    const int slot = edge_slot(first_owner + row * stride, false);
    const int *now = maps.curve.data() + slot, *before = maps.curve_before.data() + slot - 2 * offset;
    if (are_equal(now, before) && are_equal(now + 2, before + 2)) continue;
    unsigned differing = 0;  // without branches, which would be hard to predict
    for (int k = 0; k < 6; ++k) {
      const unsigned touched = maps.table.tiles(now[k]) | maps.table.tiles(before[k]);
      differing |= now[k] != before[k] ? touched >> (8 - 3 * row - k / 2) : 0;
    }
    if ((differing & 1) != 0) return false;
  }
  for (int row = 0; row < 4; ++row) {
    const int first = first_owner + row * stride;
    is_same &= are_equal(maps.colours.data() + first, maps.colours_before.data() + first - offset);
  }
  return (is_same || has_moved_sides(maps, tile, offset)) && is_shading_moved(maps, tile, offset);
}

/// Whether the curves in a tile, which are those before, have the colours on their sides that they had.
bool MapComparison::has_moved_sides(const MapPair& maps, int tile, int offset) {
  const int stride = maps.lattice.stride(), first_owner = tile - 2 * stride - 2;
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

/// Gives new tiles that are what a move brings its value. Those that are known to differ from what their own
/// block's move brings are not compared with that again.
void MapComparison::take_moved(const MapPair& maps, const BlockMoves& blocks, glm::ivec2 move,
                               MapChanges& changes) const {
  const Lattice& lattice = maps.lattice;
  const std::uint8_t value = value_of(move, changes);
  const int offset = move.y * lattice.stride() + move.x;
  int taken = 0;
  const auto take = [&](int tile) {
    if (!is_moved(maps, tile, offset)) return;
    changes.tiles[tile] = value;
    ++taken;
  };
  // Tiles that have one before.
  const int north = std::max(0, move.y), south = std::min(lattice.height(), lattice.height() + move.y);
  for (int y = north; y < south; ++y) {
    for (const BlockMoves::Run& run : blocks.runs(y / BlockGrid::kSide)) {
      const int from = std::clamp(move.x, run.from, run.to);
      const int to = std::clamp(lattice.width() + move.x, from, run.to);
      const int first = lattice.pixel(from, y);
      const std::uint8_t *tiles = changes.tiles.data() + first, *differs = differs_.data() + first;
      const bool is_own = run.move == move;
      for_each_equal(tiles, to - from, MapChanges::kNew, [&](int i) {
        if (!is_own || differs[i] != kDiffers) take(first + i);
      });
    }
  }
  if (taken == 0) return;
  changes.new_tiles -= taken;
  if (value == MapChanges::kSame) return;
  changes.moved_tiles += taken;
  if (value == MapChanges::kMoved + changes.moves.size()) changes.moves.push_back(move);
}

void MapComparison::find_moved(const MapPair& maps, const BlockMoves& blocks, std::span<const SetCurve> set,
                               std::span<const glm::ivec2> moves, MapChanges& changes) {
  const Lattice& lattice = maps.lattice;
  if (blocks.any_moved()) {
    for (const glm::ivec2 move : blocks.moves()) take_moved(maps, blocks, move, changes);
  }
  for (const glm::ivec2 move : moves) {
    if (changes.new_tiles * kLeastPart <= lattice.width() * lattice.height()) return;
    // Farther ones bring nothing, and those that were tried bring no more.
    const bool is_tried = std::find(changes.moves.begin(), changes.moves.end(), move) != changes.moves.end();
    const bool is_near = std::abs(move.x) < lattice.width() && std::abs(move.y) < lattice.height();
    if (!is_tried && is_near && is_likely(maps, set, move)) take_moved(maps, blocks, move, changes);
  }
}

}  // namespace depixel
