#include "libdepixel/incremental/map_comparison.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <set>

#include "libdepixel/core/tolerances.hpp"
#include "libdepixel/incremental/incremental_vectorizer.hpp"
#include "tests/support/random_sequences.hpp"

namespace depixel::test {
namespace {

/// A curve in a tile, in subpixels from the tile's north-west corner, and the colours on its sides.
struct CurveInTile {
  std::array<int, 8> points;
  std::array<std::uint32_t, 2> side_colours;

  friend auto operator<=>(const CurveInTile&, const CurveInTile&) = default;
};

/// What is seen in a tile.
struct TileContent {
  std::uint32_t colour = 0;
  std::vector<CurveInTile> curves;  ///< sorted
  std::vector<std::uint32_t>
      shading;  ///< of the blocks round it, and if they have any, of the pixels round it

  friend bool operator==(const TileContent&, const TileContent&) = default;
};

glm::ivec2 point_on(const Segment& s, int numerator, int denominator) {
  const double t = double(numerator) / denominator, u = 1 - t;
  const glm::dvec2 p = u * u * u * glm::dvec2(s.p0) + 3 * u * u * t * glm::dvec2(s.p1) +
                       3 * u * t * t * glm::dvec2(s.p2) + t * t * t * glm::dvec2(s.p3);
  return {static_cast<int>(std::floor(p.x + 0.5)), static_cast<int>(std::floor(p.y + 0.5))};
}

/// What tiles are shaded by: all that lies round them.
void add_shading(const PlanarMap& map, std::vector<TileContent>& contents) {
  const Lattice& lattice = map.lattice;
  const int stride = lattice.stride();
  for (int y = 0; y < lattice.height(); ++y) {
    for (int x = 0; x < lattice.width(); ++x) {
      const int tile = lattice.pixel(x, y);
      std::vector<std::uint32_t>& shading = contents[tile].shading;
      for (const int block : {tile - stride - 1, tile - stride, tile - 1, tile})
        shading.push_back(map.shading.blocks[block]);
      if (std::count(shading.begin(), shading.end(), 0U) == 4) {
        shading.clear();
        continue;
      }
      for (const int row : {-stride, 0, stride}) {
        for (const int column : {-1, 0, 1}) {
          const int pixel = tile + row + column;
          shading.push_back(rgba_order(map.colours[pixel]));
          shading.push_back(rgba_order(map.shading.shades[pixel]));
        }
      }
    }
  }
}

/// All tiles of a map, padded, by walking along its curves: slow and simple.
std::vector<TileContent> contents_of(const PlanarMap& map) {
  constexpr int kSamples = 32;
  const Lattice& lattice = map.lattice;
  std::vector<TileContent> contents(lattice.size());
  for (int i = 0; i < lattice.size(); ++i) contents[i].colour = rgba_order(map.colours[i]);
  for (const Segment& s : map.segments) {
    std::set<int> tiles;
    for (int k = 0; k <= kSamples; ++k) {
      const glm::ivec2 p = point_on(s, k, kSamples);
      // Points on a side belong to the tiles on either side.
      for (const int y : {(p.y - 1) >> 12, p.y >> 12}) {
        for (const int x : {(p.x - 1) >> 12, p.x >> 12}) tiles.insert(lattice.pixel(x, y));
      }
    }
    for (const int tile : tiles) {
      CurveInTile curve{{}, {rgba_order(map.left_colour(s)), rgba_order(map.right_colour(s))}};
      const glm::ivec2 corner = lattice.pixel_position(tile) * kSubpixels;
      int i = 0;
      for (const glm::ivec2 p : {s.p0, s.p1, s.p2, s.p3}) {
        curve.points[i++] = p.x - corner.x;
        curve.points[i++] = p.y - corner.y;
      }
      contents[tile].curves.push_back(curve);
    }
  }
  for (TileContent& content : contents) std::sort(content.curves.begin(), content.curves.end());
  if (map.shading.any) add_shading(map, contents);
  return contents;
}
static_assert(kSubpixels == 1 << 12);

/// Checks what is told of every tile against what is in them.
void check(const Lattice& lattice, const MapChanges& changes, const std::vector<TileContent>& before,
           const std::vector<TileContent>& now) {
  int new_tiles = 0, moved_tiles = 0;
  for (int y = 0; y < lattice.height(); ++y) {
    for (int x = 0; x < lattice.width(); ++x) {
      const int tile = lattice.pixel(x, y), stride = lattice.stride();
      const std::uint8_t change = changes.tiles[tile];
      RC_LOG() << "tile " << x << ", " << y << ": " << int(change) << '\n';
      if (change == MapChanges::kSame) {
        RC_ASSERT(now[tile] == before[tile]);
      } else if (change >= MapChanges::kMoved) {
        ++moved_tiles;
        const glm::ivec2 from = glm::ivec2(x, y) - changes.moves[change - MapChanges::kMoved];
        RC_ASSERT(from.x >= 0 && from.y >= 0 && from.x < lattice.width() && from.y < lattice.height());
        RC_ASSERT(now[tile] == before[lattice.pixel(from.x, from.y)]);
      } else {
        ++new_tiles;
        // Boxes of curves reach a tile farther than they do.
        bool is_other = false;
        for (const int row : {-stride, 0, stride}) {
          for (const int column : {-1, 0, 1})
            is_other |= now[tile + row + column] != before[tile + row + column];
        }
        RC_ASSERT(is_other);
      }
    }
  }
  RC_ASSERT(changes.new_tiles == new_tiles);
  RC_ASSERT(changes.moved_tiles == moved_tiles);
}

RC_GTEST_PROP(MapComparison, TilesAreWhatTheyAreSaidToBe, (const Sequence& sequence)) {
  IncrementalVectorizer vectorizer;
  std::vector<TileContent> before;
  for (const SequenceFrame& frame : sequence.frames) {
    vectorizer.vectorize(frame.picture.view(), frame.options);
    const std::vector<TileContent> now = contents_of(vectorizer.map());
    const MapChanges& changes = vectorizer.changes();
    if (!changes.any()) RC_ASSERT(now == before);
    if (changes.any() && !changes.everything) check(vectorizer.lattice(), changes, before, now);
    before = now;
  }
}

RC_GTEST_PROP(MapComparison, MovesNeedNotBeRight, (const Sequence& sequence)) {
  std::vector<glm::ivec2> moves;
  for (int i = *random_int(1, 5); i > 0; --i) moves.emplace_back(*random_int(-4, 5), *random_int(-4, 5));

  IncrementalVectorizer vectorizer;
  MapComparison comparison;
  EdgeMap edges_before;
  std::vector<CornerCode> codes_before;
  std::vector<Rgba> colours_before;
  Shading shading_before;
  std::vector<TileContent> before;
  for (const SequenceFrame& frame : sequence.frames) {
    vectorizer.vectorize(frame.picture.view(), frame.options);
    const std::vector<TileContent> now = contents_of(vectorizer.map());
    const Lattice& lattice = vectorizer.lattice();
    // Numbers of curves are good until all is new.
    const bool is_known = vectorizer.stats().changed_pixels < vectorizer.stats().pixels &&
                          edges_before.lattice == lattice && !vectorizer.changes().everything;
    if (is_known) {
      const MapPair maps{lattice,
                         vectorizer.table(),
                         vectorizer.edges().curve,
                         edges_before.curve,
                         vectorizer.cells().corners,
                         codes_before,
                         vectorizer.colours(),
                         colours_before,
                         vectorizer.shading(),
                         shading_before};
      std::vector<SetCurve> set;
      for (int y = 0; y <= lattice.height(); ++y) {
        for (int x = 0; x <= lattice.width(); ++x) {
          for (const bool southwards : {false, true}) {
            const int slot = edge_slot(lattice.corner(x, y), southwards);
            const int now_at = maps.curve[slot], number_before = maps.curve_before[slot];
            if (now_at != number_before) set.push_back({slot, number_before});
          }
        }
      }
      std::vector<int> colours;
      for (int i = 0; i < lattice.size(); ++i) {
        if (maps.colours[i] != maps.colours_before[i]) colours.push_back(i);
      }
      BlockMoves still;
      still.set_unknown(lattice);
      MapChanges changes;
      comparison.find_new(maps, still, set, colours, {}, changes);
      comparison.find_moved(maps, still, set, moves, changes);
      check(lattice, changes, before, now);
    }
    edges_before = vectorizer.edges();
    codes_before = vectorizer.cells().corners;
    colours_before = vectorizer.colours();
    shading_before = vectorizer.shading();
    before = now;
  }
}

TEST(MapComparison, TwoLayersMoveByTheirOwnMoves) {
  // The upper half goes east, the lower one west.
  const auto layered = [](int offset) {
    Picture picture(60, 40);
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        const int u = y < 20 ? x - offset : x + offset;
        const double height =
            std::sin(0.3 * u + 0.4 * y) + std::sin(0.11 * u - 0.37 * y) + std::sin(0.01 * u * u);
        picture.at(x, y) = palette_colour(height > 0.4 ? 'r' : y < 20 ? 'g' : 'b');
      }
    }
    return picture;
  };
  IncrementalVectorizer vectorizer;
  vectorizer.vectorize(layered(0).view(), {});
  vectorizer.vectorize(layered(1).view(), {});
  const MapChanges& changes = vectorizer.changes();
  ASSERT_FALSE(changes.everything);
  EXPECT_NE(std::find(changes.moves.begin(), changes.moves.end(), glm::ivec2(1, 0)), changes.moves.end());
  EXPECT_NE(std::find(changes.moves.begin(), changes.moves.end(), glm::ivec2(-1, 0)), changes.moves.end());
  EXPECT_GT(changes.moved_tiles, changes.new_tiles);
}

}  // namespace
}  // namespace depixel::test
