#pragma once

#include "libdepixel/core/lattice.hpp"

namespace depixel {

/// Which part of the source is drawn: output pixel (X, Y) covers source x from origin_x + X / scale_x on. The
/// source's first pixel is that of the picture shown, whatever margin it was vectorized with.
struct View {
  double scale_x = 1, scale_y = 1;    ///< output pixels to a source pixel
  double origin_x = 0, origin_y = 0;  ///< source pixels at the output's top left

  /// The whole picture stretched to fill an output exactly.
  static View fit(const Lattice& source, int out_width, int out_height) {
    return {static_cast<double>(out_width) / source.shown_width(),
            static_cast<double>(out_height) / source.shown_height(), 0, 0};
  }

  /// The same part, counted from the first pixel of the source's margin.
  View from_margin(const Lattice& source) const {
    return {scale_x, scale_y, origin_x + source.margin(), origin_y + source.margin()};
  }

  friend bool operator==(const View&, const View&) = default;
};

}  // namespace depixel
