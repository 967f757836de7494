#pragma once

#include <cstdint>
#include <span>

#include "geometry/vector.h"
#include "world/motion/islands.h"

namespace halfspace {

/// The contacts of an impulse problem by islands: moving blocks that contacts connect. Impulses of one island
/// do not depend on those of another. Islands have numbers, in order of their first contacts.
class ContactIslands {
 public:
  explicit ContactIslands(Memory* memory)
      : joined_(memory), of_block_(memory), of_contact_(memory), order_(memory), end_(memory) {}

  /// Finds the islands of contacts between so many blocks.
  template <class Contacts>
  void find(const Contacts& contacts, std::size_t blocks) {
    joined_.begin(blocks);
    for (const auto& contact : contacts) {
      if (contact.inverse_mass_a > 0 && contact.inverse_mass_b > 0) joined_.join(contact.a, contact.b);
    }
    of_block_.assign(blocks, -1);
    of_contact_.clear();
    end_.clear();
    for (const auto& contact : contacts) {
      std::int32_t& number = of_block_[std::size_t(joined_.head_of(contact.free_block()))];
      if (number < 0) {
        number = std::int32_t(end_.size());
        end_.push_back(0);
      }
      of_contact_.push_back(number);
      ++end_[std::size_t(number)];
    }
    for (std::size_t i = 0; i < blocks; ++i)
      of_block_[i] = of_block_[std::size_t(joined_.head_of(std::int32_t(i)))];
    sort();
  }

  std::size_t count() const { return end_.size(); }
  std::size_t of_contact(std::size_t contact) const { return std::size_t(of_contact_[contact]); }
  /// -1 for a block that has no contact.
  std::int32_t of_block(std::int32_t block) const { return of_block_[std::size_t(block)]; }
  /// In their order.
  std::span<const std::int32_t> contacts_of(std::size_t island) const {
    const std::size_t first = island == 0 ? 0 : std::size_t(end_[island - 1]);
    return {order_.data() + first, std::size_t(end_[island]) - first};
  }

 private:
  /// Sorts contacts by their islands; `end_` contains the count of each.
  void sort() {
    std::int32_t next = 0;
    for (std::int32_t& end : end_) {
      const std::int32_t size = end;
      end = next;
      next += size;
    }
    order_.resize(of_contact_.size());
    for (std::size_t c = 0; c < of_contact_.size(); ++c)
      order_[std::size_t(end_[of_contact(c)]++)] = std::int32_t(c);
  }

  Islands joined_;
  Array<std::int32_t> of_block_;    // the number of its island, or -1
  Array<std::int32_t> of_contact_;  // likewise
  Array<std::int32_t> order_;       // contacts by island
  Array<std::int32_t> end_;         // of each island in `order_`
};

}  // namespace halfspace
