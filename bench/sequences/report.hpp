#pragma once

#include <span>

#include "bench/sequences/sequence_timing.hpp"
#include "bench/sequences/verdicts.hpp"

namespace depixel::bench {

/// The head of the table, and its row of a sequence, with the times of softfilters and of repeated frames
/// below it.
void print_header();
void print_timing(const SequenceTiming& timing);

void print_threads(const ThreadTiming& timing);

/// A line for each figure, and how many were reached.
void print_verdicts(std::span<const Verdict> verdicts);

/// All sequences as one JSON object on one line.
void print_json(std::span<const SequenceTiming> timings);

}  // namespace depixel::bench
