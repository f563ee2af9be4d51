#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <tl/expected.hpp>

#include "filter/frame_filter.hpp"
#include "libdepixel/core/error.hpp"

namespace depixel {

/// Where a context without a display comes from.
enum class ContextKind {
  egl,    ///< EGL without surfaces, on Mesa's platform for that or on a device
  osmesa  ///< Mesa's software rasteriser in memory
};

/// Names as on the command line; names[i] stands for enumerator i.
std::span<const std::string_view> context_kind_names();

/// An OpenGL context that needs no display and no window. It has no framebuffer to speak of: drawing goes to
/// framebuffer objects.
class HeadlessContext {
 public:
  struct Wanted {
    bool es = false;     ///< OpenGL ES 3.0 instead of the core profile 3.3; of EGL only
    bool debug = false;  ///< a context that reports what it does not like; of EGL only
  };

  /// Makes a context and makes it current on this thread.
  /// \param kind  none: each is tried, EGL first. \return an error that says why each failed.
  static tl::expected<std::unique_ptr<HeadlessContext>, Error> create(std::optional<ContextKind> kind,
                                                                      Wanted wanted);
  static tl::expected<std::unique_ptr<HeadlessContext>, Error> create(std::optional<ContextKind> kind = {}) {
    return create(kind, {});
  }

  HeadlessContext() = default;
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;
  virtual ~HeadlessContext() = default;

  virtual bool make_current() = 0;
  virtual ContextKind kind() const = 0;
  virtual GlLoader loader() const = 0;
};

// The kinds of contexts behind create(), one for each library. The errors say why, without a full stop.
tl::expected<std::unique_ptr<HeadlessContext>, Error> create_egl_context(HeadlessContext::Wanted wanted);
tl::expected<std::unique_ptr<HeadlessContext>, Error> create_osmesa_context(HeadlessContext::Wanted wanted);

}  // namespace depixel
