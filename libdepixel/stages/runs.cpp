#include "libdepixel/stages/runs.hpp"

#include <array>

namespace depixel {

void Runs::find(std::span<const ShapeWord> words, bool is_closed) {
  list_.clear();
  is_closed_ = is_closed;
  const int nodes = static_cast<int>(words.size()), steps = is_closed ? nodes : nodes - 1;
  int start = 0;
  if (is_closed) {
    while (words[start].heading() == words[start == 0 ? nodes - 1 : start - 1].heading()) {
      ++start;  // it turns somewhere
    }
  }
  const auto turn = [](int from, int to) {
    constexpr std::array<int, 4> kTurns{0, 1, 0, -1};
    return kTurns[(to - from) & 3];
  };
  int heading = words[start].heading(), first = start, length = 0, turn_in = 0;
  const auto finish = [&](int turn_out) {
    list_.push_back({first, length, static_cast<Direction>(heading), turn_in, turn_out});
    turn_in = turn_out;
  };
  for (int k = 0, node = start; k < steps; ++k) {
    if (length > 0 && words[node].heading() != heading) {
      finish(turn(heading, words[node].heading()));
      heading = words[node].heading();
      first = node;
      length = 0;
    }
    ++length;
    if (++node == nodes) node = 0;
  }
  finish(is_closed ? turn(heading, list_.empty() ? heading : list_.front().heading) : 0);
  if (is_closed) list_.front().turn_in = list_.back().turn_out;
}

}  // namespace depixel
