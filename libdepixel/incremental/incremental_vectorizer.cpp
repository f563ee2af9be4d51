#include "libdepixel/incremental/incremental_vectorizer.hpp"

#include <algorithm>

#include "libdepixel/incremental/byte_rows.hpp"

namespace depixel {
namespace {

/// Where more than this part of the tiles is new, all are taken to be: looking for the others costs more than
/// it saves.
constexpr double kMostNew = 0.6;

/// Where more corners are stale than this part of the edges that were visible, and than that part of all
/// corners, all contours are: looking for the others costs more than it saves.
constexpr double kMostStale = 0.5, kFewestStale = 0.15;

/// The options that vectorizing depends on; others are set to a common value.
Options of_vectorizing(Options options) {
  if (options.dither == DitherKind::keep) options.linear_light = false;
  options.threads = 1;
  return options;
}

/// No pixel's: those that nothing shows of are normalized.
constexpr Rgba kUnknownColour{1, 1, 1, 0};

}  // namespace

void IncrementalVectorizer::vectorize(const FrameView& input, const Options& options) {
  if (is_working_) drop_buffers();  // the last frame failed on the way
  is_working_ = true;
  update(input, options);
  is_working_ = false;
}

void IncrementalVectorizer::update(const FrameView& input, const Options& options) {
  StageClock clock(stats_);
  workers_.set_threads(options.threads);
  const Lattice size = Border::lattice_of(input, options.border);
  const bool is_known =
      options_ && *options_ == of_vectorizing(options) && lattice() == size && !edges_.has_many_shapes();
  options_ = of_vectorizing(options);
  const FrameView frame = border_.continued(blended(input, options, is_known), options.border);
  stats_.changed_pixels = stats_.stale_corners = stats_.changed_tiles = stats_.moved_tiles = 0;
  stats_.crossings = stats_.contours = stats_.nodes = stats_.arcs = stats_.fitted_shapes = 0;
  if (!is_known) {
    forget(size);
    blocks_.set_unknown(size);
  } else if (!blocks_.find_changed_rows(frame, graph())) {
    changes_.set_nothing();
    clock.finish(0);
    return;
  } else {
    blocks_.find(frame, graph(), guess_.guess(frame, graph()));
    edges_.start(blocks_);
    blocks_.any_moved() ? move_cells() : settle_colours();
  }
  stats_.changed_pixels = blocks_.changed_pixels();
  is_map_made_ = false;
  clock.finish(0);

  graph_.update(frame, options, blocks_, rules_);
  stats_.crossings = graph_.crossings();
  clock.finish(1);

  is_new_ = !is_known || graph_.is_new();
  if (is_new_) {
    build_cells();
  } else {
    recolour();
    encode();
    mark();
    add_seams();
    is_new_ = has_many_stale();
  }
  clock.finish(2);

  if (is_new_) {
    edges_.trace_all(cells_, marks_, options);
  } else {
    edges_.trace_stale(cells_, marks_, stale_, stale_codes_, options, blocks_, rules_);
  }
  clock.finish(3);

  edges_.fit(cells_, options, rules_, workers_);
  clock.finish(4);

  std::swap(shading_, shading_before_);
  build_shading(graph(), cells_, options, shading_);
  is_new_ ? set_all_changed() : compare();
  count();
  clock.finish(5);
}

/// The frame, with its dithers blended if asked for.
FrameView IncrementalVectorizer::blended(const FrameView& frame, const Options& options, bool is_known) {
  if (options.dither == DitherKind::keep) return frame;
  if (!is_known) dithers_.reset();
  return dithers_.update(frame, options.linear_light, rules_);
}

void IncrementalVectorizer::count() {
  const Lattice& lattice = cells_.lattice;
  stats_.pixels = lattice.shown_width() * lattice.shown_height();
  stats_.changed_tiles = changes_.everything ? stats_.pixels : changes_.new_tiles;
  stats_.moved_tiles = changes_.everything ? 0 : changes_.moved_tiles;
  const int corners = (lattice.width() + 1) * (lattice.height() + 1);
  stats_.stale_corners = is_new_ ? corners : static_cast<int>(stale_.size());
  stats_.contours = static_cast<int>(edges_.contours().list.size());
  stats_.nodes = static_cast<int>(edges_.contours().corner.size());
  stats_.arcs = static_cast<int>(edges_.arcs().list.size());
  stats_.fitted_shapes = edges_.fitted_shapes();
  stats_.segments = edges_.segments();
  stats_.memory_bytes = memory_bytes();
}

/// Buffers of a frame that failed may have different sizes.
void IncrementalVectorizer::drop_buffers() {
  reset();
  dithers_ = {};
  border_ = {};
  blocks_ = {};
  graph_ = {};
  components_ = {};
  cells_ = {};
  edges_ = {};
  comparison_ = {};
  changes_ = {};
  shading_ = shading_before_ = {};
}

/// All that was known is void.
void IncrementalVectorizer::forget(const Lattice& lattice) {
  graph_.reset(lattice);
  cells_.lattice = {};
  cells_.resize(lattice);
  marks_.assign(lattice.size() + sizeof(Byte16), kThinLine);  // as all pixels without links are
  edges_.reset(lattice);
  codes_before_.assign(lattice.size(), CornerCode{});
  colours_before_.assign(lattice.size(), Rgba{});
  stale_.clear();
  changed_colours_.clear();
  are_colours_settled_ = false;
  is_opaque_ = false;
}

/// The colours of this frame become those of the frame before. The next frame's are the same until they
/// change.
void IncrementalVectorizer::settle_colours() {
  if (are_colours_settled_) {
    for (const int pixel : changed_colours_) colours_before_[pixel] = cells_.colours[pixel];
  } else {
    colours_before_ = cells_.colours;
  }
  are_colours_settled_ = true;
}

/// What is of this frame becomes that of the frame before; and, moved as its blocks were, that of this frame
/// until it changes. Nothing is known of what a move uncovers.
void IncrementalVectorizer::move_cells() {
  const GridPart pixels = GridPart::pixels(lattice());
  std::swap(cells_.colours, colours_before_);
  std::swap(cells_.corners, codes_before_);
  move_blocks(blocks_, pixels, kUnknownColour, colours_before_, cells_.colours);
  move_blocks(blocks_, GridPart::corners(lattice()), CornerCode{}, codes_before_, cells_.corners);
  moved_marks_ = marks_;
  move_blocks(blocks_, pixels, PixelMarks{0}, moved_marks_, marks_);
  are_colours_settled_ = false;
}

/// Those of the frame, where cells are made of whole ones; else none.
const Components* IncrementalVectorizer::find_components() {
  if (!options_->has_whole_components()) return nullptr;
  label_components(graph(), components_);
  find_majority_colours(graph(), components_);
  return &components_;
}

/// Colours and codes of all cells, and the marks of pixels.
void IncrementalVectorizer::build_cells() {
  build_cell_graph(graph(), find_components(), cells_);
  if (options_->smoothing == Smoothing::energy) find_pixel_marks(graph(), options_->text_safe, marks_);
  stale_.clear();
  is_opaque_ = depixel::is_opaque(lattice(), cells_.colours);
}

void IncrementalVectorizer::recolour() {
  if (options_->has_whole_components()) {
    unpainted_ = cells_.colours;
    paint_cells(graph(), find_components(), cells_);
    find_changed_colours(graph_.stale(), unpainted_);
  } else {
    find_changed_colours(blocks_.changed(), graph().pixels);
    for (const int pixel : changed_colours_) cells_.colours[pixel] = graph().pixels[pixel];
  }
  // What was opaque stays so unless something transparent comes.
  is_opaque_ = is_opaque_ ? std::all_of(changed_colours_.begin(), changed_colours_.end(),
                                        [&](int pixel) { return cells_.colours[pixel].a == 255; })
                          : depixel::is_opaque(lattice(), cells_.colours);
}

/// Finds the pixels of some blocks that have other colours than the cells.
void IncrementalVectorizer::find_changed_colours(const BlockSet& blocks, const std::vector<Rgba>& others) {
  changed_colours_.clear();
  for (int y = 0; y < lattice().height(); ++y) {
    const int first = lattice().pixel(0, y);
    for (const BlockSet::Run run : blocks.runs(y)) {
      for (int i = first + run.from; i < first + run.to; ++i) {
        if (cells_.colours[i] != others[i]) changed_colours_.push_back(i);
      }
    }
  }
}

/// Rule::codes_by_pixels; and, as the graph tells what is stale, Rule::codes_by_crossings.
void IncrementalVectorizer::encode() {
  stale_.clear();
  stale_codes_.clear();
  if (!rules_.has(Rule::codes_by_pixels)) return;
  for (int y = 0; y <= lattice().height(); ++y) {
    const auto runs = graph_.stale().runs(std::min(y, lattice().height() - 1));
    if (!runs.empty()) encode_row(y, runs);
  }
}

/// Encodes the stale corners of a row and finds those whose code differs.
void IncrementalVectorizer::encode_row(int y, std::span<const BlockSet::Run> runs) {
  static_assert(sizeof(CornerCode) == 1);
  const int width = lattice().width(), first = lattice().corner(0, y);
  const auto* codes = reinterpret_cast<const std::uint8_t*>(cells_.corners.data()) + first;
  const Components* components = options_->has_whole_components() ? &components_ : nullptr;
  for (const BlockSet::Run run : runs) {
    const int from = run.from, end = run.to == width ? width + 1 : run.to;
    row_before_.assign(codes + from, codes + end + sizeof(Byte16));
    encode_corners(graph(), components, y, from, end, cells_);
    for_each_difference(codes + from, row_before_.data(), end - from,
                        [&](int i) { add_stale(first + from + i, CornerCode(row_before_[i])); });
  }
}

/// Rule::marks_by_links and Rule::text_by_marks. What makes a mark differ is less than a block away.
void IncrementalVectorizer::mark() {
  if (options_->smoothing != Smoothing::energy || !rules_.has(Rule::marks_by_links)) return;
  marks_before_ = marks_;
  const auto for_each_run = [&](auto visit) {
    for (int y = 0; y < lattice().height(); ++y) {
      for (const BlockSet::Run run : graph_.stale().runs(y)) visit(y, run);
    }
  };
  for_each_run([&](int y, BlockSet::Run run) {
    mark_lines(graph(), options_->text_safe, y, run.from, run.to, marks_);
  });
  if (options_->text_safe && rules_.has(Rule::text_by_marks)) {
    for_each_run([&](int y, BlockSet::Run run) { mark_text(graph(), y, run.from, run.to, marks_); });
  }
  if (rules_.has(Rule::curves_by_marks)) {
    for_each_run([&](int y, BlockSet::Run run) { add_newly_marked(y, run); });
  }
}

/// Rule::curves_by_marks: contours along pixels with other marks than before are stale.
void IncrementalVectorizer::add_newly_marked(int y, BlockSet::Run run) {
  const int first = lattice().pixel(run.from, y), stride = lattice().stride();
  for_each_difference(marks_.data() + first, marks_before_.data() + first, run.to - run.from, [&](int i) {
    const int pixel = first + i;
    for (const int corner : {pixel - stride - 1, pixel - stride, pixel - 1, pixel}) {
      const CornerCode code = cells_.corners[corner];
      if (code.visible_edges() != 0) add_stale(corner, code);
    }
  });
}

/// Rule::curves_by_seams: contours that cross a seam are stale, and those that run along one by pixels with
/// other marks than those before.
void IncrementalVectorizer::add_seams() {
  if (!rules_.has(Rule::curves_by_seams)) return;
  const BlockGrid& grid = blocks_.grid();
  // Corners move with the blocks at their south-east: each block holds those at its west and north.
  for (const BlockMoves::Seam& seam : blocks_.seams()) {
    const bool is_west = seam.step == glm::ivec2(-1, 0);
    if (!is_west && seam.step != glm::ivec2(0, -1)) continue;
    const Direction across = is_west ? kWest : kNorth, along = is_west ? kSouth : kEast;
    const glm::ivec2 last = is_west ? glm::ivec2(grid.first_x(seam.column), grid.end_y(seam.row))
                                    : glm::ivec2(grid.end_x(seam.column), grid.first_y(seam.row));
    for (glm::ivec2 at(grid.first_x(seam.column), grid.first_y(seam.row));; at += kStep[along]) {
      const int corner = lattice().corner(at.x, at.y);
      const CornerCode code = cells_.corners[corner];
      const bool is_stale = code.is_visible(across) || (at != last && code.is_visible(along) &&
                                                        has_new_mark_beside(at + seam.step, seam));
      if (is_stale) add_stale(corner, code);
      if (at == last) break;
    }
  }
}

/// Whether a pixel beyond a seam has other marks than what was there for the block on this side.
bool IncrementalVectorizer::has_new_mark_beside(glm::ivec2 beyond, const BlockMoves::Seam& seam) const {
  if (options_->smoothing != Smoothing::energy) return false;
  const auto mark_at = [&](const std::vector<std::uint8_t>& marks, glm::ivec2 at) {
    const bool is_inside = at.x >= 0 && at.y >= 0 && at.x < lattice().width() && at.y < lattice().height();
    return is_inside ? marks[lattice().pixel(at.x, at.y)] : std::uint8_t{0};
  };
  return mark_at(marks_, beyond) != mark_at(moved_marks_, beyond - blocks_.move(seam.column, seam.row));
}

void IncrementalVectorizer::add_stale(int corner, CornerCode before) {
  stale_.push_back(corner);
  stale_codes_.push_back(before);
}

bool IncrementalVectorizer::has_many_stale() const {
  return static_cast<double>(stale_.size()) > kMostStale * edges_.segments() &&
         is_most(lattice(), kFewestStale, stale_.size());
}

/// Nothing is told of what differs from the frame before. What may have moved is tried next time.
void IncrementalVectorizer::set_all_changed() {
  changes_.everything = true;
  are_colours_settled_ = false;
  for (const glm::ivec2 move : edges_.votes().most_voted()) guess_.remember(move);
}

void IncrementalVectorizer::compare() {
  if (is_most(lattice(), kMostNew, changed_colours_.size())) return set_all_changed();
  const MapPair maps{lattice(),     edges_.table(), edges_.edges().curve, edges_.before(), cells_.corners,
                     codes_before_, cells_.colours, colours_before_,      shading_,        shading_before_};
  comparison_.find_new(maps, blocks_, edges_.set(), changed_colours_, rules_, changes_);
  comparison_.find_moved(maps, blocks_, edges_.set(), edges_.votes().most_voted(), changes_);
  std::for_each(changes_.moves.rbegin(), changes_.moves.rend(),
                [&](glm::ivec2 move) { guess_.remember(move); });
  if (is_most(lattice(), kMostNew, changes_.new_tiles)) changes_.everything = true;
}

const PlanarMap& IncrementalVectorizer::map() const {
  if (!is_map_made_) build_planar_map(by_edge(), map_);
  is_map_made_ = true;
  return map_;
}

std::size_t IncrementalVectorizer::memory_bytes() const {
  return dithers_.memory_bytes() + border_.memory_bytes() + graph_.memory_bytes() + blocks_.memory_bytes() +
         components_.memory_bytes() + cells_.memory_bytes() + shading_.memory_bytes() +
         shading_before_.memory_bytes() +
         held_bytes(colours_before_, changed_colours_, marks_, stale_, stale_codes_, codes_before_,
                    row_before_, marks_before_, moved_marks_, unpainted_) +
         guess_.memory_bytes() + edges_.memory_bytes() + comparison_.memory_bytes() +
         changes_.memory_bytes() + map_.memory_bytes();
}

}  // namespace depixel
