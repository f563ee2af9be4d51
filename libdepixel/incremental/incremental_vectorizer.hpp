#pragma once

#include <optional>
#include <vector>

#include "libdepixel/incremental/block_moves.hpp"
#include "libdepixel/incremental/dither_updater.hpp"
#include "libdepixel/incremental/incremental_edges.hpp"
#include "libdepixel/incremental/incremental_graph.hpp"
#include "libdepixel/incremental/map_comparison.hpp"
#include "libdepixel/incremental/move_guess.hpp"
#include "libdepixel/incremental/rules.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"

namespace depixel {

/// Vectorizes successive frames of a sequence: the same maps as a Vectorizer's, bit for bit, for work that
/// follows what changed. What a change makes stale is told by the rules in rules.hpp.
///
/// What moved, as when a game scrolls in one layer or several, is moved, with all that is known of it, and is
/// like all else that did not change. What a move does not explain costs little more than what it is: links
/// and codes are cheap to compute anew, sixteen at a time, and contours have their splines from the table of
/// shapes. Where tiles of the map moved as they were is told in changes(), for rasterisers.
class IncrementalVectorizer {
 public:
  explicit IncrementalVectorizer(RuleSet rules = {}) : rules_(rules) {}

  /// \param input  a frame of at least 1x1 pixels; read during the call only.
  void vectorize(const FrameView& input, const Options& options);
  /// Forgets the frames before: the next one is vectorized from scratch.
  void reset() { options_.reset(); }

  /// Where the map differs from that of the call before.
  const MapChanges& changes() const { return changes_; }

  /// Resolved. Its pixels are the frame's, with dithers blended if asked for.
  const SimilarityGraph& graph() const { return graph_.resolved(); }
  const CellGraph& cells() const { return cells_; }
  const EdgeMap& edges() const { return edges_.edges(); }
  const SplineTable& table() const { return edges_.table(); }
  const std::vector<Rgba>& colours() const { return cells_.colours; }
  const Shading& shading() const { return shading_; }
  const Lattice& lattice() const { return graph_.lattice(); }
  /// True where nothing of the frame lets anything through.
  bool is_opaque() const { return is_opaque_; }
  MapByEdge by_edge() const { return {edges(), table(), cells_.colours, shading_}; }
  /// The map as a list of segments; made when it is asked for, and kept until the next frame.
  const PlanarMap& map() const;
  const VectorizeStats& stats() const { return stats_; }

 private:
  void update(const FrameView& input, const Options& options);
  FrameView blended(const FrameView& frame, const Options& options, bool is_known);
  void drop_buffers();
  void forget(const Lattice& lattice);
  void settle_colours();
  void move_cells();
  const Components* find_components();
  void build_cells();
  void recolour();
  void find_changed_colours(const BlockSet& blocks, const std::vector<Rgba>& others);
  void encode();
  void encode_row(int y, std::span<const BlockSet::Run> runs);
  void mark();
  void add_newly_marked(int y, BlockSet::Run run);
  void add_seams();
  bool has_new_mark_beside(glm::ivec2 beyond, const BlockMoves::Seam& seam) const;
  void add_stale(int corner, CornerCode before);
  bool has_many_stale() const;
  void set_all_changed();
  void compare();
  void count();
  std::size_t memory_bytes() const;

  RuleSet rules_;
  std::optional<Options> options_;  ///< of the frame before; none at first
  bool is_working_ = false;
  Workers workers_;

  DitherUpdater dithers_;
  Border border_;
  MoveGuess guess_;
  BlockMoves blocks_;
  IncrementalGraph graph_;
  Components components_;
  CellGraph cells_;
  std::vector<Rgba> colours_before_;
  std::vector<int> changed_colours_;  ///< pixels whose colours are not those moved here
  bool is_opaque_ = false;
  Shading shading_, shading_before_;
  std::vector<PixelMarks> marks_;

  bool is_new_ = false;                  ///< hardly anything of the frame before is worth a look
  std::vector<int> stale_;               ///< corners whose contours are to be traced again
  std::vector<CornerCode> stale_codes_;  ///< what their codes were
  IncrementalEdges edges_;

  std::vector<CornerCode> codes_before_;  ///< read where the frame moved
  bool are_colours_settled_ = false;      ///< those before are those now, but for what changed since

  MapComparison comparison_;
  MapChanges changes_;

  std::vector<std::uint8_t> row_before_;  ///< scratch
  std::vector<PixelMarks> marks_before_;  ///< scratch
  std::vector<PixelMarks> moved_marks_;   ///< marks_ before they were moved
  std::vector<Rgba> unpainted_;           ///< scratch
  mutable PlanarMap map_;
  mutable bool is_map_made_ = false;
  VectorizeStats stats_;
};

}  // namespace depixel
