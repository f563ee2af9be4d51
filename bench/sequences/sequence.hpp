#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/common/picture.hpp"

namespace depixel::bench {

/// The files of a sequence, in the order of their numbers.
struct SequenceFiles {
  std::filesystem::path folder;
  std::vector<std::filesystem::path> frames;
};

/// Frames that follow each other: two or more, all of one size.
struct Sequence {
  std::string name;  ///< the folder's
  std::vector<Picture> frames;

  int width() const { return frames.front().width(); }
  int height() const { return frames.front().height(); }
};

/// Finds the sequences in folders: one in every folder, at any depth, that holds PNG files itself.
/// \param every  take each n-th frame; what moves then moves faster.
/// Throws std::runtime_error where a folder does not exist or nothing is found.
std::vector<SequenceFiles> find_sequences(const std::vector<std::filesystem::path>& folders, int every);

/// Reads all frames of a sequence. Throws std::runtime_error where they are too few, or differ in size.
Sequence read_sequence(const SequenceFiles& files);

}  // namespace depixel::bench
