#pragma once

#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <tl/expected.hpp>

#include "filter/frame_filter.hpp"

namespace depixel {

/// A thread with an OpenGL context of its own, without a display, and the filter that draws on it. A host's
/// own context stays where it is, whatever thread of the host's calls.
class GlThread {
 public:
  /// Starts the thread. \return an error that says why there is no thread, no context, or no filter on it.
  static tl::expected<std::unique_ptr<GlThread>, Error> start();
  GlThread(const GlThread&) = delete;
  GlThread& operator=(const GlThread&) = delete;
  /// Drops filter and context on their thread, and waits for its end.
  ~GlThread();

  /// Calls work(filter) on the thread and waits until it is done. By one thread at a time. What work throws
  /// is thrown by this call.
  template <typename Work>
  void run(const Work& work) {
    run_job({&work, [](const void* w, FrameFilter& filter) { (*static_cast<const Work*>(w))(filter); }});
  }

  /// Whether the context draws by the processor.
  bool is_software() const { return is_software_; }

 private:
  /// A function object without its type, which is not owned.
  struct Job {
    const void* work = nullptr;
    void (*call)(const void* work, FrameFilter& filter) = nullptr;
  };

  GlThread() = default;
  void run_job(Job job);
  void live();
  void serve();
  void tell_started(std::optional<Error> error);
  void take_jobs(FrameFilter& filter);

  std::thread thread_;
  std::mutex mutex_;
  std::condition_variable changed_;
  // Guarded by the mutex.
  bool has_started_ = false, is_stopping_ = false, is_busy_ = false;
  Job job_;
  std::exception_ptr failure_;  ///< what the job threw
  std::optional<Error> error_;  ///< why the thread did not start
  bool is_software_ = false;
};

}  // namespace depixel
