#include "libdepixel/core/light.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace depixel {
namespace {

double decoded(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

struct Tables {
  std::array<std::uint16_t, 256> light;
  std::array<std::uint8_t, kLightLevels + 1> srgb;

  Tables() {
    for (int v = 0; v < 256; ++v)
      light[v] = static_cast<std::uint16_t>(std::lround(decoded(v / 255.0) * kLightLevels));
    int v = 0;
    for (int level = 0; level <= kLightLevels; ++level) {
      while (v < 255 && level - light[v] > light[v + 1] - level) ++v;  // the nearer of the two neighbours
      srgb[level] = static_cast<std::uint8_t>(v);
    }
  }
};

const Tables& tables() {
  static const Tables kTables;
  return kTables;
}

}  // namespace

int to_light(std::uint8_t srgb) {
  return tables().light[srgb];
}

std::uint8_t from_light(int light) {
  return tables().srgb[std::clamp(light, 0, kLightLevels)];
}

}  // namespace depixel
