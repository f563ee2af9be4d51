#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace depixel {

/// What a change of the frame makes stale, rule by rule; all that follows from pixels and is kept from frame
/// to frame is named here, with what it was computed from. What obeys a rule names it: DitherUpdater those
/// of dithers, IncrementalGraph and StaleCrossings those of links and crossings, IncrementalVectorizer those
/// of codes and marks and, for contours along seams and marks, those of curves, IncrementalEdges the others
/// of edges, curves and joints, MapComparison those of tiles.
///
/// Blocks of 8x8 pixels move, each by the move that explains it best, and all that is known with them. A seam
/// is where two blocks meet that did not move alike, or a block that moved and the frame's border: what is
/// known on both sides was not side by side before.
///
/// With merging or connected lines, links and colours depend on whole components: all links, codes and
/// colours are computed anew then, and compared with those before; the rules from `marks_by_links` on are the
/// same.
enum class Rule : std::uint8_t {
  dithers_by_pixels,     ///< how a row's dithers are blended: its pixels
  dithers_by_areas,      ///< how a row's dithers are blended: which of its pixels are parts of areas
  links_by_pixels,       ///< a block's links before crossings are resolved: its four pixels
  links_by_seams,        ///< these, where it was not those pixels that were side by side
  crossings_by_windows,  ///< what is cut at a crossing: links in the 8x8 window round it
  crossings_by_curves,   ///< what is cut at a crossing: links along the curves that cross, and at their ends
  crossings_by_junctions,  ///< these, where curves go on at junctions: links of the pixels beside a curve's
  crossings_by_seams,      ///< what is cut at a crossing: how its curves go on beyond a seam
  codes_by_pixels,         ///< a corner's code: links and, at T-junctions and borders, colours round it
  codes_by_crossings,  ///< a corner's code: what is cut at crossings beside it, however far from any change
  marks_by_links,    ///< whether a pixel is thin, or in a stroke: resolved links of the four blocks round it,
                     ///< and pixels up to three away
  text_by_marks,     ///< whether a pixel is text's: strokes up to four pixels away
  edges_by_codes,    ///< whether an edge is visible: the codes of its corners
  curves_by_codes,   ///< the curves of a contour: the codes of all its corners
  curves_by_marks,   ///< the curves of a contour: the thin pixels and those of text along it
  curves_by_seams,   ///< the curves of a contour: how it goes on beyond a seam, and what is marked there
  joints_by_curves,  ///< where a contour ends at a T-junction: the curves of the one that goes through
  tiles_by_curves,   ///< what a tile shows: the curves in it, before and now
  tiles_by_colours,  ///< what a tile shows: its pixel's colour
  tiles_by_side_colours,  ///< what a tile shows: the colours on the sides of the curves in it
  tiles_by_seams,         ///< what a tile shows: curves and colours from beyond a seam
  tiles_by_shading        ///< what a tile shows: how colours run in the four blocks round its pixel
};
inline constexpr std::array<std::string_view, 22> kRuleNames{
    "dithers_by_pixels",    "dithers_by_areas",    "links_by_pixels",        "links_by_seams",
    "crossings_by_windows", "crossings_by_curves", "crossings_by_junctions", "crossings_by_seams",
    "codes_by_pixels",      "codes_by_crossings",  "marks_by_links",         "text_by_marks",
    "edges_by_codes",       "curves_by_codes",     "curves_by_marks",        "curves_by_seams",
    "joints_by_curves",     "tiles_by_curves",     "tiles_by_colours",       "tiles_by_side_colours",
    "tiles_by_seams",       "tiles_by_shading"};

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
