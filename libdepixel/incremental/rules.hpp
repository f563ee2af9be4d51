#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace depixel {

/// What a change of the frame makes stale, rule by rule; all that follows from pixels and is kept from frame
/// to frame is named here, with what it was computed from. IncrementalVectorizer has a function for each
/// rule.
///
/// With merging or connected lines, links and colours depend on whole components: all links, codes and
/// colours are computed anew then, and compared with those before; the rules from `curves_by_codes` on are
/// the same.
enum class Rule : std::uint8_t {
  links_by_pixels,       ///< a block's links before crossings are resolved: its four pixels
  crossings_by_windows,  ///< what is cut at a crossing: links in the 8x8 window round it
  crossings_by_curves,   ///< what is cut at a crossing: links along the curves that cross, and at their ends
  codes_by_links,        ///< a corner's code: resolved links of its block and those to the east and south
  codes_by_colours,      ///< a corner's code, at T-junctions and borders: the colours of its four pixels
  thin_by_links,         ///< whether a pixel is thin: resolved links of the four blocks round it
  edges_by_codes,        ///< whether an edge is visible: the codes of its corners
  curves_by_codes,       ///< the curves of a contour: the codes of all its corners
  curves_by_thin,        ///< the curves of a contour: the thin pixels along it
  joints_by_curves,      ///< where a contour ends at a T-junction: the curves of the one that goes through
  tiles_by_curves,       ///< what a tile shows: the curves in it, before and now
  tiles_by_colours,      ///< what a tile shows: its pixel's colour
  tiles_by_side_colours  ///< what a tile shows: the colours on the sides of the curves in it
};
inline constexpr std::array<std::string_view, 13> kRuleNames{
    "links_by_pixels", "crossings_by_windows", "crossings_by_curves",  "codes_by_links", "codes_by_colours",
    "thin_by_links",   "edges_by_codes",       "curves_by_codes",      "curves_by_thin", "joints_by_curves",
    "tiles_by_curves", "tiles_by_colours",     "tiles_by_side_colours"};

/// The rules that are obeyed. All of them, but in tests that show what goes wrong without one.
class RuleSet {
 public:
  constexpr RuleSet() = default;
  constexpr RuleSet without(Rule rule) const {
    RuleSet rest = *this;
    rest.bits_ &= ~(1U << static_cast<unsigned>(rule));
    return rest;
  }
  constexpr bool has(Rule rule) const { return (bits_ >> static_cast<unsigned>(rule) & 1) != 0; }

 private:
  unsigned bits_ = ~0U;
};

}  // namespace depixel
