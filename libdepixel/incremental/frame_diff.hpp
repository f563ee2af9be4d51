#pragma once

#include "libdepixel/core/frame_view.hpp"
#include "libdepixel/incremental/row_spans.hpp"
#include "libdepixel/stages/similarity_graph.hpp"

namespace depixel {

/// Finds where a frame differs from a graph's pixels.
/// \param frame    of the graph's size.
/// \param changed  set to what differs, by row.
/// Cost: that of comparing memory.
void find_changed_pixels(const FrameView& frame, const SimilarityGraph& graph, RowSpans& changed);

/// Takes the frame over to the graph's pixels, where it differs. \return the number of pixels that did.
/// \param changed  by find_changed_pixels().
int take_changed_pixels(const FrameView& frame, const RowSpans& changed, SimilarityGraph& graph);

}  // namespace depixel
