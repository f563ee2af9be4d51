#include "libdepixel/core/workers.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

namespace depixel {
namespace {

/// How often a thread that is done asks whether the others are before it sleeps: to be woken takes longer
/// than most parts.
constexpr int kAskingTimes = 200;

}  // namespace

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
  helpers_.reserve(threads_ - 1);
  try {
    for (int thread = 1; thread < threads_; ++thread) helpers_.emplace_back([this, thread] { help(thread); });
  } catch (const std::system_error&) {
    // There are no more threads to be had.
  }
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
  wait_for_helpers();
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void Workers::wait_for_helpers() {
  for (int asked = 0; asked < kAskingTimes; ++asked) {
    if (busy_ == 0) return;
    std::this_thread::yield();
  }
  std::unique_lock lock(mutex_);
  job_done_.wait(lock, [this] { return busy_ == 0; });
}

void Workers::take_parts(int thread) {
  try {
    for (int part = next_++; part < parts_; part = next_++) job_.call(job_.work, part, thread);
  } catch (...) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
    next_ = parts_;
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
    if (--busy_ != 0) continue;
    const std::lock_guard lock(mutex_);  // so that the one who waits is not just about to sleep
    job_done_.notify_one();
  }
}

}  // namespace depixel
