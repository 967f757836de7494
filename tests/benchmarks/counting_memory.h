#pragma once

#include <halfspace/halfspace.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace halfspace_benchmark {

/// Allocator of a context that counts what is asked of it.
class CountingMemory {
 public:
  std::int64_t live() const { return live_; }                ///< bytes held now
  std::int64_t peak() const { return peak_; }                ///< most bytes ever held at once
  std::int64_t allocations() const { return allocations_; }  ///< requests so far

  hs_context_def definition() {
    hs_context_def def;
    hs_context_def_init(&def, sizeof def);
    def.allocate = allocate;
    def.release = release;
    def.user = this;
    return def;
  }

 private:
  static void* allocate(std::size_t bytes, std::size_t alignment, void* user) {
    CountingMemory& counter = *static_cast<CountingMemory*>(user);
    const std::size_t rounded = (bytes + alignment - 1) / alignment * alignment;  // as aligned_alloc wants it
    void* memory = std::aligned_alloc(alignment, rounded);
    if (!memory) return nullptr;
    ++counter.allocations_;
    counter.live_ += std::int64_t(bytes);
    counter.peak_ = std::max(counter.peak_, counter.live_);
    return memory;
  }

  static void release(void* memory, std::size_t bytes, std::size_t, void* user) {
    static_cast<CountingMemory*>(user)->live_ -= std::int64_t(bytes);
    std::free(memory);
  }

  std::int64_t live_ = 0;
  std::int64_t peak_ = 0;
  std::int64_t allocations_ = 0;
};

}  // namespace halfspace_benchmark
