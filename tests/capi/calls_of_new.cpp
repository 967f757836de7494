// The C++ allocator of the whole process, what it is linked with included, counts its calls.

#include "calls_of_new.h"

#include <cstdlib>
#include <new>

std::atomic<long> halfspace_test::calls_of_new{0};
using halfspace_test::calls_of_new;

void* operator new(std::size_t bytes) {
  ++calls_of_new;
  if (void* memory = std::malloc(bytes ? bytes : 1)) return memory;
  throw std::bad_alloc();
}
void* operator new[](std::size_t bytes) { return operator new(bytes); }
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  ++calls_of_new;
  return std::malloc(bytes);
}
void* operator new[](std::size_t bytes, const std::nothrow_t& nothrow) noexcept {
  return operator new(bytes, nothrow);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
