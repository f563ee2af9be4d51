#include "libdepixel/incremental/map_changes.hpp"

#include <algorithm>

namespace depixel {

void MapChanges::add(const MapChanges& later) {
  if (everything || !later.any()) return;
  if (later.everything || !any()) {
    everything = true;  // if memory for the rest cannot be had
    tiles = later.tiles;
    moves = later.moves;
    new_tiles = later.new_tiles;
    moved_tiles = later.moved_tiles;
    everything = later.everything;
    return;
  }
  new_tiles = 0;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    tiles[i] = tiles[i] != kSame || later.tiles[i] != kSame ? kNew : kSame;
    new_tiles += tiles[i];
  }
  moved_tiles = 0;
  moves.clear();
}

}  // namespace depixel
