#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <memory_resource>
#include <new>
#include <utility>

#include "halfspace/context.h"
#include "threads/interrupt.h"
#include "threads/threads.h"

/// A parallel task of core.
struct hs_task {
  void (*work)(void* data, int worker);
  void* data;
};

namespace halfspace::capi {

/// Memory resource of core: the host's allocator, or by default the C library's.
class HostMemory : public std::pmr::memory_resource {
 public:
  explicit HostMemory(const hs_context_def& def) : def_(def) {}

 private:
  void* do_allocate(std::size_t bytes, std::size_t alignment) override;
  void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override;
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }

  hs_context_def def_;
};

/// Threads of core: the host's scheduler.
class HostThreads : public Threads {
 public:
  explicit HostThreads(const hs_context_def& def) : def_(def) {}

  int count() const override { return def_.threads; }
  void run(void (*work)(void*, int), void* data) override {
    hs_task task{work, data};
    def_.run_tasks(&task, def_.threads, def_.scheduler);
  }

 private:
  hs_context_def def_;
};

/// Interrupt of core: the host's function.
class HostInterrupt : public Interrupt {
 public:
  explicit HostInterrupt(const hs_context_def& def) : def_(def) {}

  bool is_requested() override { return def_.interrupt && def_.interrupt(def_.host) != 0; }

 private:
  hs_context_def def_;
};

/// Text of the last error, of fixed length, so that reporting an error cannot fail. Several threads may write
/// it at once, as they may use the same shapes: then it is that of one of them, or mixed, but it ends.
class ErrorText {
 public:
  static constexpr std::size_t size = 512;

  void write(const char* text) {
    for (std::size_t i = 0; i + 1 < size; ++i) {
      characters_[i].store(text[i], std::memory_order_relaxed);
      if (text[i] == 0) break;
    }
  }
  const char* read() const { return reinterpret_cast<const char*>(characters_); }

 private:
  static_assert(sizeof(std::atomic<char>) == 1);

  std::atomic<char> characters_[size] = {};
};

/// Returns NULL for one thread.
std::unique_ptr<Threads> threads_of(const hs_context_def& def);

}  // namespace halfspace::capi

struct hs_context {
  explicit hs_context(const hs_context_def& def)
      : memory(def), threads(halfspace::capi::threads_of(def)), interrupt(def) {}

  halfspace::capi::HostMemory memory;
  std::unique_ptr<halfspace::Threads> threads;
  halfspace::capi::HostInterrupt interrupt;
  halfspace::capi::ErrorText last_error;
};

namespace halfspace::capi {

/// Creates and destroys the object of a handle in memory of the host.
template <class T, class... Arguments>
T* create_in(HostMemory& memory, Arguments&&... arguments) {
  void* place = memory.allocate(sizeof(T), alignof(T));
  try {
    return new (place) T(std::forward<Arguments>(arguments)...);
  } catch (...) {
    memory.deallocate(place, sizeof(T), alignof(T));
    throw;
  }
}
template <class T>
void destroy_in(HostMemory& memory, T* object) {
  object->~T();
  memory.deallocate(object, sizeof(T), alignof(T));
}

/// Likewise, in the memory of the context.
template <class T, class... Arguments>
T* create(hs_context* context, Arguments&&... arguments) {
  return create_in<T>(context->memory, std::forward<Arguments>(arguments)...);
}
template <class T>
void destroy(hs_context* context, T* object) {
  destroy_in(context->memory, object);
}

}  // namespace halfspace::capi
