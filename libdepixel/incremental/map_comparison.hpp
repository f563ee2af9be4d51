#pragma once

#include <array>
#include <span>
#include <vector>

#include "libdepixel/incremental/block_moves.hpp"
#include "libdepixel/incremental/map_changes.hpp"
#include "libdepixel/incremental/rules.hpp"
#include "libdepixel/stages/edge_map.hpp"
#include "libdepixel/stages/planar_map.hpp"

namespace depixel {

/// Two maps of one size, of this frame and the one before, with curves from one table.
struct MapPair {
  const Lattice& lattice;
  const SplineTable& table;
  const std::vector<int>&curve, &curve_before;         ///< by edge_slot()
  const std::vector<CornerCode>&codes, &codes_before;  ///< padded, by corner; read where the map moved
  const std::vector<Rgba>&colours, &colours_before;    ///< padded, by pixel
  const Shading &shading, &shading_before;
};

/// An edge that was given a curve, and the number of the one that it had; 0 stands for none. Equal curves
/// have equal numbers here.
struct SetCurve {
  int slot, before;
};

/// Finds the tiles in which two maps differ, and those that only moved. Keeps its buffers.
class MapComparison {
 public:
  /// Tells what is new, and what is as it was or moved with its block.
  /// \param blocks   by whose moves the map before was moved to make this one.
  /// \param set      all edges whose curves may differ from those of the map moved, each once.
  /// \param colours  pixels whose colours differ from them, each once.
  void find_new(const MapPair& maps, const BlockMoves& blocks, std::span<const SetCurve> set,
                std::span<const int> colours, RuleSet rules, MapChanges& changes);

  /// Finds which of the new tiles are what they were (the move by nothing), and which were elsewhere in the
  /// map before: all that lies in them was. So a move need not be right, or the only one: what it does not
  /// explain stays new.
  /// \param blocks, set  as in find_new(); the blocks' moves are tried first.
  /// \param moves        others to be tried, in source pixels; the first ones first.
  /// Cost: for each move, linear in new tiles.
  void find_moved(const MapPair& maps, const BlockMoves& blocks, std::span<const SetCurve> set,
                  std::span<const glm::ivec2> moves, MapChanges& changes);

  std::size_t memory_bytes() const { return held_bytes(differs_); }

 private:
  void cover(const Lattice& lattice, const BlockMoves& blocks, MapChanges& changes);
  void mark_lost(const MapPair& maps, const BlockMoves& blocks);
  void mark_seams(const Lattice& lattice, const BlockMoves& blocks);
  static void keep_flat(const MapPair& maps, std::vector<std::uint8_t>& tiles);
  static void count(const Lattice& lattice, MapChanges& changes);
  void mark(const MapPair& maps, int slot, int now, int before);
  void mark_tiles(const Lattice& lattice, glm::ivec2 across, glm::ivec2 down);
  void take_new(const Lattice& lattice, std::vector<std::uint8_t>& tiles) const;
  static bool is_shading_moved(const MapPair& maps, int tile, int offset);
  static void take_new_shading(const MapPair& maps, MapChanges& changes);
  static bool is_moved(const MapPair& maps, int tile, int offset);
  static bool has_moved_sides(const MapPair& maps, int tile, int offset);
  void take_moved(const MapPair& maps, const BlockMoves& blocks, glm::ivec2 move, MapChanges& changes) const;

  std::array<int, 9> tile_offsets_{};  ///< by bit of a TileMask: from the edge's owner to the tile
  std::vector<std::uint8_t> differs_;  ///< padded, by tile: 0 where it is what its block's move brings
};

}  // namespace depixel
