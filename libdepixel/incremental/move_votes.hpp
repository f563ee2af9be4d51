#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "libdepixel/core/lattice.hpp"
#include "libdepixel/core/memory.hpp"

namespace depixel {

/// Guesses how parts of a picture moved from one frame to the next: shapes that were found again vote for the
/// way from where they were.
class MoveVotes {
 public:
  /// Forgets where shapes were; to be called when shapes get new places or the frame's size changes.
  void clear() { seen_.clear(); }

  /// Starts a frame: moves of the one before are forgotten.
  void start_frame();

  /// To be called for each arc. The first of its shape in a frame votes.
  /// \param place   SplineTable::place_of() its shape. \param corner  its first.
  void see(int place, int corner, int nodes, const Lattice& lattice) {
    if (nodes < kFewestNodes) return;
    if (place >= static_cast<int>(seen_.size())) make_room(place);
    Seen& before = seen_[place];
    if (before.frame == frame_) return;
    if (before.frame + 1 == frame_ && before.corner != corner) vote(before.corner, corner, nodes, lattice);
    before = {corner, frame_};
  }

  /// The moves with most votes, each of several times more nodes than could be chance; most first.
  const std::vector<glm::ivec2>& most_voted();

  std::size_t memory_bytes() const { return held_bytes(seen_, votes_, chosen_); }

 private:
  /// Shorter arcs are found everywhere.
  static constexpr int kFewestNodes = 6;

  struct Seen {
    int corner = 0;
    unsigned frame = 0;
  };
  struct Vote {
    glm::ivec2 move;
    int nodes;
  };
  void make_room(int place);
  void vote(int before, int now, int nodes, const Lattice& lattice);

  std::vector<Seen> seen_;  ///< by place: where the first arc of the shape was, and when
  std::vector<Vote> votes_;
  std::vector<glm::ivec2> chosen_;
  unsigned frame_ = 1;
};

}  // namespace depixel
