#include "libdepixel/incremental/incremental_edges.hpp"

#include <algorithm>
#include <bit>

namespace depixel {
namespace {

/// The table is made anew when its shapes have more steps than this for each pixel of the frame; a frame adds
/// a few more.
constexpr double kPlacesAPixel = 1.25, kAddedPlacesAPixel = 0.75;
constexpr double kFewestPlaces = 1 << 14;

double most_places(const Lattice& lattice) {
  return std::max(kFewestPlaces, kPlacesAPixel * lattice.width() * lattice.height());
}

}  // namespace

void IncrementalEdges::reset(const Lattice& lattice) {
  table_.clear();
  table_.reserve(static_cast<std::size_t>(most_places(lattice) +
                                          kAddedPlacesAPixel * lattice.width() * lattice.height()));
  votes_.clear();
  edges_.lattice = lattice;
  edges_.curve.assign(2 * std::size_t(lattice.size()), 0);
  before_.assign(edges_.curve.size(), 0);
  is_slot_set_.assign(edges_.curve.size(), 0);
  set_.clear();
  segments_ = 0;
  is_settled_ = false;
  is_first_ = true;
}

/// Where blocks moved, it is trace_stale() that moves the edges: after trace_all(), none are kept.
void IncrementalEdges::start(const BlockMoves& blocks) {
  is_first_ = false;
  if (blocks.any_moved()) {
    std::swap(edges_.curve, before_);
    is_settled_ = false;
  } else if (is_settled_) {
    for (const SetCurve& set : set_) before_[set.slot] = edges_.curve[set.slot];
  } else {
    before_ = edges_.curve;
    is_settled_ = true;
  }
  forget_set();
}

void IncrementalEdges::forget_set() {
  for (const SetCurve& set : set_) is_slot_set_[set.slot] = 0;
  set_.clear();
}

void IncrementalEdges::move(const BlockMoves& blocks) {
  move_blocks(blocks, GridPart::corners(edges_.lattice, 2), 0, before_, edges_.curve);
  const auto hidden = std::count(edges_.curve.begin(), edges_.curve.end(), 0);
  segments_ = static_cast<int>(static_cast<std::ptrdiff_t>(edges_.curve.size()) - hidden);
}

void IncrementalEdges::set_curve(int slot, int number) {
  if (edges_.curve[slot] == number) return;
  if (is_slot_set_[slot] == 0) {
    is_slot_set_[slot] = 1;
    set_.push_back({slot, edges_.curve[slot]});
  }
  segments_ += (number != 0 ? 1 : 0) - (edges_.curve[slot] != 0 ? 1 : 0);
  edges_.curve[slot] = number;
}

/// Rule::edges_by_codes.
void IncrementalEdges::remove(const CellGraph& cells, std::span<const int> stale,
                              std::span<const CornerCode> codes_before) {
  const std::array<int, 4> step = edges_.lattice.step_offsets();
  for (std::size_t i = 0; i < stale.size(); ++i) {
    const CornerCode now = cells.corners[stale[i]];
    auto gone = static_cast<unsigned>(codes_before[i].visible_edges() & ~now.visible_edges());
    for (; gone != 0; gone &= gone - 1) {
      const int slot = edge_end(stale[i], static_cast<Direction>(std::countr_zero(gone)), step).slot;
      if (edges_.curve[slot] == 0) continue;  // seen from the other end
      set_curve(slot, 0);
    }
  }
}

/// Rule::curves_by_codes.
void IncrementalEdges::trace_stale(const CellGraph& cells, const std::vector<PixelMarks>& marks,
                                   std::span<const int> stale, std::span<const CornerCode> codes_before,
                                   const Options& options, const BlockMoves& blocks, RuleSet rules) {
  is_all_ = false;
  if (blocks.any_moved()) move(blocks);
  if (rules.has(Rule::edges_by_codes)) remove(cells, stale, codes_before);
  if (!rules.has(Rule::curves_by_codes)) stale = stale.first(stale.size() / 2);
  trace_contours_through(cells, stale, contours_);
  cut_arcs(cells, contours_, marks, options.spline, options.smoothing, arcs_);
}

void IncrementalEdges::trace_all(const CellGraph& cells, const std::vector<PixelMarks>& marks,
                                 const Options& options) {
  is_all_ = true;
  is_settled_ = false;
  trace_contours(cells, contours_);
  cut_arcs(cells, contours_, marks, options.spline, options.smoothing, arcs_);
}

void IncrementalEdges::fit(const CellGraph& cells, const Options& options, RuleSet rules, Workers& workers) {
  const std::array<int, 4> step = edges_.lattice.step_offsets();
  votes_.start_frame();
  for (Arc& arc : arcs_.list) {
    arc.place = table_.place_of(arcs_.words(arc), arc.kind);
    votes_.see(arc.place, arcs_.corner[arc.first], arc.count, edges_.lattice);
  }
  fitted_shapes_ = table_.fit_added(options, workers);
  if (is_all_) {
    std::fill(edges_.curve.begin(), edges_.curve.end(), 0);
    segments_ = 0;
    for (const Arc& arc : arcs_.list) {
      for_each_edge(arcs_, arc, table_, step, [&](int slot, int number) { edges_.curve[slot] = number; });
      segments_ += arc.step_count();
    }
  } else {
    for (const Arc& arc : arcs_.list) {
      for_each_edge(arcs_, arc, table_, step, [&](int slot, int number) { set_curve(slot, number); });
    }
  }
  join(cells, rules);
  // Frames like noise have more shapes of their own.
  if (is_first_) {
    place_limit_ = std::max(static_cast<std::size_t>(most_places(edges_.lattice)), 2 * table_.places());
  }
}

/// Rule::joints_by_curves: all T-junctions that contours end at or go through.
void IncrementalEdges::join(const CellGraph& cells, RuleSet rules) {
  const auto join_one = [&](int corner) { return join_at(corner, cells, edges_, table_); };
  if (is_all_) {
    for_each_joint(contours_, cells, [&](int corner) {
      const JoinedEdge joined = join_one(corner);
      edges_.curve[joined.slot] = joined.curve;
    });
    return;
  }
  const auto join_and_tell = [&](int corner) {
    const JoinedEdge joined = join_one(corner);
    set_curve(joined.slot, joined.curve);
  };
  if (!rules.has(Rule::joints_by_curves)) return for_each_joint(contours_, cells, join_and_tell);
  for (const int corner : contours_.corner) {
    if (cells.is_t_junction(corner)) join_and_tell(corner);
  }
}

std::size_t IncrementalEdges::memory_bytes() const {
  return table_.memory_bytes() + edges_.memory_bytes() + held_bytes(before_, set_, is_slot_set_) +
         contours_.memory_bytes() + arcs_.memory_bytes() + votes_.memory_bytes();
}

}  // namespace depixel
