#pragma once

#include <cstdint>
#include <span>

#include "geometry/pose.h"
#include "geometry/vector.h"

namespace halfspace {

/// A convex part of a compound: a slot with an outline and contacts of its own that shares the motion of the
/// compound's slot. Without implicit padding.
template <int D>
struct Part {
  Pose<D> pose;                // of its shape, in the frame of the compound with its centroid as the origin
  std::int32_t block = -1;     // slot
  std::int32_t compound = -1;  // slot
  std::int64_t reserved = 0;
};
static_assert(sizeof(Part<2>) == 48 && sizeof(Part<3>) == 112, "saved parts hold stray bytes");

/// The compounds of a world: concave blocks of several convex parts. Empty in worlds without any.
template <int D>
class Compounds {
 public:
  explicit Compounds(Memory* memory) : parts_(memory), of_block_(memory), compound_of_(memory) {}

  bool empty() const { return parts_.empty(); }
  /// Those of one compound follow each other.
  std::span<const Part<D>> parts() const { return parts_; }
  std::span<const Part<D>> parts_of(std::size_t compound) const;
  const Part<D>& part_of_block(std::size_t slot) const { return parts_[std::size_t(of_block_[slot])]; }

  /// The index of a part among those of its compound.
  std::int32_t index_in_compound(std::size_t part) const {
    return of_block_[part] - of_block_[std::size_t(compound_of_[part])];
  }

  /// The compound of a part, a compound itself, or -1 for other blocks.
  std::int32_t compound_of(std::size_t slot) const {
    return slot < compound_of_.size() ? compound_of_[slot] : -1;
  }
  bool is_part(std::size_t slot) const {
    const std::int32_t compound = compound_of(slot);
    return compound >= 0 && compound != std::int32_t(slot);
  }
  bool is_compound(std::size_t slot) const { return compound_of(slot) == std::int32_t(slot); }
  bool are_joined(std::size_t a, std::size_t b) const {
    const std::int32_t compound = compound_of(a);
    return compound >= 0 && compound == compound_of(b);
  }

  /// Allocates for a compound of so many parts, whichever slots below `slots` they get.
  void make_room(std::size_t parts, std::size_t slots);
  /// Adds a compound, then its parts. Allocates nothing after make_room().
  void add(std::int32_t compound);
  void add(const Part<D>& part);
  /// Removes a compound with its parts.
  void remove(std::int32_t compound);

  /// False for data of a damaged snapshot, given the number of slots.
  bool is_consistent(std::size_t slots) const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(parts_, of_block_, compound_of_);
  }

 private:
  void set_compound(std::int32_t slot, std::int32_t compound);
  void index_parts();

  Array<Part<D>> parts_;
  // Per slot, up to that of the last compound or part:
  Array<std::int32_t> of_block_;     // index in parts_, of a compound that of its first part, or -1
  Array<std::int32_t> compound_of_;  // as compound_of() returns it
};

extern template class Compounds<2>;
extern template class Compounds<3>;

}  // namespace halfspace
