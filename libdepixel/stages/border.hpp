#pragma once

#include <vector>

#include "libdepixel/core/frame_view.hpp"
#include "libdepixel/core/lattice.hpp"
#include "libdepixel/core/memory.hpp"
#include "libdepixel/core/options.hpp"

namespace depixel {

/// Continues frames beyond their border, so that contours go on there instead of ending.
class Border {
 public:
  /// Pixels that a frame is continued by at each side: votes at crossings look three pixels far, and most of
  /// a curve's shape depends on two nodes more. Long arms of corners, and long curves that vote, end there.
  static constexpr int kMargin = 6;

  /// A frame with a margin, or itself where the border is fixed. \param frame  at least 1x1 pixels, without a
  /// margin. \return a view of the frame given, or of a copy that is valid until the next call.
  /// Cost: linear in pixels; no allocation when the size stays.
  FrameView continued(const FrameView& frame, BorderKind kind);

  /// The lattice of a continued frame.
  static Lattice lattice_of(const FrameView& frame, BorderKind kind) {
    const int margin = kind == BorderKind::fixed ? 0 : kMargin;
    return {frame.width + 2 * margin, frame.height + 2 * margin, margin};
  }

  std::size_t memory_bytes() const { return held_bytes(pixels_); }

 private:
  std::vector<Rgba> pixels_;
};

}  // namespace depixel
