#include "libdepixel/incremental/move_votes.hpp"

#include <algorithm>

namespace depixel {
namespace {

/// Different moves that are counted in a frame; more are noise.
constexpr std::size_t kMostVotes = 256;
constexpr std::size_t kMostVoted = 3;
constexpr int kFewestVotes = 24;  ///< nodes

}  // namespace

void MoveVotes::start_frame() {
  ++frame_;
  votes_.clear();
}

void MoveVotes::make_room(int place) {
  const std::size_t wanted = static_cast<std::size_t>(place) + 1;
  if (wanted > seen_.capacity()) seen_.reserve(wanted + wanted / 4);
  seen_.resize(wanted);
}

void MoveVotes::vote(int before, int now, int nodes, const Lattice& lattice) {
  const glm::ivec2 move = lattice.corner_position(now) - lattice.corner_position(before);
  const auto known =
      std::find_if(votes_.begin(), votes_.end(), [&](const Vote& v) { return v.move == move; });
  if (known != votes_.end()) {
    known->nodes += nodes;
  } else if (votes_.size() < kMostVotes) {
    votes_.push_back({move, nodes});
  }
}

const std::vector<glm::ivec2>& MoveVotes::most_voted() {
  const auto more = [](const Vote& a, const Vote& b) { return a.nodes > b.nodes; };
  const std::size_t count = std::min(votes_.size(), kMostVoted);
  std::partial_sort(votes_.begin(), votes_.begin() + static_cast<std::ptrdiff_t>(count), votes_.end(), more);
  chosen_.clear();
  for (std::size_t i = 0; i < count && votes_[i].nodes >= kFewestVotes; ++i)
    chosen_.push_back(votes_[i].move);
  return chosen_;
}

}  // namespace depixel
