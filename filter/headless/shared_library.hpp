#pragma once

#include <dlfcn.h>

namespace depixel {

/// A library that is found when the program runs and not linked, so that programs and plug-ins start where
/// there is none, and fast where there is one. It stays loaded: threads of drivers may outlive all contexts.
class SharedLibrary {
 public:
  explicit SharedLibrary(const char* name) : handle_(dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) {}

  /// Sets a pointer to a function of this name, nullptr where there is none.
  template <typename Function>
  void find(Function& function, const char* name) {
    function = handle_ == nullptr ? nullptr : reinterpret_cast<Function>(dlsym(handle_, name));
    has_all_ = has_all_ && function != nullptr;
  }
  /// Whether all that was looked for was found.
  bool has_all() const { return has_all_; }

 private:
  void* handle_;
  bool has_all_ = true;
};

}  // namespace depixel
