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
  /// Forgets where shapes were; to be called when curves get new numbers or the frame's size changes.
  void clear() { places_.clear(); }

  /// Starts a frame: moves of the one before are forgotten.
  void start_frame();

  /// To be called for each arc. The first of its shape in a frame votes.
  /// \param curve   number of its first curve, which tells its shape.
  /// \param corner  its first.
  void see(int curve, int corner, int nodes, const Lattice& lattice) {
    if (nodes < kFewestNodes) return;
    if (curve >= static_cast<int>(places_.size())) make_room(curve);
    Place& place = places_[curve];
    if (place.frame == frame_) return;
    if (place.frame + 1 == frame_ && place.corner != corner) vote(place.corner, corner, nodes, lattice);
    place = {corner, frame_};
  }

  /// The moves with most votes, each of several times more nodes than could be chance; most first.
  const std::vector<glm::ivec2>& most_voted();

  std::size_t memory_bytes() const { return held_bytes(places_, votes_, chosen_); }

 private:
  /// Shorter arcs are found everywhere.
  static constexpr int kFewestNodes = 6;

  struct Place {
    int corner = 0;
    unsigned frame = 0;
  };
  struct Vote {
    glm::ivec2 move;
    int nodes;
  };
  void make_room(int curve);
  void vote(int before, int now, int nodes, const Lattice& lattice);

  std::vector<Place> places_;  ///< by curve: where the first arc of the shape was, and when
  std::vector<Vote> votes_;
  std::vector<glm::ivec2> chosen_;
  unsigned frame_ = 1;
};

}  // namespace depixel
