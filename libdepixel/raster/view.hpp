#pragma once

#include "libdepixel/core/lattice.hpp"

namespace depixel {

/// Which part of the source is drawn: output pixel (X, Y) covers source x from origin_x + X / scale_x on.
struct View {
  double scale_x = 1, scale_y = 1;    ///< output pixels to a source pixel
  double origin_x = 0, origin_y = 0;  ///< source pixels at the output's top left

  /// The whole frame stretched to fill an output exactly.
  static View fit(const Lattice& source, int out_width, int out_height) {
    return {static_cast<double>(out_width) / source.width(),
            static_cast<double>(out_height) / source.height(), 0, 0};
  }

  friend bool operator==(const View&, const View&) = default;
};

}  // namespace depixel
