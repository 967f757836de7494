#pragma once

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

#include "threads/threads.h"

namespace halfspace {

/// Worker threads that wait for work; the calling thread is the first worker.
class ThreadPool : public Threads {
 public:
  explicit ThreadPool(int count);
  ~ThreadPool() override;

  int count() const override { return int(threads_.size()) + 1; }
  void run(void (*work)(void*, int), void* data) override;

 private:
  void wait_and_work(int worker);
  void end();

  void (*work_)(void*, int) = nullptr;
  void* data_ = nullptr;
  std::atomic<std::uint32_t> job_ = 0;  // number of the current job
  std::atomic<int> at_work_ = 0;
  std::atomic<bool> ends_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace halfspace
