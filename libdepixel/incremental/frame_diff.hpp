#pragma once

#include "libdepixel/core/frame_view.hpp"
#include "libdepixel/incremental/row_spans.hpp"
#include "libdepixel/stages/similarity_graph.hpp"

namespace depixel {

/// Takes a frame over to a graph's pixels, where it differs from what they are.
/// \param frame    of the graph's size.
/// \param changed  set to what differs, by row.
/// \return the number of pixels that differ.
/// Cost: that of comparing memory, and of copying what differs.
int take_changed_pixels(const FrameView& frame, SimilarityGraph& graph, RowSpans& changed);

}  // namespace depixel
