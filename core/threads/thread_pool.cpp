#include "threads/thread_pool.h"

#include <cfenv>

namespace halfspace {
namespace {

/// Threads poll before they sleep: passes follow within microseconds, less than it takes to wake up.
constexpr int looks_before_sleep = 4096;

template <class T>
void wait_until_other(const std::atomic<T>& value, T old) {
  for (int looks = 0; looks < looks_before_sleep; ++looks) {
    if (value.load(std::memory_order_acquire) != old) return;
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

ThreadPool::ThreadPool(int count) {
  threads_.reserve(std::size_t(count - 1));
  try {
    for (int worker = 1; worker < count; ++worker)
      threads_.emplace_back([this, worker] { wait_and_work(worker); });
  } catch (...) {
    end();
    throw;
  }
}

ThreadPool::~ThreadPool() { end(); }

void ThreadPool::end() {
  ends_ = true;
  ++job_;
  job_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void ThreadPool::run(void (*work)(void*, int), void* data) {
  work_ = work;
  data_ = data;
  at_work_.store(int(threads_.size()), std::memory_order_relaxed);
  job_.fetch_add(1, std::memory_order_release);
  job_.notify_all();
  work(data, 0);
  for (int left; (left = at_work_.load(std::memory_order_acquire)) > 0;) wait_until_other(at_work_, left);
}

/// Uses the default floating-point environment, whatever the host has set.
void ThreadPool::wait_and_work(int worker) {
  std::fesetenv(FE_DFL_ENV);
  for (std::uint32_t seen = 0;; ++seen) {
    wait_until_other(job_, seen);
    if (ends_) return;
    work_(data_, worker);
    if (at_work_.fetch_sub(1, std::memory_order_acq_rel) == 1) at_work_.notify_one();
  }
}

}  // namespace halfspace
