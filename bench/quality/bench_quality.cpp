/// Scores the pictures of nearest, hqx, xbr, xBRZ and depixel against true shapes, against the pixels they
/// are made from, and against themselves when those move.

#include <fmt/core.h>

#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "bench/common/inputs.hpp"
#include "bench/common/program.hpp"
#include "bench/quality/consistency.hpp"
#include "bench/quality/truth.hpp"
#include "bench/quality/upscalers.hpp"

namespace depixel::bench {
namespace {

constexpr double kWantedIou = 0.900, kWantedMae = 2.40;

struct Settings {
  std::filesystem::path truth = shipped_data() / "truth";
  std::vector<std::filesystem::path> samples{shipped_data() / "frames", shipped_data() / "sprites"};
  int scale = 4;
  bool json = false;
  bool cases = false;
  std::filesystem::path write;
  std::string only;  ///< a part of the names of the methods to run
};

struct CaseResult {
  const TruthCase* truth;
  Score score;
  int centres_lost = 0;
};

/// Means over cases, and the sum of lost centres.
struct Summary {
  Score mean;
  int centres_lost = 0, cases = 0;

  void add(const CaseResult& result) {
    ++cases;
    mean.iou += (result.score.iou - mean.iou) / cases;
    mean.mae += (result.score.mae - mean.mae) / cases;
    centres_lost += result.centres_lost;
  }
};

/// Means over sample pictures.
struct Consistency {
  double reduction = 0;  ///< by reduction_error()
  double shift = 0;      ///< by shift_error(), over pictures that are large enough
};

/// What all methods are to draw.
struct Material {
  std::vector<TruthCase> cases;
  std::vector<SamplePicture> samples;
};

struct MethodResult {
  Upscaler upscaler;
  std::vector<CaseResult> cases;  ///< empty where the method is missing
  Summary all;
  Consistency consistency;
};

Consistency measure_consistency(const Upscaler& upscaler, const std::vector<SamplePicture>& samples,
                                int scale) {
  Consistency mean;
  int count = 0, count_large = 0;
  for (const SamplePicture& sample : samples) {
    mean.reduction += (reduction_error(upscaler, sample.picture, scale) - mean.reduction) / ++count;
    if (!has_middle(sample.picture)) continue;
    mean.shift += (shift_error(upscaler, sample.picture, scale) - mean.shift) / ++count_large;
  }
  return mean;
}

MethodResult run_method(const Upscaler& upscaler, const Material& material, const Settings& settings) {
  MethodResult result{upscaler, {}, {}, {}};
  if (!upscaler.missing.empty()) return result;
  result.consistency = measure_consistency(upscaler, material.samples, settings.scale);
  for (const TruthCase& truth : material.cases) {
    const Picture picture = upscaler.enlarge(truth.small, settings.scale);
    if (upscaler.is_default && !settings.write.empty())
      write_png(picture, settings.write / (truth.name + ".png"));
    result.cases.push_back(
        {&truth, score(truth, picture, settings.scale), upscaler.count_lost_centres(truth.small)});
    result.all.add(result.cases.back());
  }
  return result;
}

void print_row(std::string_view name, const Summary& summary, std::string_view note) {
  fmt::print("{:<28} {:>7.4f} {:>7.3f} {:>8} {}\n", name, summary.mean.iou, summary.mean.mae,
             summary.centres_lost, note);
}

void print_header(std::string_view title, std::string_view more = "") {
  fmt::print("{:<28} {:>7} {:>7} {:>8}{}\n", title, "IoU", "MAE", "lost", more);
}

void print_table(const std::vector<MethodResult>& results, const Settings& settings) {
  print_header(fmt::format("method, {}x", settings.scale), "  reduced flicker");
  for (const MethodResult& result : results) {
    if (!result.upscaler.missing.empty()) {
      fmt::print("{:<28} {}\n", result.upscaler.name, result.upscaler.missing);
    } else {
      print_row(result.upscaler.name, result.all,
                fmt::format("{:>8.3f} {:>7.5f} {}", result.consistency.reduction, result.consistency.shift,
                            result.upscaler.is_default ? "<- default" : ""));
    }
  }
  fmt::print(
      "wanted of the default at 4x: IoU at least {:.3f}, MAE at most {:.2f}, no centre lost, no flicker\n",
      kWantedIou, kWantedMae);
}

void print_cases(const MethodResult& result) {
  std::map<std::string, Summary> kinds;
  fmt::print("\n");
  print_header("case");
  for (const CaseResult& found : result.cases) {
    Summary one;
    one.add(found);
    kinds[found.truth->kind].add(found);
    print_row(found.truth->name, one, found.truth->kind);
  }
  fmt::print("\n");
  print_header("kind");
  for (const auto& [kind, summary] : kinds) print_row(kind, summary, fmt::format("n={}", summary.cases));
}

void print_json(const std::vector<MethodResult>& results, const Settings& settings) {
  using Json = nlohmann::ordered_json;
  Json methods = Json::array();
  for (const MethodResult& result : results) {
    Json method{{"name", result.upscaler.name}, {"default", result.upscaler.is_default}};
    if (!result.upscaler.missing.empty()) {
      method["missing"] = result.upscaler.missing;
    } else {
      method["iou"] = result.all.mean.iou;
      method["mae"] = result.all.mean.mae;
      method["centres_lost"] = result.all.centres_lost;
      method["reduction_error"] = result.consistency.reduction;
      method["flicker"] = result.consistency.shift;
      for (const CaseResult& found : result.cases) {
        method["cases"].push_back({{"name", found.truth->name},
                                   {"kind", found.truth->kind},
                                   {"iou", found.score.iou},
                                   {"mae", found.score.mae},
                                   {"centres_lost", found.centres_lost}});
      }
    }
    methods.push_back(std::move(method));
  }
  fmt::print("{}\n", Json{{"scale", settings.scale}, {"methods", std::move(methods)}}.dump(2));
}

void run(const Settings& settings) {
  const Material material{read_truth(settings.truth), read_samples(list_pictures(settings.samples, 1))};
  if (!settings.write.empty()) std::filesystem::create_directories(settings.write);
  std::vector<MethodResult> results;
  for (const Upscaler& upscaler : all_upscalers()) {
    const bool chosen = upscaler.name.find(settings.only) != std::string::npos;
    if (chosen) results.push_back(run_method(upscaler, material, settings));
  }
  if (settings.json) {
    print_json(results, settings);
    return;
  }
  print_table(results, settings);
  for (const MethodResult& result : results) {
    if (settings.cases && result.upscaler.is_default) print_cases(result);
  }
}

void add_options(CLI::App& app, Settings& settings) {
  app.description(
      "Scores upscalers against true shapes: mean intersection over union of the regions of each colour "
      "(IoU), mean absolute error of red, green and blue (MAE), and pixels that lose their colour at their "
      "centre. Of sample pictures: mean absolute error of what is drawn, reduced to the size of the input, "
      "to the "
      "input (reduced), and to what is drawn of the same picture shifted by one pixel (flicker).");
  app.add_option("TRUTH", settings.truth, "folder of truth cases")->capture_default_str();
  app.add_option("--samples", settings.samples, "pictures, and folders of such, to measure consistency with");
  app.add_option("--scale", settings.scale, "output pixels to a source pixel")
      ->check(CLI::IsMember({2, 4, 8, 16}))
      ->capture_default_str();
  app.add_option("--only", settings.only,
                 "run just the methods that have this in their names, such as energy");
  app.add_flag("--json", settings.json, "print one JSON object");
  app.add_flag("--cases", settings.cases,
               "print each case and the mean of each kind for the default settings");
  app.add_option("--write", settings.write, "folder to write the default settings' pictures to");
}

}  // namespace
}  // namespace depixel::bench

int main(int argc, char** argv) {
  using namespace depixel::bench;
  return run_program<Settings>("bench_quality", argc, argv, add_options, run);
}
