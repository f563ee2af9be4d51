#pragma once

#include <cstdint>
#include <vector>

#include "libdepixel/stages/similarity_graph.hpp"

namespace depixel {

/// What a pixel is part of, as far as contours along it depend on that; bits of a mask.
using PixelMarks = std::uint8_t;
/// A line one pixel wide: at most two links in the resolved graph, not part of a triangle.
inline constexpr PixelMarks kThinLine = 1;
/// Small text: a stroke with a bar of its colour up to four pixels away along either axis.
inline constexpr PixelMarks kText = 2;
/// A stroke: up to three pixels wide, along either axis, with one colour on both of its sides.
inline constexpr PixelMarks kStroke = 4;
/// A stroke that goes straight on, of the same width on the same ground, for three pixels or more.
inline constexpr PixelMarks kBar = 8;

/// Marks all pixels. \param graph  resolved. \param text_safe  whether strokes, bars and text are marked,
/// too. \param marks  padded, and a little longer; entries of the padding mean nothing.
void find_pixel_marks(const SimilarityGraph& graph, bool text_safe, std::vector<PixelMarks>& marks);

/// A part of row y, from .. to - 1, without text: a mark depends on the
/// links of the four blocks round the pixel, and on pixels up to three from it.
/// \param marks  has the frame's size.
void mark_lines(const SimilarityGraph& graph, bool text_safe, int y, int from, int to,
                std::vector<PixelMarks>& marks);
/// The text in a part of row y; depends on the other marks up to four pixels away.
void mark_text(const SimilarityGraph& graph, int y, int from, int to, std::vector<PixelMarks>& marks);

}  // namespace depixel
