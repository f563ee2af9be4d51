#include "libdepixel/core/workers.hpp"

#include <algorithm>

namespace depixel {

Workers::~Workers() {
  stop();
}

void Workers::set_threads(int threads) {
  threads = std::max(threads, 1);
  if (threads == threads_) return;
  stop();
  threads_ = threads;
}

void Workers::start() {
  for (int thread = 1; thread < threads_; ++thread) helpers_.emplace_back([this, thread] { help(thread); });
}

void Workers::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  job_given_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
  helpers_.clear();
  stopping_ = false;
  jobs_ = 0;
}

void Workers::run_job(int parts, Job job) {
  if (threads_ == 1 || parts <= 1) {
    for (int part = 0; part < parts; ++part) job.call(job.work, part, 0);
    return;
  }
  if (helpers_.empty()) start();
  {
    const std::lock_guard lock(mutex_);
    job_ = job;
    next_ = 0;
    parts_ = parts;
    busy_ = static_cast<int>(helpers_.size());
    ++jobs_;
  }
  job_given_.notify_all();
  take_parts(0);
  std::unique_lock lock(mutex_);
  job_done_.wait(lock, [this] { return busy_ == 0; });
}

void Workers::take_parts(int thread) {
  for (;;) {
    int part;
    {
      const std::lock_guard lock(mutex_);
      if (next_ >= parts_) return;
      part = next_++;
    }
    job_.call(job_.work, part, thread);
  }
}

void Workers::help(int thread) {
  std::uint64_t seen = 0;
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      job_given_.wait(lock, [&] { return stopping_ || jobs_ != seen; });
      if (stopping_) return;
      seen = jobs_;
    }
    take_parts(thread);
    const std::lock_guard lock(mutex_);
    if (--busy_ == 0) job_done_.notify_one();
  }
}

}  // namespace depixel
