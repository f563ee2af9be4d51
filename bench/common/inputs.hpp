#pragma once

#include <filesystem>
#include <vector>

namespace depixel::bench {

/// The data that the project ships for its tests and benchmarks.
std::filesystem::path shipped_data();

/// Names of the picture files meant by files and folders. Files come as they are given; of a folder and all
/// folders in it, every n-th PNG of each, in order of their names. Throws std::runtime_error where a path
/// does not exist or nothing is found.
std::vector<std::filesystem::path> list_pictures(const std::vector<std::filesystem::path>& paths, int every);

}  // namespace depixel::bench
