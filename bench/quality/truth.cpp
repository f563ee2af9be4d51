#include "bench/quality/truth.hpp"

#include <fmt/core.h>

#include <cstdlib>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace depixel::bench {
namespace {

/// Index of the palette colour nearest to a colour; of equally near ones, the first.
std::size_t nearest_colour(const std::vector<Rgba>& palette, Rgba colour) {
  std::size_t best = 0;
  int best_distance = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < palette.size(); ++i) {
    const int r = colour.r - palette[i].r, g = colour.g - palette[i].g, b = colour.b - palette[i].b;
    const int distance = r * r + g * g + b * b;
    if (distance < best_distance) {
      best_distance = distance;
      best = i;
    }
  }
  return best;
}

/// Mean absolute difference to the truth, each block of which is averaged to one pixel.
double mean_error(const TruthCase& truth, const Picture& picture, int block) {
  double sum = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      int r = 0, g = 0, b = 0;
      for (int v = y * block; v < (y + 1) * block; ++v) {
        for (int u = x * block; u < (x + 1) * block; ++u) {
          const Rgba wanted = truth.anti_aliased.at(u, v);
          r += wanted.r;
          g += wanted.g;
          b += wanted.b;
        }
      }
      const int n = block * block;
      const Rgba found = picture.at(x, y);
      sum += double(std::abs(n * found.r - r) + std::abs(n * found.g - g) + std::abs(n * found.b - b)) / n;
    }
  }
  return sum / (3.0 * double(picture.pixel_count()));
}

/// Mean intersection over union of the regions nearest to each colour, the truth sampled in the middle of its
/// blocks.
double mean_iou(const TruthCase& truth, const Picture& picture, int block) {
  std::vector<int> both(truth.palette.size()), either(truth.palette.size());
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const std::size_t found = nearest_colour(truth.palette, picture.at(x, y));
      const std::size_t wanted =
          nearest_colour(truth.palette, truth.labels.at(x * block + block / 2, y * block + block / 2));
      ++either[found];
      if (found == wanted) {
        ++both[found];
      } else {
        ++either[wanted];
      }
    }
  }
  double sum = 0;
  int colours = 0;
  for (std::size_t i = 1; i < either.size(); ++i) {
    if (either[i] == 0) continue;
    sum += double(both[i]) / either[i];
    ++colours;
  }
  return colours ? sum / colours : 0;
}

TruthCase read_case(const std::filesystem::path& folder, const nlohmann::json& entry) {
  TruthCase truth;
  truth.name = entry.at("name");
  truth.kind = entry.at("kind");
  for (const auto& c : entry.at("palette")) truth.palette.push_back({c.at(0), c.at(1), c.at(2), 255});
  truth.small = read_picture(folder / (truth.name + ".lr.png"));
  truth.anti_aliased = read_picture(folder / (truth.name + ".hr16.png"));
  truth.labels = read_picture(folder / (truth.name + ".lab16.png"));
  for (const Picture* large : {&truth.anti_aliased, &truth.labels}) {
    if (large->width() != truth.small.width() * TruthCase::kScale ||
        large->height() != truth.small.height() * TruthCase::kScale) {
      throw std::runtime_error(fmt::format("The pictures of truth case {} do not fit together.", truth.name));
    }
  }
  return truth;
}

}  // namespace

std::vector<TruthCase> read_truth(const std::filesystem::path& folder) {
  const auto path = folder / "cases.json";
  std::ifstream file(path);
  if (!file)
    throw std::runtime_error(fmt::format("Cannot read the truth cases: there is no {}.", path.string()));
  std::vector<TruthCase> cases;
  try {
    const auto document = nlohmann::json::parse(file);
    for (const auto& entry : document.at("cases")) cases.push_back(read_case(folder, entry));
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(
        fmt::format("{} is not a list of truth cases: {}.", path.string(), error.what()));
  }
  if (cases.empty()) throw std::runtime_error(fmt::format("There is no truth case in {}.", path.string()));
  return cases;
}

Score score(const TruthCase& truth, const Picture& picture, int scale) {
  if (picture.width() != truth.small.width() * scale || picture.height() != truth.small.height() * scale) {
    throw std::runtime_error(fmt::format("The picture of truth case {} has the wrong size.", truth.name));
  }
  const int block = TruthCase::kScale / scale;
  return {mean_iou(truth, picture, block), mean_error(truth, picture, block)};
}

}  // namespace depixel::bench
