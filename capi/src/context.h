#pragma once

#include <memory_resource>
#include <new>
#include <utility>

#include "halfspace/context.h"

namespace halfspace::capi {

/// The host's allocator, or the C library's, behind the interface that core takes.
class HostMemory : public std::pmr::memory_resource {
 public:
  explicit HostMemory(const hs_context_def& def) : def_(def) {}

 private:
  void* do_allocate(std::size_t bytes, std::size_t alignment) override;
  void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override;
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }

  hs_context_def def_;
};

}  // namespace halfspace::capi

struct hs_context {
  explicit hs_context(const hs_context_def& def) : memory(def) {}

  halfspace::capi::HostMemory memory;
  char last_error[512] = "";  // fixed, so that reporting an error cannot fail
};

namespace halfspace::capi {

/// A handle's object, in the context's memory.
template <class T, class... Arguments>
T* create(hs_context* context, Arguments&&... arguments) {
  void* place = context->memory.allocate(sizeof(T), alignof(T));
  try {
    return new (place) T(std::forward<Arguments>(arguments)...);
  } catch (...) {
    context->memory.deallocate(place, sizeof(T), alignof(T));
    throw;
  }
}

template <class T>
void destroy(hs_context* context, T* object) {
  object->~T();
  context->memory.deallocate(object, sizeof(T), alignof(T));
}

}  // namespace halfspace::capi
