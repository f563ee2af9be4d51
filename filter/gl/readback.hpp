#pragma once

#include <tl/expected.hpp>
#include <vector>

#include "filter/gl/gl_object.hpp"
#include "libdepixel/core/error.hpp"
#include "libdepixel/core/frame_view.hpp"

namespace depixel {

/// A framebuffer of its own, to draw to what a picture in memory is to hold.
///
/// Rows are read back in bands: when all are asked for, the first is copied while the device still draws the
/// others.
class Readback {
 public:
  /// Rows of a picture, first .. end - 1.
  struct Rows {
    int first, end;
  };

  /// Binds the framebuffer for drawing and reading, at least as large as asked for.
  tl::expected<void, Error> bind(const GladGLContext& gl, int width, int height);
  /// Lets drawing reach some rows only of a picture whose bottom left is the framebuffer's.
  static void restrict_to(const GladGLContext& gl, const PictureView& picture, Rows rows);
  /// Asks for what was drawn to some rows.
  void request(const GladGLContext& gl, const PictureView& picture, Rows rows);
  /// Waits for the rows asked for, band after band, and copies them to the picture.
  tl::expected<void, Error> take(const GladGLContext& gl, const PictureView& picture);

  void forget();

 private:
  GlFramebufferObject framebuffer_;
  GlRenderbuffer colours_;
  int width_ = 0, height_ = 0;
  GlBuffer bytes_;
  std::size_t capacity_ = 0;  ///< of the buffer
  struct Band {
    Rows rows;
    GLsync drawn;
  };
  std::vector<Band> bands_;  ///< asked for
};

}  // namespace depixel
