#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace depixel {

/// EGL's functions, from the library that the machine has.
struct EglLibrary {
  PFNEGLGETPROCADDRESSPROC get_proc_address;
  PFNEGLQUERYSTRINGPROC query_string;
  PFNEGLINITIALIZEPROC initialize;
  PFNEGLBINDAPIPROC bind_api;
  PFNEGLCHOOSECONFIGPROC choose_config;
  PFNEGLCREATECONTEXTPROC create_context;
  PFNEGLDESTROYCONTEXTPROC destroy_context;
  PFNEGLMAKECURRENTPROC make_current;
  PFNEGLGETCURRENTCONTEXTPROC get_current_context;
  PFNEGLRELEASETHREADPROC release_thread;

  /// nullptr where there is none.
  static const EglLibrary* get();
};

}  // namespace depixel
