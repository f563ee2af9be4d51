#include "bench/common/inputs.hpp"

#include <fmt/core.h>

#include <map>
#include <set>
#include <stdexcept>

namespace depixel::bench {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> list_folder(const fs::path& folder, int every) {
  std::map<fs::path, std::set<fs::path>> pictures;  // by the folder they lie in
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".png") pictures[entry.path().parent_path()].insert(entry.path());
  }
  std::vector<fs::path> chosen;
  for (const auto& [parent, files] : pictures) {
    int index = 0;
    for (const fs::path& file : files) {
      if (index++ % every == 0) chosen.push_back(file);
    }
  }
  return chosen;
}

}  // namespace

fs::path shipped_data() {
  return DEPIXEL_BENCH_DATA;
}

std::vector<fs::path> list_pictures(const std::vector<fs::path>& paths, int every) {
  std::vector<fs::path> files;
  for (const fs::path& path : paths) {
    if (!fs::exists(path)) throw std::runtime_error(fmt::format("{} does not exist.", path.string()));
    if (fs::is_directory(path)) {
      const auto found = list_folder(path, every);
      files.insert(files.end(), found.begin(), found.end());
    } else {
      files.push_back(path);
    }
  }
  if (files.empty()) throw std::runtime_error("There is no PNG file in the given folders.");
  return files;
}

}  // namespace depixel::bench
