#pragma once

#include "libdepixel/stages/outlines.hpp"
#include "libdepixel/svg/svg_grid.hpp"

namespace depixel {

/// Replaces the pieces of outlines by fewer ones that are shorter to write.
///
/// Between junctions, where outlines part, a contour is a chain of pieces that two outlines have in common,
/// in opposite directions. Each chain is simplified once (chain_simplifier.hpp; the same shape, once in all,
/// chain_table.hpp), and both outlines get the result: they share it to the last digit.
///
/// \param map  that the outlines were traced from: how far the colours on both sides of a chain are apart
/// says how much a curve that strays would be seen.
/// \param tolerance_px  contours stray from what they were by no more. \param grid  all points lie on it.
/// \param outlines  changed; a loop starts at any junction or border of its, and a piece's segment is the
/// first of those that it replaces. Cost: linear in pieces, for as long as runs of many pieces do not fit.
/// Source: Schapfel, section 7.1.8.
void simplify_outlines(const PlanarMap& map, double tolerance_px, SvgGrid grid, Outlines& outlines);

}  // namespace depixel
