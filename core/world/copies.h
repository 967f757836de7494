#pragma once

#include <memory>
#include <tuple>

#include "geometry/vector.h"

namespace halfspace {

/// Copies of all objects that a tuple refers to, with arrays in the given memory. Assigning them back
/// allocates nothing, because every array keeps its capacity.
template <class... T>
std::tuple<T...> copies_of(const std::tuple<T&...>& originals, Memory* memory) {
  return {std::allocator_arg, std::pmr::polymorphic_allocator<std::byte>(memory), originals};
}

}  // namespace halfspace
