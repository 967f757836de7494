#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <exception>
#include <utility>

namespace halfspace {

/// Runs work in parallel. A world without threads runs it in sequence, with the same bits.
class Threads {
 public:
  virtual ~Threads() = default;
  virtual int count() const = 0;
  /// Calls work(data, 0) to work(data, count() - 1), once each, in any order and at the same time. Returns
  /// when all have finished. The work must not throw.
  virtual void run(void (*work)(void* data, int worker), void* data) = 0;
};

/// The maximum number of workers at the same time.
inline int worker_count(const Threads* threads) { return threads ? threads->count() : 1; }

/// A part of an array, and the worker that processes it.
struct Chunk {
  std::size_t index;
  std::size_t begin;
  std::size_t end;
  int worker;
};

inline std::size_t chunk_count(std::size_t things, std::size_t per_chunk) {
  return (things + per_chunk - 1) / per_chunk;
}

/// Hands out the chunks of an array. Each worker has its own range, the same in every pass: data that it
/// wrote in one pass is in its own cache in the next. A chunk taken by another worker costs several times as
/// much, so a worker that has finished takes chunks only from ranges that are far behind.
class ChunkQueue {
 public:
  ChunkQueue(std::size_t chunks, std::size_t workers)
      : chunks_(chunks), ranges_(std::min({workers, chunks / 2, max_ranges})) {}

  /// Calls `visit(index)` for chunks not yet taken, until none is left to it or visit returns false.
  template <class Visit>
  void take(int worker, Visit visit) {
    for (std::size_t turn = 0; turn < ranges_; ++turn) {
      const std::size_t range = (std::size_t(worker) + turn) % ranges_;
      const std::size_t begin = range * chunks_ / ranges_, end = (range + 1) * chunks_ / ranges_;
      const bool is_own = range == std::size_t(worker);
      const std::size_t left_alone = is_own ? 0 : 1 + (end - begin) / 8;
      std::atomic<std::size_t>& taken = taken_[range].count;
      while (begin + taken + left_alone < end) {
        const std::size_t index = begin + taken++;
        if (index < end && !visit(index)) return;
      }
    }
  }

 private:
  static constexpr std::size_t max_ranges = 16;
  struct alignas(64) Taken {  // one cache line each
    std::atomic<std::size_t> count = 0;
  };

  std::size_t chunks_;
  std::size_t ranges_;
  std::array<Taken, max_ranges> taken_;
};

/// Calls `visit(chunk)` for all chunks of an array. The chunks do not depend on the number of threads: sums
/// per chunk, added up in the order of the chunks, have the same bits for any number of threads.
template <class Visit>
void for_each_chunk(Threads* threads, std::size_t things, std::size_t per_chunk, Visit visit) {
  const std::size_t chunks = chunk_count(things, per_chunk);
  const auto visit_chunk = [&](std::size_t index, int worker) {
    visit(Chunk{index, index * per_chunk, std::min(things, (index + 1) * per_chunk), worker});
  };
  const std::size_t workers = std::size_t(worker_count(threads));
  if (workers == 1 || chunks < 4) {  // dispatch would cost as much as the work
    for (std::size_t index = 0; index < chunks; ++index) visit_chunk(index, 0);
    return;
  }
  ChunkQueue queue(chunks, workers);
  std::atomic<bool> has_failed = false;
  std::exception_ptr fault;
  auto work = [&](int worker) {
    try {
      queue.take(worker, [&](std::size_t index) {
        visit_chunk(index, worker);
        return !has_failed.load(std::memory_order_relaxed);
      });
    } catch (...) {
      if (!has_failed.exchange(true)) fault = std::current_exception();
    }
  };
  threads->run([](void* data, int worker) { (*static_cast<decltype(work)*>(data))(worker); }, &work);
  if (fault) std::rethrow_exception(fault);
}

/// Calls `visit(chunk, sum)` for all chunks of an array; `sums` returns one sum per chunk, in order. Each
/// worker accumulates in a local sum, to avoid false sharing of cache lines.
template <class Sums, class Visit>
void sum_each_chunk(Threads* threads, std::size_t things, std::size_t per_chunk, Sums& sums, Visit visit) {
  sums.assign(chunk_count(things, per_chunk), {});
  for_each_chunk(threads, things, per_chunk, [&](const Chunk& chunk) {
    typename Sums::value_type sum{};
    visit(chunk, sum);
    sums[chunk.index] = sum;
  });
}

/// The largest of `least` and the values `of(i)` of all things of an array.
template <class Of>
double max_of_each(Threads* threads, std::size_t things, std::size_t per_chunk, double least, Of of) {
  std::atomic<double> largest = least;
  for_each_chunk(threads, things, per_chunk, [&](const Chunk& chunk) {
    double here = least;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) here = std::max(here, of(i));
    double seen = largest;
    while (here > seen && !largest.compare_exchange_weak(seen, here)) {
    }
  });
  return largest;
}

}  // namespace halfspace
