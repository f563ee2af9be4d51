#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace depixel {

/// Threads that share out a job's parts among them and wait for the next job in between.
class Workers {
 public:
  Workers() = default;
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Sets the number of threads, the caller's among them; at least 1. Helpers start with the first job.
  void set_threads(int threads);
  int threads() const { return threads_; }

  /// Calls work(part, thread) for parts 0 .. parts - 1, each once, in any order, on threads 0 .. threads() -
  /// 1 at once; returns when all are done. What the parts write must not overlap. Where the system gives
  /// fewer threads, those do it. What a part throws is thrown by this call, when no part runs any more; some
  /// may not have been called then.
  template <typename Work>
  void run(int parts, const Work& work) {
    run_job(parts, {&work, [](const void* w, int part, int thread) {
                      (*static_cast<const Work*>(w))(part, thread);
                    }});
  }

 private:
  /// A function object without its type, which is not owned.
  struct Job {
    const void* work = nullptr;
    void (*call)(const void* work, int part, int thread) = nullptr;
  };

  void run_job(int parts, Job job);
  void start();
  void stop();
  void help(int thread);
  void wait_for_helpers();
  void take_parts(int thread);

  int threads_ = 1;
  std::vector<std::thread> helpers_;
  std::mutex mutex_;
  std::condition_variable job_given_, job_done_;
  std::uint64_t jobs_ = 0;  ///< given so far
  bool stopping_ = false;
  std::atomic<int> busy_ = 0;  ///< helpers that have not finished the job
  Job job_;
  std::atomic<int> next_ = 0;  ///< part to be taken next
  int parts_ = 0;
  std::exception_ptr failure_;  ///< the first that a part threw; guarded by the mutex
};

}  // namespace depixel
