#include "libdepixel/incremental/move_votes.hpp"

#include <gtest/gtest.h>

#include <array>

namespace depixel::test {
namespace {

constexpr Lattice kLattice(100, 60);
constexpr int kNodes = 12;

using Moves = std::vector<glm::ivec2>;

/// Shapes with these numbers at some places.
void see_all(MoveVotes& votes, int first_curve, const Moves& places, glm::ivec2 moved_by,
             int nodes = kNodes) {
  for (const glm::ivec2 place : places) {
    const glm::ivec2 at = place + moved_by;
    votes.see(first_curve++, kLattice.corner(at.x, at.y), nodes, kLattice);
  }
}

const Moves kPlaces{{10, 10}, {30, 12}, {50, 40}, {70, 20}};

TEST(MoveVotes, ShapesThatMovedTogetherTellTheirMove) {
  MoveVotes votes;
  const std::array<glm::ivec2, 3> at{{{0, 0}, {-3, 2}, {1, 2}}};
  const std::array<Moves, 3> expected{{{}, {{-3, 2}}, {{4, 0}}}};
  for (const int frame : {0, 1, 2}) {
    votes.start_frame();
    see_all(votes, 1, kPlaces, at[frame]);
    EXPECT_EQ(votes.most_voted(), expected[frame]);
  }
}

TEST(MoveVotes, TheMoveOfMostNodesComesFirst) {
  MoveVotes votes;
  for (const int frame : {0, 1}) {
    votes.start_frame();
    see_all(votes, 1, kPlaces, {2 * frame, 0});
    see_all(votes, 11, kPlaces, {0, -5 * frame}, 2 * kNodes);
    see_all(votes, 21, kPlaces, {frame, frame}, 3 * kNodes);
    see_all(votes, 31, kPlaces, {9 * frame, frame}, kNodes - 1);
  }
  EXPECT_EQ(votes.most_voted(), (Moves{{1, 1}, {0, -5}, {2, 0}}));
}

TEST(MoveVotes, WhatStaysDoesNotVote) {
  MoveVotes votes;
  for (int frame = 0; frame < 3; ++frame) {
    votes.start_frame();
    see_all(votes, 1, kPlaces, {0, 0});
    EXPECT_TRUE(votes.most_voted().empty());
  }
}

TEST(MoveVotes, FewNodesAreChance) {
  MoveVotes votes;
  for (const int frame : {0, 1}) {
    votes.start_frame();
    see_all(votes, 1, {{10, 10}}, {frame, 0});
    see_all(votes, 2, kPlaces, {0, frame}, 2);
  }
  EXPECT_TRUE(votes.most_voted().empty());
}

TEST(MoveVotes, OnlyTheFirstOfAShapeVotes) {
  MoveVotes votes;
  for (const int frame : {0, 1}) {
    votes.start_frame();
    for (int i = 0; i < 10; ++i) see_all(votes, 1, {{10 + 5 * i, 10}}, {0, frame});
  }
  EXPECT_TRUE(votes.most_voted().empty());
}

TEST(MoveVotes, ShapesThatWereAwayForAFrameDoNotVote) {
  MoveVotes votes;
  votes.start_frame();
  see_all(votes, 1, kPlaces, {0, 0});
  votes.start_frame();
  votes.start_frame();
  see_all(votes, 1, kPlaces, {1, 0});
  EXPECT_TRUE(votes.most_voted().empty());
}

TEST(MoveVotes, ForgetsPlaces) {
  MoveVotes votes;
  votes.start_frame();
  see_all(votes, 1, kPlaces, {0, 0});
  votes.clear();
  votes.start_frame();
  see_all(votes, 1, kPlaces, {1, 0});
  EXPECT_TRUE(votes.most_voted().empty());
}

}  // namespace
}  // namespace depixel::test
