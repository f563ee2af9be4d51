#pragma once

#include <array>
#include <string_view>

#include "libdepixel/core/options.hpp"

namespace depixel::bench {

/// The defaults but for an option or two.
struct OptionVariant {
  std::string_view name;
  void (*change)(Options&);

  Options options() const {
    Options changed;
    change(changed);
    return changed;
  }
};

inline constexpr std::array kOptionVariants{
    OptionVariant{"merge", [](Options& o) { o.similarity = Similarity::merge; }},
    OptionVariant{"merge to 48",
                  [](Options& o) {
                    o.similarity = Similarity::merge;
                    o.merge_luma = 48;
                  }},
    OptionVariant{"merge to 48, gradient",
                  [](Options& o) {
                    o.similarity = Similarity::merge;
                    o.merge_luma = 48;
                    o.shading = ShadingKind::gradient;
                  }},
    OptionVariant{"merge to 48, blur",
                  [](Options& o) {
                    o.similarity = Similarity::merge;
                    o.merge_luma = 48;
                    o.shading = ShadingKind::blur;
                  }},
    OptionVariant{"soft contours 20", [](Options& o) { o.soft_contours = 20; }},
    OptionVariant{"blended dithers", [](Options& o) { o.dither = DitherKind::blend; }},
    OptionVariant{"round corners", [](Options& o) { o.corners = Corners::round; }},
    OptionVariant{"continuity", [](Options& o) { o.curve_rule = CurveRule::continuity; }},
    OptionVariant{"border mirror", [](Options& o) { o.border = BorderKind::mirror; }},
    OptionVariant{"text-safe", [](Options& o) { o.text_safe = true; }},
    OptionVariant{"connect lines", [](Options& o) { o.connect_lines = true; }},
    OptionVariant{"linear light", [](Options& o) { o.linear_light = true; }},
    OptionVariant{"no votes", [](Options& o) { o.curve_weight = o.sparse_weight = o.island_weight = 0; }}};

}  // namespace depixel::bench
