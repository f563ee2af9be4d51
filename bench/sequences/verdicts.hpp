#pragma once

#include <string>
#include <vector>

#include "bench/sequences/sequence_timing.hpp"
#include "bench/sequences/thread_timing.hpp"

namespace depixel::bench {

/// A figure of a sequence beside the one that is wanted.
struct Verdict {
  std::string sequence, what;
  double value = 0, wanted = 0;
  bool wants_more = false;  ///< wanted is the least that will do, not the most

  bool is_reached() const { return wants_more ? value >= wanted : value <= wanted; }
};

/// Compares with what is wanted of every sequence, and of those that move like it. How a sequence moves is
/// known by a part of its name.
std::vector<Verdict> judge(const SequenceTiming& timing);

Verdict judge(const std::string& sequence, const ThreadTiming& timing);

}  // namespace depixel::bench
