#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>

#include "libdepixel/core/frame_view.hpp"
#include "libdepixel/core/lattice.hpp"
#include "libdepixel/core/tolerances.hpp"
#include "libdepixel/raster/view.hpp"

namespace depixel {

/// Maps subpixels of the source to subpixels of the output along an axis, by one rounded multiplication.
class ToOutput {
 public:
  ToOutput(double scale, double origin)
      : factor_(std::max(std::llround(scale * kRasterSubpixels / kSubpixels * kOne), 1LL)),
        offset_(std::llround(-origin * scale * kRasterSubpixels) * kOne + kOne / 2) {}
  int operator()(int subpixels) const { return static_cast<int>((subpixels * factor_ + offset_) >> kBits); }

  /// The subpixel of the source that lies under one of the output.
  std::int64_t source(int output_subpixels) const {
    const std::int64_t to = output_subpixels * kOne - (offset_ - kOne / 2);
    return to >= 0 ? to / factor_ : (to + 1) / factor_ - 1;
  }
  /// The first of the source's subpixels that is mapped to a subpixel of the output, or beyond it.
  std::int64_t first_at(int output_subpixels) const {
    const std::int64_t wanted = output_subpixels * kOne - offset_;
    return wanted / factor_ + (wanted % factor_ > 0 ? 1 : 0);
  }

  /// Output pixels to a source pixel if these are whole and begin on whole output pixels, else 0: then all
  /// that moves by source pixels moves by whole output pixels, to the bit.
  int whole_scale() const {
    const std::int64_t pixel = factor_ * kSubpixels;
    constexpr std::int64_t kPixel = std::int64_t{kRasterSubpixels} << kBits;
    return pixel % kPixel == 0 && operator()(0) % kRasterSubpixels == 0 ? static_cast<int>(pixel / kPixel)
                                                                        : 0;
  }

 private:
  static constexpr int kBits = 28;
  static constexpr std::int64_t kOne = std::int64_t{1} << kBits;
  std::int64_t factor_;  ///< at least 1, of whatever scale
  std::int64_t offset_;
};

/// A view of a frame on a target: where the source's points come to lie, in output subpixels.
struct OutputGrid {
  OutputGrid(const View& view, const Lattice& source, const PictureView& out)
      : x(view.scale_x, view.from_margin(source).origin_x),
        y(view.scale_y, view.from_margin(source).origin_y),
        scale(view.scale_x, view.scale_y),
        lattice(source),
        target(out) {}

  ToOutput x, y;
  glm::dvec2 scale;
  Lattice lattice;
  PictureView target;

  glm::ivec2 operator()(glm::ivec2 p) const { return {x(p.x), y(p.y)}; }
  /// Where a column's left side, or a row's top, lies.
  int column(int source_x) const { return x(source_x * kSubpixels); }
  int row(int source_y) const { return y(source_y * kSubpixels); }
  /// Whether both axes have whole output pixels to a source pixel, so many at most.
  bool has_whole_scales(int largest) const {
    const int across = x.whole_scale(), down = y.whole_scale();
    return across > 0 && down > 0 && across <= largest && down <= largest;
  }
  bool covers_target() const {
    return column(0) <= 0 && row(0) <= 0 && column(lattice.width()) >= target.width * kRasterSubpixels &&
           row(lattice.height()) >= target.height * kRasterSubpixels;
  }
};

}  // namespace depixel
