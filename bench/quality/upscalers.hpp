#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/common/picture.hpp"

namespace depixel::bench {

/// A way to enlarge pictures, as a row of the table.
struct Upscaler {
  std::string name;
  bool is_default = false;   ///< what depixel does when nothing is asked for
  std::string missing = "";  ///< why it cannot be run here; empty where it can
  std::function<Picture(const Picture&, int scale)> enlarge;
  /// How many pixels do not show their own colour at their centre.
  std::function<int(const Picture&)> count_lost_centres;
};

/// Nearest, hqx, xbr and xBRZ, and ours with every smoothing and spline and with other options. The rivals
/// reach scales beyond their own in several steps.
std::vector<Upscaler> all_upscalers();

}  // namespace depixel::bench
