#pragma once

#include <memory>
#include <tuple>

#include "world/world.h"

namespace halfspace {

/// Copies of all that a tuple refers to, with arrays in the given memory. To assign them back takes none:
/// every array has room for what it held.
template <class... T>
std::tuple<T...> copies_of(const std::tuple<T&...>& originals, Memory* memory) {
  return {std::allocator_arg, std::pmr::polymorphic_allocator<std::byte>(memory), originals};
}

/// All that a step of a changed world writes to before it moves the blocks, but for the pairs and what is
/// worked out anew from the rest.
template <int D>
auto World<D>::state() {
  return std::tuple_cat(contacts_.state(), forces_.state(), ledger_.state(), clock_.epoch(),
                        model_.blocks.bonds().state(), model_.blocks.meshes().state(),
                        std::tie(peak_speed_, bond_strain_energy_, edited_));
}

}  // namespace halfspace
