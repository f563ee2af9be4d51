#include "libdepixel/core/options.hpp"

#include <array>

namespace depixel {
namespace {

constexpr std::array<std::string_view, 2> kSimilarityNames{"exact", "merge"};
constexpr std::array<std::string_view, 2> kDitherNames{"keep", "blend"};
constexpr std::array<std::string_view, 3> kSplineNames{"adaptive", "approximate", "interpolate"};
constexpr std::array<std::string_view, 3> kSmoothingNames{"energy", "average", "none"};
constexpr std::array<std::string_view, 2> kCornersNames{"round", "sharp"};
constexpr std::array<std::string_view, 4> kShadingNames{"none", "gradient", "discs", "blur"};
constexpr std::array<std::string_view, 2> kCurveRuleNames{"valence", "continuity"};
constexpr std::array<std::string_view, 3> kBorderNames{"fixed", "repeat", "mirror"};

template <auto Member>
ChoiceOption choice(std::span<const std::string_view> names) {
  using Enum = std::remove_cvref_t<decltype(Options{}.*Member)>;
  return {names, [](const Options& o) { return static_cast<int>(o.*Member); },
          [](Options& o, int value) { o.*Member = static_cast<Enum>(value); }};
}

constexpr double kMaxWeight = 1000.0;
constexpr double kMaxLuma = 255.0;
constexpr double kMaxDistance = 100.0;
constexpr int kMaxThreads = 256;

}  // namespace

std::span<const OptionInfo> option_table() {
  static const std::array<OptionInfo, 17> kTable{{
      {"similarity", "Pixels belong together when their colours are equal (exact) or alike (merge)",
       choice<&Options::similarity>(kSimilarityNames)},
      {"merge-luma", "Levels of brightness (0 to 255) that pixels may differ by and still be alike",
       NumberOption{&Options::merge_luma, 0.0, kMaxLuma}},
      {"connect-lines", "Join lines of similar colour across diagonals",
       SwitchOption{&Options::connect_lines}},
      {"dither", "Areas that are checkerboards of two colours are kept, or become the colour between (blend)",
       choice<&Options::dither>(kDitherNames)},
      {"spline", "How splines follow the cell graph", choice<&Options::spline>(kSplineNames)},
      {"smoothing", "How staircases are removed", choice<&Options::smoothing>(kSmoothingNames)},
      {"corners",
       "With smoothing by energy: whether splines go round corners between long straight arms, or are broken "
       "there",
       choice<&Options::corners>(kCornersNames)},
      {"curve-rule",
       "How far curves go for their vote: through pixels with two links (valence), or straight on at "
       "junctions of lines too (continuity)",
       choice<&Options::curve_rule>(kCurveRuleNames)},
      {"curve-weight", "Weight of the longer curve's vote at a crossing",
       NumberOption{&Options::curve_weight, 0.0, kMaxWeight}},
      {"sparse-weight", "Weight of the sparser component's vote at a crossing",
       NumberOption{&Options::sparse_weight, 0.0, kMaxWeight}},
      {"island-weight", "Vote against cutting off a single pixel at a crossing",
       NumberOption{&Options::island_weight, 0.0, kMaxWeight}},
      {"border",
       "How the picture goes on beyond its border: contours end there (fixed), or go on through pixels that "
       "repeat or mirror those inside",
       choice<&Options::border>(kBorderNames)},
      {"text-safe",
       "With smoothing by energy: leave small text and thin lines on plain ground as they are in the cell "
       "graph",
       SwitchOption{&Options::text_safe}},
      {"shading", "How the colours of pixels that merged or were connected run inside their component",
       choice<&Options::shading>(kShadingNames)},
      {"soft-contours", "Distance of colours (0 to 100) up to which a contour between them is drawn soft",
       NumberOption{&Options::soft_contours, 0.0, kMaxDistance}},
      {"linear-light", "Blend colours in linear light at edges", SwitchOption{&Options::linear_light}},
      {"threads", "Threads to vectorize and draw with", CountOption{&Options::threads, 1, kMaxThreads}},
  }};
  return kTable;
}

}  // namespace depixel
