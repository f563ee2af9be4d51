#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/common/picture.hpp"

namespace depixel::bench {

/// A shape drawn small, as an upscaler gets it, and 16 times as large, as it should come out.
struct TruthCase {
  static constexpr int kScale = 16;

  std::string name, kind;
  std::vector<Rgba> palette;  ///< the first is the background
  Picture small;
  Picture anti_aliased;  ///< kScale times the small one
  Picture labels;        ///< the same without anti-aliasing: palette colours only
};

struct Score {
  double iou = 0;  ///< mean intersection over union of the regions of each colour but the background
  double mae = 0;  ///< mean absolute difference of red, green and blue, 0..255
};

/// Reads a folder of truth cases: cases.json and, for each, NAME.lr.png, NAME.hr16.png and NAME.lab16.png.
/// Throws std::runtime_error where something is missing or does not fit.
std::vector<TruthCase> read_truth(const std::filesystem::path& folder);

/// Scores a picture of a case.
/// \param scale  of the picture to the small one; divides TruthCase::kScale.
Score score(const TruthCase& truth, const Picture& picture, int scale);

}  // namespace depixel::bench
