#pragma once

#include <vector>

#include "libdepixel/incremental/incremental_vectorizer.hpp"
#include "libdepixel/raster/line_tiles.hpp"
#include "libdepixel/raster/tile_box.hpp"

namespace depixel {

/// Keeps the tiles of lines of what an IncrementalVectorizer made of frame after frame: those of
/// LineTiles::build(), bit for bit, but only those are cut that are new. Tells what was written, for copies
/// of the records elsewhere.
///
/// A new tile's lines come from the edges near it, in the order of a full build. Its colour is that of its
/// western neighbour, which is what it is to be already, and what the lines there change. A tile that moved
/// has the lines that it had. New lines come after all others; when most of those are nobody's, the rest are
/// moved together.
class LineTilesUpdater {
 public:
  /// \param changes  all since the last call.
  /// Where scale or encoding are others than in the last call, or more than a third of the tiles changed, all
  /// are cut.
  void update(const IncrementalVectorizer& source, const MapChanges& changes, glm::dvec2 scale,
              TileEncoding encoding);

  /// Moves lines together, so that there are no more than need be. All records are new then.
  void compact();

  /// Whether the tiles were cut for a scale and a way to blend.
  bool is_for(glm::dvec2 scale, TileEncoding encoding) const {
    return scale_ == scale && encoding_ == encoding;
  }
  const LineTiles& tiles() const { return tiles_; }

  /// What the last call wrote: all records; or, where that is false, the tiles of some boxes, among them some
  /// that are what they were, and all lines from some line on.
  bool is_all_new() const { return is_all_new_; }
  const std::vector<TileBox>& new_boxes() const { return new_boxes_; }
  std::size_t first_new_line() const { return first_new_line_; }

  std::size_t memory_bytes() const { return tiles_.memory_bytes() + held_bytes(new_boxes_); }

 private:
  void find_boxes(const Lattice& lattice, const std::vector<std::uint8_t>& fates);
  void add_run(const TileBox& run);

  LineTiles tiles_;
  Lattice lattice_;
  glm::dvec2 scale_{0};
  TileEncoding encoding_ = TileEncoding::levels;
  bool is_all_new_ = true;
  std::vector<TileBox> new_boxes_;
  std::size_t first_new_line_ = 0;
};

}  // namespace depixel
