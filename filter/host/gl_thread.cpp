#include "filter/host/gl_thread.hpp"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

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
  try {
    result->thread_ = std::thread([thread = result.get()] { thread->live(); });
  } catch (const std::system_error& error) {
    return tl::unexpected(Error{std::string("There is no thread to be had: ") + error.what() + "."});
  }
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
  if (thread_.joinable()) thread_.join();
}

void GlThread::run_job(Job job) {
  std::unique_lock lock(mutex_);
  job_ = job;
  is_busy_ = true;
  changed_.notify_all();
  changed_.wait(lock, [&] { return !is_busy_; });
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void GlThread::live() {
  try {
    serve();
  } catch (const std::exception& error) {
    tell_started(Error{std::string("OpenGL cannot be set up: ") + error.what() + "."});
  }
}

void GlThread::serve() {
  auto context = create_egl_context({});
  if (!context) {
    tell_started(Error{"There is no OpenGL context to be had from EGL: " + context.error().message + "."});
    return;
  }
  const auto filter = FrameFilter::gl((*context)->loader());  // dropped before its context
  if (!filter) {
    tell_started(filter.error());
    return;
  }
  is_software_ = is_software_renderer((*context)->loader());
  tell_started({});
  take_jobs(**filter);
}

void GlThread::tell_started(std::optional<Error> error) {
  {
    const std::lock_guard lock(mutex_);
    error_ = std::move(error);
    has_started_ = true;
  }
  changed_.notify_all();
}

void GlThread::take_jobs(FrameFilter& filter) {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return is_busy_ || is_stopping_; });
    if (is_stopping_) return;
    const Job job = job_;
    lock.unlock();
    std::exception_ptr failure;
    try {
      job.call(job.work, filter);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    failure_ = failure;
    is_busy_ = false;
    changed_.notify_all();
  }
}

}  // namespace depixel
