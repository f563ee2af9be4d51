#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/core.h>

#include <array>
#include <vector>

#include "apps/headless/headless_context.hpp"

namespace depixel {
namespace {

bool has_extension(EGLDisplay display, std::string_view name) {
  const char* text = eglQueryString(display, EGL_EXTENSIONS);
  for (std::string_view rest = text == nullptr ? "" : text; !rest.empty();) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    if (rest.substr(0, end) == name) return true;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

template <typename Function>
Function load(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

EGLDisplay platform_display(EGLenum platform, void* native) {
  const auto get = load<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  return get == nullptr ? EGL_NO_DISPLAY : get(platform, native, nullptr);
}

/// Displays that need nothing but the machine, in the order in which they are tried.
std::vector<EGLDisplay> find_displays() {
  std::vector<EGLDisplay> displays;
  if (has_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    displays.push_back(platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY));
  }
  const auto query_devices = load<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  if (has_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") && query_devices != nullptr) {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count);
    for (EGLint i = 0; i < count; ++i)
      displays.push_back(platform_display(EGL_PLATFORM_DEVICE_EXT, devices[i]));
  }
  return displays;
}

/// A display stays initialised to the end of the process: others may use the same one, and EGL does not
/// count.
class EglContext final : public HeadlessContext {
 public:
  EglContext(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}
  ~EglContext() override {
    if (eglGetCurrentContext() == context_) {
      eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(display_, context_);
  }

  bool make_current() override {
    return eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }
  ContextKind kind() const override { return ContextKind::egl; }
  GlLoader loader() const override { return eglGetProcAddress; }

 private:
  EGLDisplay display_;
  EGLContext context_;
};

EGLContext create_on(EGLDisplay display, HeadlessContext::Wanted wanted) {
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE ||
      !has_extension(display, "EGL_KHR_surfaceless_context") ||
      eglBindAPI(wanted.es ? EGL_OPENGL_ES_API : EGL_OPENGL_API) != EGL_TRUE) {
    return EGL_NO_CONTEXT;
  }
  const std::array<EGLint, 5> config_wanted{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE,
                                            wanted.es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint configs = 0;
  eglChooseConfig(display, config_wanted.data(), &config, 1, &configs);
  if (configs == 0) return EGL_NO_CONTEXT;

  std::vector<EGLint> attributes{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, wanted.es ? 0 : 3};
  if (!wanted.es) {
    attributes.insert(attributes.end(),
                      {EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT});
  }
  if (wanted.debug) attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});
  attributes.push_back(EGL_NONE);
  return eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
}

}  // namespace

tl::expected<std::unique_ptr<HeadlessContext>, Error> create_egl_context(HeadlessContext::Wanted wanted) {
  const std::vector<EGLDisplay> displays = find_displays();
  for (const EGLDisplay display : displays) {
    const EGLContext context = create_on(display, wanted);
    if (context == EGL_NO_CONTEXT) continue;
    auto result = std::make_unique<EglContext>(display, context);
    if (result->make_current()) return result;
  }
  if (displays.empty()) return tl::unexpected(Error{"no surfaceless or device platform"});
  return tl::unexpected(Error{fmt::format("none of {} displays gives {}", displays.size(),
                                          wanted.es ? "OpenGL ES 3.0" : "a core profile of OpenGL 3.3")});
}

}  // namespace depixel
