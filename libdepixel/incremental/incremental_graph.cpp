#include "libdepixel/incremental/incremental_graph.hpp"

#include <algorithm>
#include <bit>

#include "libdepixel/incremental/byte_rows.hpp"

namespace depixel {
namespace {

/// With more of the blocks than this part stale, all are taken to be: that is simpler, and no slower.
constexpr double kMostStaleBlocks = 0.7;

/// With more blocks' links than this part of all that differ, the graph is new.
constexpr double kMostChanged = 0.1;

/// What depends on a link lies at most so many pixels from it.
constexpr int kLinkReach = 2;

/// Neighbours of a pixel in the directions that lead, at least partly, along a step; see
/// SimilarityGraph::neighbours().
unsigned neighbours_along(glm::ivec2 step) {
  constexpr std::array<glm::ivec2, 8> kNeighbours{
      {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};
  unsigned mask = 0;
  for (std::size_t i = 0; i < kNeighbours.size(); ++i) {
    const glm::ivec2 along = kNeighbours[i] * step;
    if (along.x > 0 || along.y > 0) mask |= 1U << i;
  }
  return mask;
}

}  // namespace

void IncrementalGraph::reset(const Lattice& lattice) {
  graph_.lattice = {};
  graph_.resize(lattice);
  frozen_.lattice = lattice;
  frozen_.links.assign(lattice.size(), 0);
  crossings_.neighbours.assign(lattice.size() + sizeof(Byte16), 0);
  moved_.assign(crossings_.neighbours.size(), 0);
}

void IncrementalGraph::update(const FrameView& frame, const Options& options, const BlockMoves& blocks,
                              RuleSet rules) {
  const CrossingVotes votes = CrossingVotes::of(options);
  is_new_ = false;
  if (options.has_whole_components()) {
    stale_.reset(blocks.grid());
    stale_.add_all();
    stale_.find_runs();
    build_similarity_graph(frame, LinkCriteria::of(options), graph_);
    resolved_crossings_ = resolve_crossings(graph_, votes, crossings_);
    return;
  }
  if (blocks.any_moved()) move(blocks);
  find_near(blocks, rules);
  take_changed(frame, blocks);
  if (rules.has(Rule::links_by_pixels) || !blocks.is_known()) relink();
  near_.has_all() ? resolve_all(votes) : resolve_some(votes, blocks, rules);
}

void IncrementalGraph::move(const BlockMoves& blocks) {
  const GridPart pixels = GridPart::pixels(graph_.lattice);
  for (auto* bytes : {&frozen_.links, &graph_.links, &crossings_.neighbours}) {
    std::copy(bytes->begin(), bytes->end(), moved_.begin());
    move_blocks(blocks, pixels, std::uint8_t{0}, moved_, *bytes);
  }
}

/// Blocks beside one with changed pixels, and blocks at a seam: all others moved together with those beside
/// them, in which nothing changed. A narrow block, at the frame's border, does not hold all that lies near a
/// seam there.
void IncrementalGraph::find_near(const BlockMoves& blocks, RuleSet rules) {
  const BlockGrid& grid = blocks.grid();
  const auto is_narrow = [&](const BlockMoves::Seam& seam) {
    return grid.end_x(seam.column) - grid.first_x(seam.column) < BlockGrid::kSide ||
           grid.end_y(seam.row) - grid.first_y(seam.row) < BlockGrid::kSide;
  };
  const bool has_seams = rules.has(Rule::links_by_seams);
  growing_ = blocks.changed();
  for (const BlockMoves::Seam& seam : blocks.seams()) {
    if (has_seams && is_narrow(seam)) growing_.add(seam.column, seam.row);
  }
  near_.set_grown(growing_);
  for (const BlockMoves::Seam& seam : blocks.seams()) {
    if (has_seams) near_.add(seam.column, seam.row);
  }
  if (near_.count() > kMostStaleBlocks * grid.columns * grid.rows) near_.add_all();
  near_.find_runs();
}

void IncrementalGraph::take_changed(const FrameView& frame, const BlockMoves& blocks) {
  for (int y = 0; y < frame.height; ++y) {
    if (blocks.any_moved()) {
      take_pixels(frame, y, 0, frame.width, graph_);
    } else {
      for (const BlockSet::Run run : blocks.changed().runs(y)) {
        take_pixels(frame, y, run.from, run.to, graph_);
      }
    }
  }
}

/// Rule::links_by_pixels.
void IncrementalGraph::relink() {
  for (int y = 0; y < graph_.lattice.height(); ++y) {
    for (const BlockSet::Run run : near_.runs(y)) link_exactly(graph_, y, run.from, run.to, frozen_.links);
  }
}

/// Pixels on either side of the seams with a link across and few others: parts of curves. Where neither of
/// two linked pixels is, no curve goes on.
void IncrementalGraph::find_seams(const BlockMoves& blocks, CurveRule curve_rule) {
  seams_.clear();
  const int most_links = CurveWalk::most_links(curve_rule);
  const BlockGrid& grid = blocks.grid();
  for (const auto& [column, row, step] : blocks.seams()) {
    const auto side = [](int step_along, int first, int end) {
      return step_along < 0   ? glm::ivec2(first, first + 1)
             : step_along > 0 ? glm::ivec2(end - 1, end)
                              : glm::ivec2(first, end);
    };
    const glm::ivec2 across = side(step.x, grid.first_x(column), grid.end_x(column));
    const glm::ivec2 down = side(step.y, grid.first_y(row), grid.end_y(row));
    const unsigned mask = neighbours_along(step);
    for (int y = down[0]; y < down[1]; ++y) {
      for (int x = across[0]; x < across[1]; ++x) {
        const int pixel = graph_.lattice.pixel(x, y);
        const std::uint8_t neighbours = frozen_.neighbours(pixel);
        if ((neighbours & mask) != 0 && std::popcount(neighbours) <= most_links) seams_.push_back(pixel);
      }
    }
  }
}

void IncrementalGraph::resolve_all(const CrossingVotes& votes) {
  const std::size_t size = graph_.links.size();
  std::copy_n(graph_.links.begin(), size, moved_.begin());
  graph_.links = frozen_.links;
  resolved_crossings_ = resolve_crossings(graph_, votes, crossings_);
  stale_ = near_;
  std::size_t same = 0;
  for (std::size_t i = 0; i < size; ++i) same += graph_.links[i] == moved_[i] ? 1 : 0;
  is_new_ = is_most(graph_.lattice, kMostChanged, size - same);
}

/// Crossings whose votes may have changed; outside of near blocks, these alone make others stale.
void IncrementalGraph::resolve_some(const CrossingVotes& votes, const BlockMoves& blocks, RuleSet rules) {
  find_seams(blocks, votes.curve_rule);
  const std::vector<int>& crossings =
      stale_crossings_.find(frozen_, near_, seams_, votes.curve_rule, rules, crossings_.neighbours);
  before_.clear();
  for (const int block : crossings) before_.push_back(graph_.links[block]);
  thaw();
  resolve_some_crossings(frozen_, crossings, votes, crossings_, graph_.links);
  stale_ = near_;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    if (graph_.links[crossings[i]] == before_[i] || !rules.has(Rule::codes_by_crossings)) continue;
    stale_.add_around(graph_.lattice.pixel_position(crossings[i]), kLinkReach);
  }
  stale_.find_runs();
  resolved_crossings_ = static_cast<int>(crossings.size());
}

/// Takes over the frozen links of near blocks, but for crossings.
void IncrementalGraph::thaw() {
  const Lattice& lattice = graph_.lattice;
  for (int y = 0; y < lattice.height(); ++y) {
    const std::uint8_t* from_row = frozen_.links.data() + lattice.pixel(0, y);
    std::uint8_t* to_row = graph_.links.data() + lattice.pixel(0, y);
    for (const BlockSet::Run run : near_.runs(y)) {
      for (int x = run.from; x < run.to; ++x) {
        const bool is_crossing = (from_row[x] & kBothDiagonals) == kBothDiagonals;
        to_row[x] = is_crossing ? to_row[x] : from_row[x];
      }
    }
  }
}

}  // namespace depixel
