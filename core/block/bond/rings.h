#pragma once

#include <cstdint>
#include <span>
#include <tuple>

#include "block/bond/bond_point.h"
#include "geometry/vector.h"

namespace halfspace {

template <int D>
class Blocks;

/// Rings of bonds around corners where blocks meet without a common face. While intact points of bonds
/// connect two blocks around the corner, the blocks are not in contact: contact springs would only stiffen
/// the body.
template <int D>
class BondRings {
 public:
  explicit BondRings(Memory* memory) : members_(memory), links_(memory), faced_(memory) {}

  /// Bonds or blocks have changed: there are no rings until they are found again.
  void invalidate() {
    members_.clear();
    links_.clear();
    is_current_ = 0;
  }
  bool is_current() const { return is_current_ != 0; }
  /// Finds the rings at the present places of the points. When memory runs out, nothing has changed.
  void find(const Blocks<D>& blocks);
  /// Updates the rings after points have failed. Returns true when a pair is no longer held.
  bool look(std::span<const BondPoint<D>> points);
  /// Does a ring join two blocks without a bond of their own?
  bool hold(std::int32_t a, std::int32_t b) const;

  /// The state that the evaluation of forces changes.
  auto& groups() { return members_; }

  bool is_consistent(std::size_t slots, std::size_t points) const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(members_, links_, faced_, is_current_);
  }

 private:
  struct Member {
    std::int32_t block = -1;
    std::int32_t ring = 0;
    std::int32_t group = 0;  // members of a ring with the same number are joined
    std::int32_t former_group = 0;

    auto key() const { return std::tie(block, ring); }
  };
  /// Two members joined by a point of a bond, or by their mesh.
  struct Link {
    std::int64_t point = -1;  // -1 for a mesh
    std::int32_t one = 0;     // of the members
    std::int32_t other = 0;
  };
  struct End;
  class Finder;
  void regroup(std::span<const BondPoint<D>> points);

  Array<Member> members_;  // sorted by key()
  Array<Link> links_;
  Array<std::uint64_t> faced_;  // pairs of blocks with a common face, which may touch there; ascending
  std::int32_t is_current_ = 1;
};

extern template class BondRings<2>;
extern template class BondRings<3>;

}  // namespace halfspace
