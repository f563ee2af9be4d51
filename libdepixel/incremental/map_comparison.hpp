#pragma once

#include <span>
#include <vector>

#include "libdepixel/incremental/map_changes.hpp"
#include "libdepixel/incremental/row_spans.hpp"
#include "libdepixel/incremental/rules.hpp"
#include "libdepixel/stages/edge_map.hpp"

namespace depixel {

/// Two maps of one size, of this frame and the one before, with curves from one table. An edge whose curve is
/// what it was has the number that it had.
struct MapPair {
  const Lattice& lattice;
  const SplineTable& table;
  const std::vector<int>&curve, &curve_before;       ///< by edge_slot()
  const std::vector<Rgba>&colours, &colours_before;  ///< padded, by pixel
};

/// Finds the tiles in which two maps differ, and those that only moved. Keeps its buffers.
class MapComparison {
 public:
  /// Marks what is new.
  /// \param slots    all edges whose curves may differ, each once.
  /// \param colours  where colours may differ.
  void find_new(const MapPair& maps, std::span<const int> slots, const RowSpans& colours, RuleSet rules,
                MapChanges& changes);

  /// Finds which of the new tiles were elsewhere in the map before: all that lies in them did. So a move need
  /// not be right, or the only one: what it does not explain stays new.
  /// \param slots  as in find_new().
  /// \param moves  to be tried, in source pixels; the first ones first.
  /// Cost: linear in corners for each move, a few operations on 16 bytes for what agrees.
  void find_moved(const MapPair& maps, std::span<const int> slots, std::span<const glm::ivec2> moves,
                  MapChanges& changes);

  std::size_t memory_bytes() const { return held_bytes(touched_, differs_); }

 private:
  void mark(const MapPair& maps, int slot, int now, int before);
  void take_marks(const Lattice& lattice, std::vector<std::uint8_t>& tiles);
  void compare_moved(const MapPair& maps, glm::ivec2 move, int first_row, int end_row);
  void take_moved(const Lattice& lattice, glm::ivec2 move, MapChanges& changes);

  std::vector<TileMask> touched_;      ///< padded, by corner: tiles that marked curves of its edges touch
  std::vector<std::uint8_t> differs_;  ///< padded, by tile: 1 where it is not what a move brings there
};

}  // namespace depixel
