#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace depixel {

/// EGL's functions, from the library that the machine has. It is not linked, so that programs and plug-ins
/// start where there is none.
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

  /// nullptr where there is none. Once loaded it stays so: threads of its drivers may outlive all contexts.
  static const EglLibrary* get();
};

}  // namespace depixel
