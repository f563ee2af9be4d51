#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "filter/headless/egl_library.hpp"
#include "filter/headless/headless_context.hpp"

namespace depixel {
namespace {

bool has_extension(const EglLibrary& egl, EGLDisplay display, std::string_view name) {
  const char* text = egl.query_string(display, EGL_EXTENSIONS);
  for (std::string_view rest = text == nullptr ? "" : text; !rest.empty();) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    if (rest.substr(0, end) == name) return true;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

template <typename Function>
Function load(const EglLibrary& egl, const char* name) {
  return reinterpret_cast<Function>(egl.get_proc_address(name));
}

EGLDisplay platform_display(const EglLibrary& egl, EGLenum platform, void* native) {
  const auto get = load<PFNEGLGETPLATFORMDISPLAYEXTPROC>(egl, "eglGetPlatformDisplayEXT");
  return get == nullptr ? EGL_NO_DISPLAY : get(platform, native, nullptr);
}

/// Displays that need nothing but the machine, in the order in which they are tried.
std::vector<EGLDisplay> find_displays(const EglLibrary& egl) {
  std::vector<EGLDisplay> displays;
  if (has_extension(egl, EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    displays.push_back(platform_display(egl, EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY));
  }
  const auto query_devices = load<PFNEGLQUERYDEVICESEXTPROC>(egl, "eglQueryDevicesEXT");
  if (has_extension(egl, EGL_NO_DISPLAY, "EGL_EXT_platform_device") && query_devices != nullptr) {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count);
    for (EGLint i = 0; i < count; ++i)
      displays.push_back(platform_display(egl, EGL_PLATFORM_DEVICE_EXT, devices[i]));
  }
  return displays;
}

/// A display stays initialised to the end of the process: others may use the same one, and EGL does not
/// count.
class EglContext final : public HeadlessContext {
 public:
  EglContext(const EglLibrary& egl, EGLDisplay display, EGLContext context)
      : egl_(egl), display_(display), context_(context) {}
  ~EglContext() override {
    if (egl_.get_current_context() == context_) {
      egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    egl_.destroy_context(display_, context_);
    egl_.release_thread();
  }

  bool make_current() override {
    return egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }
  GlLoader loader() const override { return egl_.get_proc_address; }

 private:
  const EglLibrary& egl_;
  EGLDisplay display_;
  EGLContext context_;
};

EGLContext create_on(const EglLibrary& egl, EGLDisplay display, HeadlessContext::Wanted wanted) {
  if (display == EGL_NO_DISPLAY || egl.initialize(display, nullptr, nullptr) != EGL_TRUE ||
      !has_extension(egl, display, "EGL_KHR_surfaceless_context") ||
      egl.bind_api(wanted.es ? EGL_OPENGL_ES_API : EGL_OPENGL_API) != EGL_TRUE) {
    return EGL_NO_CONTEXT;
  }
  const std::array<EGLint, 5> config_wanted{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE,
                                            wanted.es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint configs = 0;
  egl.choose_config(display, config_wanted.data(), &config, 1, &configs);
  if (configs == 0) return EGL_NO_CONTEXT;

  std::vector<EGLint> attributes{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, wanted.es ? 0 : 3};
  if (!wanted.es) {
    attributes.insert(attributes.end(),
                      {EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT});
  }
  if (wanted.debug) attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});
  attributes.push_back(EGL_NONE);
  return egl.create_context(display, config, EGL_NO_CONTEXT, attributes.data());
}

}  // namespace

tl::expected<std::unique_ptr<HeadlessContext>, Error> create_egl_context(HeadlessContext::Wanted wanted) {
  const EglLibrary* egl = EglLibrary::get();
  if (egl == nullptr) return tl::unexpected(Error{"there is no libEGL"});
  const std::vector<EGLDisplay> displays = find_displays(*egl);
  for (const EGLDisplay display : displays) {
    const EGLContext context = create_on(*egl, display, wanted);
    if (context == EGL_NO_CONTEXT) continue;
    auto result = std::make_unique<EglContext>(*egl, display, context);
    if (result->make_current()) return result;
  }
  if (displays.empty()) return tl::unexpected(Error{"no surfaceless or device platform"});
  return tl::unexpected(Error{fmt::format("none of {} displays gives {}", displays.size(),
                                          wanted.es ? "OpenGL ES 3.0" : "a core profile of OpenGL 3.3")});
}

}  // namespace depixel
