#include "libdepixel/incremental/move_guess.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/random_pictures.hpp"

namespace depixel::test {
namespace {

/// A frame with noise in two layers: the upper rows, and the others, each moved by its own offset.
Picture layered(glm::ivec2 upper, glm::ivec2 lower) {
  Picture picture(64, 48);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const glm::ivec2 at = glm::ivec2(x, y) - (y < 16 ? upper : lower) + 1000;
      const auto noise = (static_cast<unsigned>(at.x) * 2654435761U) ^ (static_cast<unsigned>(at.y) * 40503U);
      picture.at(x, y) = palette_colour(".#rgb"[(noise * 0x9e3779b1U >> 28) % 5]);
    }
  }
  return picture;
}

std::vector<glm::ivec2> guessed(MoveGuess& guess, const Picture& before, const Picture& now) {
  SimilarityGraph graph;
  build_similarity_graph(before.view(), {}, graph);
  const auto moves = guess.guess(now.view(), graph);
  return {moves.begin(), moves.end()};
}

using Moves = std::vector<glm::ivec2>;

TEST(MoveGuess, FindsShortMovesAlongAnAxis) {
  MoveGuess guess;
  for (const glm::ivec2 move : {glm::ivec2(1, 0), glm::ivec2(-7, 0), glm::ivec2(0, 12), glm::ivec2(0, -3)}) {
    const Moves moves = guessed(guess, layered({}, {}), layered(move, move));
    ASSERT_FALSE(moves.empty());
    EXPECT_EQ(moves.front(), move);
    EXPECT_NE(std::find(moves.begin(), moves.end(), glm::ivec2(0)), moves.end());
  }
}

TEST(MoveGuess, FindsWhatIsRememberedHoweverFar) {
  const glm::ivec2 move(21, -9);
  const Picture before = layered({}, {}), now = layered(move, move);
  MoveGuess guess;
  EXPECT_NE(guessed(guess, before, now).front(), move);
  guess.remember(move);
  EXPECT_EQ(guessed(guess, before, now).front(), move);
}

TEST(MoveGuess, TellsLayersApart) {
  MoveGuess guess;
  EXPECT_EQ(guessed(guess, layered({}, {}), layered({0, 0}, {2, 0})), (Moves{{2, 0}, {0, 0}}));
  guess.remember({1, 0});
  guess.remember({3, 1});
  EXPECT_EQ(guessed(guess, layered({}, {}), layered({1, 0}, {3, 1})), (Moves{{3, 1}, {1, 0}, {0, 0}}));
}

TEST(MoveGuess, StaysWhereLittleChanges) {
  MoveGuess guess;
  guess.remember({1, 0});
  const Picture before = layered({}, {});
  EXPECT_EQ(guessed(guess, before, before), (Moves{{0, 0}}));
  Picture now = before;
  now.at(9, 9) = palette_colour('R');
  EXPECT_EQ(guessed(guess, before, now), (Moves{{0, 0}}));
  EXPECT_EQ(guessed(guess, Picture(3, 9), Picture(3, 9, palette_colour('r'))), (Moves{{0, 0}}))
      << "too narrow";
}

}  // namespace
}  // namespace depixel::test
