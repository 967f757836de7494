#pragma once

#include <memory>
#include <tuple>

#include "geometry/vector.h"

namespace halfspace {

/// Copies of all that a tuple refers to, with arrays in the given memory. To assign them back takes none:
/// every array has room for what it held.
template <class... T>
std::tuple<T...> copies_of(const std::tuple<T&...>& originals, Memory* memory) {
  return {std::allocator_arg, std::pmr::polymorphic_allocator<std::byte>(memory), originals};
}

}  // namespace halfspace
