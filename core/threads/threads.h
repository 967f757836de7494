#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <utility>

namespace halfspace {

/// Runs work side by side. A world without any runs it one after the other, to the same bits.
class Threads {
 public:
  virtual ~Threads() = default;
  virtual int count() const = 0;
  /// Calls work(data, 0), work(data, 1) ... up to count() - 1, each once, in whatever order and at the same
  /// time, and comes back when all have ended. The work throws nothing.
  virtual void run(void (*work)(void* data, int worker), void* data) = 0;
};

/// The number of workers that may be at work at the same time.
inline int worker_count(const Threads* threads) { return threads ? threads->count() : 1; }

/// A chunk of a long row of things, and who is at work on it.
struct Chunk {
  std::size_t index;
  std::size_t begin;
  std::size_t end;
  int worker;
};

inline std::size_t chunk_count(std::size_t things, std::size_t per_chunk) {
  return (things + per_chunk - 1) / per_chunk;
}

/// Calls `visit(chunk)` for all chunks of a row. How the row is cut does not depend on the threads: what is
/// summed up chunk by chunk, and then over the chunks in order, has the same bits for any number of them.
/// Each worker takes the next chunk that nobody has taken.
template <class Visit>
void for_each_chunk(Threads* threads, std::size_t things, std::size_t per_chunk, Visit visit) {
  const std::size_t chunks = chunk_count(things, per_chunk);
  const auto visit_chunk = [&](std::size_t index, int worker) {
    visit(Chunk{index, index * per_chunk, std::min(things, (index + 1) * per_chunk), worker});
  };
  if (worker_count(threads) == 1 || chunks <= 1) {
    for (std::size_t index = 0; index < chunks; ++index) visit_chunk(index, 0);
    return;
  }
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> has_failed = false;
  std::exception_ptr fault;
  auto work = [&](int worker) {
    try {
      for (std::size_t index; !has_failed && (index = next++) < chunks;) visit_chunk(index, worker);
    } catch (...) {
      if (!has_failed.exchange(true)) fault = std::current_exception();
    }
  };
  threads->run([](void* data, int worker) { (*static_cast<decltype(work)*>(data))(worker); }, &work);
  if (fault) std::rethrow_exception(fault);
}

}  // namespace halfspace
