#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "libdepixel/core/memory.hpp"

namespace depixel {

/// Where a planar map differs from the one before, by the square tiles of the source's pixels.
struct MapChanges {
  /// What is in a tile: kSame as before; kNew; or, from kMoved on, what was in the tile that lies by
  /// -moves[tile - kMoved] from it before.
  static constexpr std::uint8_t kSame = 0, kNew = 1, kMoved = 2;

  bool everything = true;  ///< all is new, or nothing is known of the map before; tiles mean nothing
  int new_tiles = 0, moved_tiles = 0;
  std::vector<std::uint8_t> tiles;  ///< padded, by pixel; in the padding, kSame
  std::vector<glm::ivec2> moves;    ///< source pixels

  bool any() const { return everything || new_tiles != 0 || moved_tiles != 0; }

  void set_nothing() {
    everything = false;
    new_tiles = moved_tiles = 0;
    moves.clear();
  }
  /// Adds what changed after this; what moved is new then.
  void add(const MapChanges& later);

  std::size_t memory_bytes() const { return held_bytes(tiles, moves); }
};

}  // namespace depixel
