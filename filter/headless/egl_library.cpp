#include "filter/headless/egl_library.hpp"

#include <optional>

#include "filter/headless/shared_library.hpp"

namespace depixel {
namespace {

std::optional<EglLibrary> load() {
  SharedLibrary file("libEGL.so.1");
  EglLibrary library{};
  file.find(library.get_proc_address, "eglGetProcAddress");
  file.find(library.query_string, "eglQueryString");
  file.find(library.initialize, "eglInitialize");
  file.find(library.bind_api, "eglBindAPI");
  file.find(library.choose_config, "eglChooseConfig");
  file.find(library.create_context, "eglCreateContext");
  file.find(library.destroy_context, "eglDestroyContext");
  file.find(library.make_current, "eglMakeCurrent");
  file.find(library.get_current_context, "eglGetCurrentContext");
  file.find(library.release_thread, "eglReleaseThread");
  return file.has_all() ? std::optional(library) : std::nullopt;
}

}  // namespace

const EglLibrary* EglLibrary::get() {
  static const std::optional<EglLibrary> kLibrary = load();
  return kLibrary ? &*kLibrary : nullptr;
}

}  // namespace depixel
