#pragma once

// A host's allocator for tests; to be linked with calls_of_new.cpp, which counts those of operator new.

#include <halfspace/halfspace.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <stdexcept>

#include "calls_of_new.h"

namespace halfspace_test {

/// Counts, checks sizes and alignments, and fails on request.
class Ledger {
 public:
  hs_context_def definition() {
    hs_context_def def;
    if (hs_context_def_init(&def, sizeof def) != HS_OK) throw std::runtime_error("no context definition");
    def.allocate = [](std::size_t bytes, std::size_t alignment, void* user) {
      return static_cast<Ledger*>(user)->allocate(bytes, alignment);
    };
    def.release = [](void* memory, std::size_t bytes, std::size_t alignment, void* user) {
      static_cast<Ledger*>(user)->release(memory, bytes, alignment);
    };
    def.user = this;
    return def;
  }

  long allocations = 0;
  long fail_at = -1;  // the allocation with this number gets nothing
  long mismatches = 0;
  std::size_t bytes_in_use() const {
    std::size_t sum = 0;
    for (const auto& [memory, piece] : live_) sum += piece.bytes;
    return sum;
  }

 private:
  struct Piece {
    std::size_t bytes, alignment;
  };

  void* allocate(std::size_t bytes, std::size_t alignment) {
    if (allocations++ == fail_at) return nullptr;
    const bool is_power_of_two = alignment > 0 && (alignment & (alignment - 1)) == 0;
    if (!is_power_of_two) ++mismatches;
    void* memory = nullptr;
    if (posix_memalign(&memory, std::max(alignment, sizeof(void*)), std::max<std::size_t>(bytes, 1)) != 0)
      return nullptr;
    std::memset(memory, 0xee, bytes);  // nobody may count on zeros
    const long calls = calls_of_new;   // the ledger's own do not count
    live_[memory] = {bytes, alignment};
    calls_of_new = calls;
    return memory;
  }

  void release(void* memory, std::size_t bytes, std::size_t alignment) {
    const auto found = live_.find(memory);
    if (found == live_.end() || found->second.bytes != bytes || found->second.alignment != alignment) {
      ++mismatches;
      return;
    }
    live_.erase(found);
    std::free(memory);
  }

  std::map<void*, Piece> live_;
};

}  // namespace halfspace_test
