#include "libdepixel/incremental/incremental_vectorizer.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace depixel {
namespace {

/// The table is made anew when it holds more curves than this for each pixel of the frame; a frame adds a few
/// more.
constexpr double kCurvesAPixel = 1.25, kAddedCurvesAPixel = 0.75;
constexpr double kFewestCurves = 1 << 14;

double most_curves(const Lattice& lattice) {
  return std::max(kFewestCurves, kCurvesAPixel * lattice.width() * lattice.height());
}

/// Where more than this part of the tiles is new, all are taken to be: looking for the others costs more than
/// it saves.
constexpr double kMostNew = 0.6;

/// The options that vectorizing depends on; others are set to a common value.
Options of_vectorizing(Options options) {
  options.linear_light = false;
  options.threads = 1;
  return options;
}

template <typename Value>
void copy_span(const Lattice& lattice, const RowSpans& spans, const std::vector<Value>& from,
               std::vector<Value>& to) {
  for (int y = 0; y < spans.rows(); ++y) {
    const int first = lattice.pixel(spans[y].from, y);
    std::copy_n(from.begin() + first, spans[y].length(), to.begin() + first);
  }
}

bool is_opaque_part(const Lattice& lattice, const RowSpans& spans, const std::vector<Rgba>& colours) {
  std::uint8_t all = 255;
  for (int y = 0; y < spans.rows(); ++y) {
    const Rgba* row = colours.data() + lattice.pixel(0, y);
    for (int x = spans[y].from; x < spans[y].to; ++x) all &= row[x].a;
  }
  return all == 255;
}

void set_all(const Lattice& lattice, RowSpans& spans) {
  spans.reset(lattice.height());
  for (int y = 0; y < lattice.height(); ++y) spans.set(y, {0, lattice.width()});
}

}  // namespace

void IncrementalVectorizer::vectorize(const FrameView& frame, const Options& options) {
  StageClock clock(stats_);
  workers_.set_threads(options.threads);
  const Lattice lattice(frame.width, frame.height);
  const bool is_known = options_ && *options_ == of_vectorizing(options) && graph_.lattice == lattice &&
                        table_.places() <= place_limit_;
  options_ = of_vectorizing(options);
  stats_.changed_pixels = stats_.stale_corners = stats_.changed_tiles = stats_.moved_tiles = 0;
  stats_.crossings = stats_.contours = stats_.nodes = stats_.arcs = stats_.fitted_shapes = 0;
  if (!is_known) forget(lattice);
  find_changed_pixels(frame, graph_, changed_pixels_);
  if (is_known && !changed_pixels_.any()) {
    settle_before();
    changes_.set_nothing();
    clock.finish(0);
    return;
  }
  move_ = is_known ? guess_.guess(frame, graph_).value_or(glm::ivec2(0)) : glm::ivec2(0);
  is_all_stale_ = !is_known || move_ != glm::ivec2(0);
  if (move_ != glm::ivec2(0)) {
    move_everything();
    find_changed_pixels(frame, graph_, changed_pixels_);
  } else {
    settle_before();
  }
  stats_.changed_pixels = take_changed_pixels(frame, changed_pixels_, graph_);
  is_map_made_ = false;
  relink(frame);
  clock.finish(0);

  resolve();
  clock.finish(1);

  recolour();
  encode();
  find_thin();
  clock.finish(2);

  trace();
  clock.finish(3);

  fit();
  join();
  clock.finish(4);

  if (is_known) {
    compare();
  } else {
    changes_.everything = true;
    // Frames like noise have more curves of their own.
    place_limit_ = std::max(static_cast<std::size_t>(most_curves(lattice)), 2 * table_.places());
  }
  count();
  if (!is_known) stats_.changed_pixels = stats_.pixels;
  clock.finish(5);
}

void IncrementalVectorizer::count() {
  const Lattice& lattice = graph_.lattice;
  stats_.pixels = lattice.width() * lattice.height();
  stats_.changed_tiles = changes_.everything ? stats_.pixels : changes_.new_tiles;
  stats_.moved_tiles = changes_.everything ? 0 : changes_.moved_tiles;

  stats_.memory_bytes = memory_bytes();
}

/// All that was known is void.
void IncrementalVectorizer::forget(const Lattice& lattice) {
  graph_.lattice = {};
  graph_.resize(lattice);
  frozen_.lattice = {};
  frozen_.resize(lattice);
  links_before_.assign(lattice.size(), 0);
  cells_.lattice = {};
  cells_.resize(lattice);
  colours_before_.assign(lattice.size(), Rgba{});
  thin_.assign(lattice.size() + sizeof(std::uint64_t) * 2, 1);  // as all pixels without links are
  table_.clear();
  table_.reserve(static_cast<std::size_t>(most_curves(lattice) +
                                          kAddedCurvesAPixel * lattice.width() * lattice.height()));
  votes_.clear();
  guess_.clear();
  edges_.lattice = lattice;
  edges_.curve.assign(2 * std::size_t(lattice.size()), 0);
  curves_before_ = edges_.curve;
  codes_before_ = cells_.corners;
  is_slot_set_.assign(edges_.curve.size(), 0);
  set_curves_.clear();
  is_before_settled_ = false;
  is_opaque_ = false;
  stats_.segments = 0;
}

/// What is of this frame becomes that of the frame before. The next frame's is the same until it changes.
void IncrementalVectorizer::settle_before() {
  if (is_before_settled_) {
    for (const SetCurve& set : set_curves_) curves_before_[set.slot] = edges_.curve[set.slot];
    copy_span(graph_.lattice, changed_colours_, cells_.colours, colours_before_);
  } else {
    curves_before_ = edges_.curve;
    colours_before_ = cells_.colours;
  }
  is_before_settled_ = true;
  forget_set_curves();
  changed_colours_.reset(graph_.lattice.height());
}

void IncrementalVectorizer::forget_set_curves() {
  for (const SetCurve& set : set_curves_) is_slot_set_[set.slot] = 0;
  set_curves_.clear();
}

/// Everything that is known is moved as most of the frame has. What is of this frame becomes that of the
/// frame before, and what is moved is this frame's until it changes. Nothing is
/// known of what a move uncovers. All rows are stale then, and every contour that passes a place where what
/// is known is not what it should be is traced again, as its codes there differ.
void IncrementalVectorizer::move_everything() {
  const Lattice& lattice = graph_.lattice;
  const GridPart pixels = GridPart::pixels(lattice), corners = GridPart::corners(lattice);
  move_entries(pixels, move_, Rgba{}, graph_.pixels, graph_.pixels);
  move_entries(pixels, move_, std::uint8_t{0}, frozen_.links, frozen_.links);
  move_entries(pixels, move_, std::uint8_t{0}, links_before_, links_before_);
  move_entries(pixels, move_, std::uint8_t{0}, thin_, thin_);
  move_entries(pixels, move_, Rgba{}, cells_.colours, colours_before_);
  move_entries(corners, move_, CornerCode{}, cells_.corners, codes_before_);
  move_entries(corners.times(2), {2 * move_.x, move_.y}, 0, edges_.curve, curves_before_);
  std::swap(cells_.colours, colours_before_);
  std::swap(cells_.corners, codes_before_);
  std::swap(edges_.curve, curves_before_);
  const auto hidden = std::count(edges_.curve.begin(), edges_.curve.end(), 0);
  stats_.segments = static_cast<int>(static_cast<std::ptrdiff_t>(edges_.curve.size()) - hidden);
  is_before_settled_ = false;
  forget_set_curves();
}

bool IncrementalVectorizer::has_whole_components() const {
  return options_->similarity == Similarity::merge || options_->connect_lines;
}

/// Rule::links_by_pixels.
void IncrementalVectorizer::relink(const FrameView& frame) {
  const Lattice& lattice = graph_.lattice;
  if (has_whole_components()) {
    build_similarity_graph(frame, options_->similarity, options_->connect_lines, graph_);
    frozen_.links = graph_.links;
    set_all(lattice, changed_frozen_);
    return;
  }
  changed_frozen_.reset(lattice.height());
  row_before_.resize(lattice.width());
  for (int y = 0; y < lattice.height(); ++y) {
    // The block row reads the pixels of this row and the next.
    const bool is_stale = is_all_stale_ || !changed_pixels_.is_empty(y) ||
                          (rules_.has(Rule::links_by_pixels) && !changed_pixels_.is_empty(y + 1));
    if (!is_stale) continue;
    const std::uint8_t* row = frozen_.links.data() + lattice.pixel(0, y);
    std::copy_n(row, lattice.width(), row_before_.begin());
    link_exact_rows(graph_, y, y + 1, frozen_.links);
    changed_frozen_.set(y, differing_part(row, row_before_.data(), lattice.width()));
  }
}

/// Where nothing is known of links, or they reach over whole components, all crossings are resolved; else
/// only those whose votes may have changed.
void IncrementalVectorizer::resolve() {
  const Lattice& lattice = graph_.lattice;
  changed_links_.reset(lattice.height());
  if (!changed_frozen_.any() && !is_all_stale_) return;
  const CrossingVotes votes{options_->curve_weight, options_->sparse_weight, options_->island_weight};
  if (is_all_stale_ || has_whole_components()) {
    graph_.links = frozen_.links;
    stats_.crossings = resolve_crossings(graph_, votes, crossings_);
  } else {
    copy_span(lattice, changed_frozen_, frozen_.links, graph_.links);
    const std::vector<int>& stale =
        stale_crossings_.find(frozen_, changed_frozen_, rules_, crossings_.neighbours);
    resolve_some_crossings(frozen_, stale, votes, crossings_, graph_.links);
    stats_.crossings = static_cast<int>(stale.size());
  }
  for (int y = 0; y < lattice.height(); ++y) {
    const int first = lattice.pixel(0, y);
    const std::uint8_t *now = graph_.links.data() + first, *before = links_before_.data() + first;
    if (std::memcmp(now, before, lattice.width()) == 0) continue;
    changed_links_.set(y, differing_part(now, before, lattice.width()));
  }
  copy_span(lattice, changed_links_, graph_.links, links_before_);
}

void IncrementalVectorizer::recolour() {
  const Lattice& lattice = graph_.lattice;
  if (!has_whole_components()) {
    changed_colours_ = changed_pixels_;
    copy_span(lattice, changed_colours_, graph_.pixels, cells_.colours);
    // What was opaque stays so unless something transparent comes.
    is_opaque_ = is_opaque_ && !is_all_stale_ ? is_opaque_part(lattice, changed_colours_, cells_.colours)
                                              : depixel::is_opaque(lattice, cells_.colours);
    return;
  }
  label_components(graph_, components_);
  find_majority_colours(graph_, components_);
  paint_cells(graph_, &components_, cells_);
  is_opaque_ = depixel::is_opaque(lattice, cells_.colours);
  if (is_all_stale_) {  // they are to be compared with those that were moved, and these are painted over
    set_all(lattice, changed_colours_);
    return;
  }
  changed_colours_.reset(lattice.height());
  for (int y = 0; y < lattice.height(); ++y) {
    const int first = lattice.pixel(0, y);
    changed_colours_.set(
        y, differing_part(cells_.colours.data() + first, colours_before_.data() + first, lattice.width()));
  }
}

/// Encodes a part of a row of corners and finds those whose code differs.
void IncrementalVectorizer::encode_part(int y, Span part) {
  const Lattice& lattice = graph_.lattice;
  static_assert(sizeof(CornerCode) == 1);
  const int first = lattice.corner(0, y), count = lattice.width() + 1;
  const auto* codes = reinterpret_cast<const std::uint8_t*>(cells_.corners.data()) + first;
  std::copy_n(codes, count, row_before_.begin());
  encode_corners(graph_, has_whole_components() ? &components_ : nullptr, y, part.from,
                 std::min(part.to, count), cells_);
  const Span span = differing_part(codes, row_before_.data(), count);
  for (int x = span.from; x < span.to; ++x) {
    if (codes[x] != row_before_[x]) add_stale(first + x, CornerCode(row_before_[x]));
  }
}

/// Rule::codes_by_links and Rule::codes_by_colours.
void IncrementalVectorizer::encode() {
  const Lattice& lattice = graph_.lattice;
  const bool is_everything = is_all_stale_ || has_whole_components();
  stale_.clear();
  stale_codes_.clear();
  row_before_.resize(lattice.width() + 1);
  for (int y = 0; y <= lattice.height(); ++y) {
    // The row's blocks have their north-west pixels in row y - 1; what changed in a column of blocks, or of
    // pixels, concerns the corners on either side.
    const auto changed = [&](const RowSpans& spans, Rule rule) {
      return rules_.has(rule) ? united({spans.at(y - 1), spans.at(y), Span{}}) : Span{};
    };
    Span part = united({changed(changed_links_, Rule::codes_by_links),
                        changed(changed_colours_, Rule::codes_by_colours), Span{}});
    if (is_everything) part = {0, lattice.width()};
    if (!part.is_empty()) encode_part(y, {part.from, part.to + 1});
  }
}

/// Rule::thin_by_links; and contours along pixels that are thin no longer, or now, are stale.
void IncrementalVectorizer::find_thin() {
  if (options_->smoothing != Smoothing::energy || !rules_.has(Rule::thin_by_links)) return;
  const Lattice& lattice = graph_.lattice;
  const int stride = lattice.stride();
  for (int y = 0; y < lattice.height(); ++y) {
    if (!is_all_stale_ && changed_links_.is_empty(y - 1) && changed_links_.is_empty(y)) continue;
    const int first = lattice.pixel(0, y);
    const std::uint8_t* thin = thin_.data() + first;
    std::copy_n(thin, lattice.width(), row_before_.begin());
    find_thin_pixels(graph_, y, y + 1, thin_);
    if (!rules_.has(Rule::curves_by_thin)) continue;
    const Span span = differing_part(thin, row_before_.data(), lattice.width());
    for (int x = span.from; x < span.to; ++x) {
      if (thin[x] == row_before_[x]) continue;
      for (const int corner : {first + x - stride - 1, first + x - stride, first + x - 1, first + x}) {
        const CornerCode code = cells_.corners[corner];
        if (code.visible_edges() != 0) add_stale(corner, code);
      }
    }
  }
}

void IncrementalVectorizer::add_stale(int corner, CornerCode before) {
  stale_.push_back(corner);
  stale_codes_.push_back(before);
}

/// Rule::edges_by_codes.
void IncrementalVectorizer::remove_edges() {
  const std::array<int, 4> step = graph_.lattice.step_offsets();
  for (std::size_t i = 0; i < stale_.size(); ++i) {
    const CornerCode now = cells_.corners[stale_[i]];
    auto gone = static_cast<unsigned>(stale_codes_[i].visible_edges() & ~now.visible_edges());
    for (; gone != 0; gone &= gone - 1) {
      const int slot = edge_end(stale_[i], static_cast<Direction>(std::countr_zero(gone)), step).slot;
      if (edges_.curve[slot] == 0) continue;  // seen from the other end
      set_curve(slot, 0);
    }
  }
}

/// Rule::curves_by_codes.
void IncrementalVectorizer::trace() {
  if (rules_.has(Rule::edges_by_codes)) remove_edges();
  std::span<const int> traced = stale_;
  if (!rules_.has(Rule::curves_by_codes)) traced = traced.first(traced.size() / 2);
  trace_contours_through(cells_, traced, contours_);
  cut_arcs(cells_, contours_, thin_, options_->spline, options_->smoothing, arcs_);
  stats_.stale_corners = static_cast<int>(stale_.size());
  stats_.contours = static_cast<int>(contours_.list.size());
  stats_.nodes = static_cast<int>(contours_.corner.size());
  stats_.arcs = static_cast<int>(arcs_.list.size());
}

void IncrementalVectorizer::set_curve(int slot, int number) {
  if (edges_.curve[slot] == number) return;
  if (is_slot_set_[slot] == 0) {
    is_slot_set_[slot] = 1;
    set_curves_.push_back({slot, edges_.curve[slot]});
  }
  stats_.segments += (number != 0 ? 1 : 0) - (edges_.curve[slot] != 0 ? 1 : 0);
  edges_.curve[slot] = number;
}

void IncrementalVectorizer::fit() {
  const Lattice& lattice = graph_.lattice;
  const std::array<int, 4> step = lattice.step_offsets();
  votes_.start_frame();
  for (Arc& arc : arcs_.list) {
    arc.place = table_.place_of(arcs_.words(arc), arc.kind);
    votes_.see(arc.place, arcs_.corner[arc.first], arc.count, lattice);
  }
  stats_.fitted_shapes = table_.fit_added(options_->smoothing, workers_);
  for (const Arc& arc : arcs_.list) {
    for_each_edge(arcs_, arc, table_, step, [&](int slot, int number) { set_curve(slot, number); });
  }
}

/// Rule::joints_by_curves: all T-junctions that contours end at or go through.
void IncrementalVectorizer::join() {
  if (!rules_.has(Rule::joints_by_curves)) {
    for (const Contour& contour : contours_.list) {
      if (contour.closed) continue;
      for (const int end : {contour.first, contour.first + contour.count - 1}) {
        if (cells_.is_t_junction(contours_.corner[end])) {
          const JoinedEdge joined = join_at(contours_.corner[end], cells_, edges_, table_);
          set_curve(joined.slot, joined.curve);
        }
      }
    }
    return;
  }
  for (const int corner : contours_.corner) {
    if (!cells_.is_t_junction(corner)) continue;
    const JoinedEdge joined = join_at(corner, cells_, edges_, table_);
    set_curve(joined.slot, joined.curve);
  }
}

void IncrementalVectorizer::compare() {
  const MapPair maps{graph_.lattice, table_,        edges_.curve,   curves_before_,
                     cells_.corners, codes_before_, cells_.colours, colours_before_};
  comparison_.find_new(maps, move_, set_curves_, changed_colours_, rules_, changes_);
  moves_.clear();
  if (move_ != glm::ivec2(0)) moves_.emplace_back(0);
  const std::vector<glm::ivec2>& voted = votes_.most_voted();
  moves_.insert(moves_.end(), voted.begin(), voted.end());
  comparison_.find_moved(maps, set_curves_, moves_, changes_);
  std::for_each(changes_.moves.rbegin(), changes_.moves.rend(),
                [&](glm::ivec2 move) { guess_.remember(move); });
  if (changes_.new_tiles > kMostNew * lattice().width() * lattice().height()) changes_.everything = true;
}

const PlanarMap& IncrementalVectorizer::map() const {
  if (!is_map_made_) build_planar_map(edges_, table_, cells_.colours, map_);
  is_map_made_ = true;
  return map_;
}

std::size_t IncrementalVectorizer::memory_bytes() const {
  return graph_.memory_bytes() + frozen_.memory_bytes() + stale_crossings_.memory_bytes() +
         held_bytes(links_before_, colours_before_, thin_, stale_, stale_codes_, curves_before_, set_curves_,
                    is_slot_set_, codes_before_, moves_, row_before_) +
         crossings_.memory_bytes() + components_.memory_bytes() + cells_.memory_bytes() +
         changed_pixels_.memory_bytes() + changed_frozen_.memory_bytes() + changed_links_.memory_bytes() +
         changed_colours_.memory_bytes() + contours_.memory_bytes() + arcs_.memory_bytes() +
         votes_.memory_bytes() + guess_.memory_bytes() + table_.memory_bytes() + edges_.memory_bytes() +
         comparison_.memory_bytes() + changes_.memory_bytes() + map_.memory_bytes();
}

}  // namespace depixel
