#include "filter/headless/egl_library.hpp"

#include <dlfcn.h>

#include <optional>

namespace depixel {
namespace {

std::optional<EglLibrary> load() {
  void* handle = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (handle == nullptr) return std::nullopt;
  bool has_all = true;
  const auto find = [&]<typename Function>(Function& function, const char* name) {
    function = reinterpret_cast<Function>(dlsym(handle, name));
    has_all = has_all && function != nullptr;
  };
  EglLibrary library{};
  find(library.get_proc_address, "eglGetProcAddress");
  find(library.query_string, "eglQueryString");
  find(library.initialize, "eglInitialize");
  find(library.bind_api, "eglBindAPI");
  find(library.choose_config, "eglChooseConfig");
  find(library.create_context, "eglCreateContext");
  find(library.destroy_context, "eglDestroyContext");
  find(library.make_current, "eglMakeCurrent");
  find(library.get_current_context, "eglGetCurrentContext");
  find(library.release_thread, "eglReleaseThread");
  return has_all ? std::optional(library) : std::nullopt;
}

}  // namespace

const EglLibrary* EglLibrary::get() {
  static const std::optional<EglLibrary> kLibrary = load();
  return kLibrary ? &*kLibrary : nullptr;
}

}  // namespace depixel
