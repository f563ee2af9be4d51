#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <tl/expected.hpp>
#include <vector>

#include "apps/common/picture.hpp"
#include "apps/depixel/command_line.hpp"
#include "apps/depixel/stats.hpp"
#include "apps/headless/context_kind.hpp"
#include "filter/frame_filter.hpp"
#include "libdepixel/core/error.hpp"
#include "libdepixel/pipeline/verify.hpp"

namespace depixel {

/// Turns frames into files in memory, one after the other, and keeps its buffers warm.
class Renderer {
 public:
  /// \param arguments  must outlive the renderer. \return an error if there is no OpenGL where it is asked
  /// for.
  static tl::expected<Renderer, Error> create(const Arguments& arguments);

  /// Vectorizes a frame, draws it as the arguments say, and adds what it took to `stats`.
  tl::expected<std::vector<std::uint8_t>, Error> render(const FrameView& frame, Format format,
                                                        RunStats& stats);

  /// Of the frame rendered last: which pixels kept their colour.
  CentreReport verify() const {
    return verify_centres(filter_->vectorizer().map(), filter_->vectorizer().graph());
  }

 private:
  explicit Renderer(const Arguments& arguments) : arguments_(&arguments) {}
  tl::expected<void, Error> start_gl();
  std::string draw_svg(const FrameView& frame) const;
  tl::expected<void, Error> draw_picture(const FrameView& frame, OutputSize size);

  const Arguments* arguments_;
  std::unique_ptr<HeadlessContext> context_;  ///< outlives the filter
  std::unique_ptr<FrameFilter> filter_;
  Picture picture_;
};

/// The size of a frame's picture: --size, or the frame's own times --scale, rounded.
tl::expected<OutputSize, Error> output_size(const Arguments& arguments, int width, int height);

}  // namespace depixel
