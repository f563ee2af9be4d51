#pragma once

#include <memory>
#include <tl/expected.hpp>

#include "filter/frame_filter.hpp"
#include "libdepixel/core/error.hpp"

namespace depixel {

/// An OpenGL context that needs no display and no window. It has no framebuffer to speak of: drawing goes to
/// framebuffer objects.
class HeadlessContext {
 public:
  struct Wanted {
    bool es = false;     ///< OpenGL ES 3.0 instead of the core profile 3.3; of EGL only
    bool debug = false;  ///< a context that reports what it does not like; of EGL only
  };

  HeadlessContext() = default;
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;
  virtual ~HeadlessContext() = default;

  virtual bool make_current() = 0;
  virtual GlLoader loader() const = 0;
};

/// Makes a context by EGL without surfaces, on Mesa's platform for that or on a device, and makes it current
/// on this thread. EGL's library is looked for only now. \return an error that says why there is none,
/// without a full stop.
tl::expected<std::unique_ptr<HeadlessContext>, Error> create_egl_context(HeadlessContext::Wanted wanted);

}  // namespace depixel
