#include "libdepixel/incremental/block_moves.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <optional>

#include "tests/support/random_sequences.hpp"

namespace depixel::test {
namespace {

/// The graph's pixels of a picture.
SimilarityGraph graph_of(const Picture& picture) {
  SimilarityGraph graph;
  build_similarity_graph(picture.view(), {}, graph);
  return graph;
}

/// A pixel as it is kept; none outside the frame.
std::optional<Rgba> pixel_of(const SimilarityGraph& graph, glm::ivec2 at) {
  const Lattice& lattice = graph.lattice;
  const bool is_inside = at.x >= 0 && at.y >= 0 && at.x < lattice.width() && at.y < lattice.height();
  return is_inside ? std::optional(graph.pixels[lattice.pixel(at.x, at.y)]) : std::nullopt;
}

/// Pixels of a block that are not what a move brings.
int differing(const SimilarityGraph& now, const SimilarityGraph& before, const BlockGrid& grid, int column,
              int row, glm::ivec2 move) {
  int count = 0;
  for (int y = grid.first_y(row); y < grid.end_y(row); ++y) {
    for (int x = grid.first_x(column); x < grid.end_x(column); ++x) {
      count += pixel_of(before, glm::ivec2(x, y) - move) == pixel_of(now, {x, y}) ? 0 : 1;
    }
  }
  return count;
}

std::vector<glm::ivec2> random_moves() {
  const auto number = [] { return *random_int(-9, 10); };
  std::vector<glm::ivec2> moves{{0, 0}};
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i) moves.insert(moves.begin(), {number(), number()});
  return moves;
}

RC_GTEST_PROP(BlockMoves, BlocksHaveAMoveThatLeavesFewPixels, (const Sequence& sequence)) {
  const std::vector<glm::ivec2> moves = random_moves();
  BlockMoves blocks;
  for (std::size_t i = 1; i < sequence.frames.size(); ++i) {
    const Picture &before = sequence.frames[i - 1].picture, &now = sequence.frames[i].picture;
    if (before.width != now.width || before.height != now.height) continue;
    const SimilarityGraph graph = graph_of(now), graph_before = graph_of(before);
    RC_ASSERT(blocks.find_changed_rows(now.view(), graph_before) == (graph.pixels != graph_before.pixels));
    blocks.find(now.view(), graph_before, moves);
    const BlockGrid& grid = blocks.grid();
    int changed_pixels = 0;
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const auto left_by = [&](glm::ivec2 move) {
          return differing(graph, graph_before, grid, column, row, move);
        };
        const int left = left_by(blocks.move(column, row));
        changed_pixels += left;
        RC_ASSERT(blocks.changed().has(column, row) == (left != 0));
        if (!blocks.any_moved()) continue;
        for (const glm::ivec2 move : moves) RC_ASSERT(left_by(move) > left - 4);
        RC_ASSERT(left <= left_by(moves[0]));
      }
    }
    RC_ASSERT(blocks.changed_pixels() == changed_pixels);
  }
}

RC_GTEST_PROP(BlockMoves, SeamsAreWhereMovesDiffer, (const Sequence& sequence)) {
  const std::vector<glm::ivec2> moves = random_moves();
  BlockMoves blocks;
  const Picture &before = sequence.frames.front().picture, &now = sequence.frames.back().picture;
  RC_PRE(before.width == now.width && before.height == now.height);
  const SimilarityGraph graph_before = graph_of(before);
  blocks.find_changed_rows(now.view(), graph_before);
  blocks.find(now.view(), graph_before, moves);
  const BlockGrid& grid = blocks.grid();
  std::size_t seams = 0;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const glm::ivec2 own = blocks.move(column, row);
      for (int y = row - 1; y <= row + 1; ++y) {
        for (int x = column - 1; x <= column + 1; ++x) {
          const bool is_beside = x < 0 || x >= grid.columns, is_above = y < 0 || y >= grid.rows;
          if (is_beside || is_above) {
            seams += (is_beside && own.x != 0) || (is_above && own.y != 0) ? 1 : 0;
          } else {
            seams += blocks.move(x, y) != own ? 1 : 0;
          }
        }
      }
    }
  }
  RC_ASSERT(blocks.seams().size() == seams);
  RC_ASSERT(blocks.any_moved() || seams == 0U);
}

RC_GTEST_PROP(BlockMoves, EntriesMoveWithTheirBlocks, (const Sequence& sequence)) {
  const std::vector<glm::ivec2> moves = random_moves();
  BlockMoves blocks;
  const Picture &before = sequence.frames.front().picture, &now = sequence.frames.back().picture;
  RC_PRE(before.width == now.width && before.height == now.height);
  const SimilarityGraph graph_before = graph_of(before);
  const Lattice& lattice = graph_before.lattice;
  blocks.find_changed_rows(now.view(), graph_before);
  blocks.find(now.view(), graph_before, moves);

  constexpr int kUncovered = -1, kOther = -2;
  std::vector<int> from(2 * std::size_t(lattice.size())), to(from.size(), kOther);
  for (std::size_t i = 0; i < from.size(); ++i) from[i] = static_cast<int>(i);
  move_blocks(blocks, GridPart::corners(lattice, 2), kUncovered, from, to);
  std::vector<int> expected(to.size(), kOther);
  for (int y = 0; y <= lattice.height(); ++y) {
    for (int x = 0; x <= lattice.width(); ++x) {
      const glm::ivec2 move = blocks.move(std::min(x, lattice.width() - 1) / BlockGrid::kSide,
                                          std::min(y, lattice.height() - 1) / BlockGrid::kSide);
      const glm::ivec2 source = glm::ivec2(x, y) - move;
      const bool is_inside =
          source.x >= 0 && source.y >= 0 && source.x <= lattice.width() && source.y <= lattice.height();
      for (const int k : {0, 1}) {
        expected[2 * lattice.corner(x, y) + k] =
            is_inside ? from[2 * lattice.corner(source.x, source.y) + k] : kUncovered;
      }
    }
  }
  RC_ASSERT(to == expected);
}

}  // namespace
}  // namespace depixel::test
