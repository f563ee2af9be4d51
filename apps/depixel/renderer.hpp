#pragma once

#include <cstdint>
#include <optional>
#include <tl/expected.hpp>
#include <vector>

#include "apps/common/picture.hpp"
#include "apps/depixel/command_line.hpp"
#include "apps/depixel/stats.hpp"
#include "libdepixel/core/error.hpp"
#include "libdepixel/pipeline/vectorizer.hpp"
#include "libdepixel/pipeline/verify.hpp"
#include "libdepixel/raster/cpu_raster.hpp"

namespace depixel {

/// Turns frames into files in memory, one after the other, and keeps its buffers warm.
class Renderer {
 public:
  explicit Renderer(const Arguments& arguments) : arguments_(arguments) {}

  /// Vectorizes a frame, draws it as the arguments say, and adds what it took to `stats`.
  tl::expected<std::vector<std::uint8_t>, Error> render(const FrameView& frame, Format format,
                                                        RunStats& stats);

  /// Of the frame rendered last: which pixels kept their colour.
  CentreReport verify() const { return verify_centres(vectorizer_.map(), vectorizer_.graph()); }

 private:
  std::string draw_svg(const FrameView& frame) const;
  void draw_picture(const FrameView& frame, OutputSize size);

  const Arguments& arguments_;
  Vectorizer vectorizer_;
  CpuRaster raster_;
  Picture picture_;
};

/// The size of a frame's picture: --size, or the frame's own times --scale, rounded.
tl::expected<OutputSize, Error> output_size(const Arguments& arguments, int width, int height);

}  // namespace depixel
