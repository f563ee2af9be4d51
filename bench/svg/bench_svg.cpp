/// Sizes of SVG files with simplified curves against exact ones, and what that changes in the picture.

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "bench/common/inputs.hpp"
#include "bench/common/picture.hpp"
#include "bench/common/program.hpp"
#include "bench/svg/outline_raster.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"
#include "libdepixel/svg/simplify.hpp"
#include "libdepixel/svg/svg_writer.hpp"

namespace depixel::bench {
namespace {

constexpr double kWantedMean = 0.3;

struct Settings {
  std::vector<std::filesystem::path> inputs;
  int every = 1;
  double tolerance_px = kSvgTolerance;
};

/// Of one picture or of many.
struct Sizes {
  std::string name;
  std::size_t exact_bytes = 0, bytes = 0;
  int pictures = 0;
  double ms = 0;          ///< of the processor, to write all of them, simplified
  double pixels = 0;      ///< at 8x
  double difference = 0;  ///< the sum of theirs

  double ratio() const { return static_cast<double>(bytes) / static_cast<double>(exact_bytes); }
  double mean() const { return difference / pixels; }
  void add(const Sizes& other) {
    exact_bytes += other.exact_bytes;
    bytes += other.bytes;
    pictures += other.pictures;
    ms += other.ms;
    difference += other.difference;
    pixels += other.pixels;
  }
};

Sizes measure(const std::filesystem::path& file, double tolerance_px) {
  const Picture picture = read_picture(file);
  Vectorizer vectorizer;
  const PlanarMap& map = vectorizer.vectorize(picture.view(), Options{});
  Sizes sizes{file.string(), write_svg(map, vectorizer.graph(), 0).size()};
  const std::clock_t start = std::clock();
  sizes.bytes = write_svg(map, vectorizer.graph(), tolerance_px).size();
  sizes.ms = 1e3 * double(std::clock() - start) / CLOCKS_PER_SEC;
  sizes.pictures = 1;
  Components components;
  label_components(vectorizer.graph(), components);
  Outlines outlines;
  trace_outlines(map, vectorizer.graph(), components, outlines);
  const Picture exact = draw_outlines(map, components, outlines);
  simplify_outlines(map, tolerance_px, SvgGrid::within(tolerance_px), outlines);
  const Picture simplified = draw_outlines(map, components, outlines);
  sizes.pixels = double(exact.width()) * exact.height();
  sizes.difference = mean_difference(exact, simplified) * sizes.pixels;
  return sizes;
}

void print(const Sizes& sizes, const Sizes* worst) {
  constexpr std::size_t kNameColumns = 40;
  std::string name = sizes.name;
  if (name.size() > kNameColumns) name = "..." + name.substr(name.size() - kNameColumns + 3);
  fmt::print("{:<40} {:>11} {:>11} {:>7.3f} {:>6.1f} {:>8.3f}", name, sizes.exact_bytes, sizes.bytes,
             sizes.ratio(), sizes.ms / sizes.pictures, sizes.mean());
  if (worst != nullptr) {
    fmt::print(" {:>8.3f} {}", worst->mean(), std::filesystem::path(worst->name).filename().string());
  }
  fmt::print("\n");
  std::fflush(stdout);
}

void run(const Settings& settings) {
  fmt::print("{:<40} {:>11} {:>11} {:>7} {:>6} {:>8} {:>8}\n", "input, bytes", "exact", "simplified", "ratio",
             "ms", "mean", "worst");
  Sizes all{"all"}, worst_of_all;
  for (const auto& input : settings.inputs) {
    Sizes sum{input.string()}, worst;
    for (const auto& file : list_pictures({input}, settings.every)) {
      const Sizes sizes = measure(file, settings.tolerance_px);
      sum.add(sizes);
      if (worst.pixels == 0 || sizes.mean() > worst.mean()) worst = sizes;
    }
    print(sum, &worst);
    all.add(sum);
    if (worst_of_all.pixels == 0 || worst.mean() > worst_of_all.mean()) worst_of_all = worst;
  }
  print(all, &worst_of_all);
  fmt::print("mean difference at {}x {:.3f} of 255, wanted at most {}: {}\n", kOutlineScale, all.mean(),
             kWantedMean, all.mean() <= kWantedMean ? "reached" : "missed");
}

void add_options(CLI::App& app, Settings& settings) {
  app.description(
      "Bytes of SVG files, exact and simplified, the time to write one of the latter, and the mean "
      "difference of "
      "their pictures at 8x, of 255.");
  app.add_option("INPUT", settings.inputs, "pictures, and folders of them; a line is printed for each")
      ->required();
  app.add_option("--every", settings.every, "take each n-th picture of a folder")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--svg-tolerance", settings.tolerance_px, "how far curves may stray, in source pixels")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

}  // namespace
}  // namespace depixel::bench

int main(int argc, char** argv) {
  using namespace depixel::bench;
  return run_program<Settings>("bench_svg", argc, argv, add_options, run);
}
