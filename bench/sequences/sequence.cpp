#include "bench/sequences/sequence.hpp"

#include <fmt/core.h>

#include <map>
#include <set>
#include <stdexcept>

#include "apps/common/natural_order.hpp"

namespace depixel::bench {
namespace {

namespace fs = std::filesystem;

struct NaturalOrder {
  bool operator()(const fs::path& a, const fs::path& b) const {
    return naturally_before(a.string(), b.string());
  }
};

std::vector<fs::path> take_each(const std::set<fs::path, NaturalOrder>& files, int every) {
  std::vector<fs::path> taken;
  int index = 0;
  for (const fs::path& file : files) {
    if (index++ % every == 0) taken.push_back(file);
  }
  return taken;
}

/// The last part of a folder's path, also where the path ends in a dot or a slash.
std::string name_of(const fs::path& folder) {
  return fs::absolute(folder / ".").lexically_normal().parent_path().filename().string();
}

}  // namespace

std::vector<SequenceFiles> find_sequences(const std::vector<fs::path>& folders, int every) {
  std::vector<SequenceFiles> sequences;
  for (const fs::path& folder : folders) {
    if (!fs::is_directory(folder)) {
      throw std::runtime_error(fmt::format("{} is not a folder.", folder.string()));
    }
    std::map<fs::path, std::set<fs::path, NaturalOrder>, NaturalOrder> found;  // by the folder they lie in
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.path().extension() == ".png") found[entry.path().parent_path()].insert(entry.path());
    }
    for (const auto& [parent, files] : found) sequences.push_back({parent, take_each(files, every)});
  }
  if (sequences.empty()) throw std::runtime_error("There is no PNG file in the given folders.");
  return sequences;
}

Sequence read_sequence(const SequenceFiles& files) {
  Sequence sequence{name_of(files.folder), {}};
  for (const fs::path& file : files.frames) {
    const Picture& frame = sequence.frames.emplace_back(read_picture(file));
    if (frame.width() != sequence.width() || frame.height() != sequence.height()) {
      throw std::runtime_error(fmt::format(
          "{} holds frames of {} x {} and of {} x {} pixels, and those of a sequence have one size.",
          files.folder.string(), sequence.width(), sequence.height(), frame.width(), frame.height()));
    }
  }
  if (sequence.frames.size() < 2) {
    throw std::runtime_error(
        fmt::format("{} holds a single frame, and a sequence has two or more.", files.folder.string()));
  }
  return sequence;
}

}  // namespace depixel::bench
