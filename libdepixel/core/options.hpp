#pragma once

#include <span>
#include <string_view>
#include <variant>

namespace depixel {

enum class Similarity { exact, merge };
enum class SplineKind { adaptive, approximate, interpolate };
enum class Smoothing { energy, average, none };
enum class DitherKind { keep, blend };
enum class Corners { round, sharp };
/// Of gradient and discs, only vector files tell which it was.
enum class ShadingKind { none, gradient, discs, blur };
enum class CurveRule { valence, continuity };
/// How a picture goes on beyond its border: not at all, by its outermost pixels, or mirrored.
enum class BorderKind { fixed, repeat, mirror };

/// Everything that a user can choose about vectorizing and drawing. The defaults are the best-scoring ones.
struct Options {
  Similarity similarity = Similarity::exact;
  double merge_luma = 5.0;  ///< levels of Y that pixels may differ by and still merge
  bool connect_lines = false;
  DitherKind dither = DitherKind::keep;
  SplineKind spline = SplineKind::interpolate;
  Smoothing smoothing = Smoothing::energy;
  Corners corners = Corners::sharp;
  CurveRule curve_rule = CurveRule::valence;
  double curve_weight = 1.0;
  double sparse_weight = 1.0;
  double island_weight = 5.0;
  BorderKind border = BorderKind::fixed;
  bool text_safe = false;
  ShadingKind shading = ShadingKind::none;
  double soft_contours = 0.0;  ///< YUV distance in levels; none at 0
  bool linear_light = false;
  int threads = 1;

  /// Whether links and colours depend on whole components of similar pixels, and not on near pixels alone.
  bool has_whole_components() const { return similarity == Similarity::merge || connect_lines; }

  /// Whether colours may run inside a region: its pixels' own, or those of regions beyond a soft contour.
  bool has_shading() const {
    return soft_contours > 0 || (shading != ShadingKind::none && has_whole_components());
  }

  friend bool operator==(const Options&, const Options&) = default;
};

/// A choice among names; names[i] stands for enumerator i.
struct ChoiceOption {
  std::span<const std::string_view> names;
  int (*get)(const Options&);
  void (*set)(Options&, int);
};
struct SwitchOption {
  bool Options::*value;
};
struct NumberOption {
  double Options::*value;
  double minimum, maximum;
};
struct CountOption {
  int Options::*value;
  int minimum, maximum;
};

/// One row of the option table, from which every front end makes its flags, widgets or settings.
struct OptionInfo {
  std::string_view name;  ///< as on the command line, without dashes
  std::string_view help;  ///< one sentence without the full stop
  std::variant<ChoiceOption, SwitchOption, NumberOption, CountOption> kind;
};

/// All options, in the order in which front ends show them.
std::span<const OptionInfo> option_table();

}  // namespace depixel
