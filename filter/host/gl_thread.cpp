#include "filter/host/gl_thread.hpp"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "filter/headless/headless_context.hpp"

namespace depixel {
namespace {

/// What renderers that draw by the processor have in their names.
constexpr std::array<std::string_view, 5> kSoftwareRenderers{"llvmpipe", "softpipe", "swrast", "SwiftShader",
                                                             "Software Rasterizer"};

bool is_software_renderer(GlLoader loader) {
  const auto get_string = reinterpret_cast<PFNGLGETSTRINGPROC>(loader("glGetString"));
  const auto* text = get_string == nullptr ? nullptr : reinterpret_cast<const char*>(get_string(GL_RENDERER));
  const std::string_view renderer = text == nullptr ? "" : text;
  return std::any_of(kSoftwareRenderers.begin(), kSoftwareRenderers.end(),
                     [&](std::string_view name) { return renderer.find(name) != std::string_view::npos; });
}

}  // namespace

tl::expected<std::unique_ptr<GlThread>, Error> GlThread::start() {
  std::unique_ptr<GlThread> result(new GlThread);
  result->thread_ = std::thread([thread = result.get()] { thread->live(); });
  std::unique_lock lock(result->mutex_);
  result->changed_.wait(lock, [&] { return result->has_started_; });
  if (result->error_) {
    const Error error = *result->error_;
    lock.unlock();
    return tl::unexpected(error);
  }
  return result;
}

GlThread::~GlThread() {
  {
    const std::lock_guard lock(mutex_);
    is_stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void GlThread::run_job(Job job) {
  std::unique_lock lock(mutex_);
  job_ = job;
  is_busy_ = true;
  changed_.notify_all();
  changed_.wait(lock, [&] { return !is_busy_; });
}

void GlThread::live() {
  auto context = create_egl_context({});
  tl::expected<std::unique_ptr<FrameFilter>, Error> filter;
  if (context) filter = FrameFilter::gl((*context)->loader());
  {
    const std::lock_guard lock(mutex_);
    if (!context) {
      error_ = Error{"There is no OpenGL context to be had from EGL: " + context.error().message + "."};
    } else if (!filter) {
      error_ = filter.error();
    } else {
      is_software_ = is_software_renderer((*context)->loader());
    }
    has_started_ = true;
  }
  changed_.notify_all();
  if (context && filter) take_jobs(**filter);
  filter = tl::unexpected(Error{});  // before its context
}

void GlThread::take_jobs(FrameFilter& filter) {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return is_busy_ || is_stopping_; });
    if (is_stopping_) return;
    const Job job = job_;
    lock.unlock();
    job.call(job.work, filter);
    lock.lock();
    is_busy_ = false;
    changed_.notify_all();
  }
}

}  // namespace depixel
