#pragma once

#include <cstdint>
#include <span>
#include <tuple>

#include "block/bond/bond_point.h"
#include "geometry/vector.h"

namespace halfspace {

template <int D>
class Blocks;

/// The rings of bonds around their corners: blocks meet there that have no face in common. As long as whole
/// points of bonds lead from one to the other around the corner, they are no contact: springs between them
/// would only make the body stiffer.
template <int D>
class BondRings {
 public:
  explicit BondRings(Memory* memory) : members_(memory), links_(memory), faced_(memory) {}

  /// Bonds or blocks are others than before: all rings are to be found anew.
  void invalidate() { is_current_ = 0; }
  bool is_current() const { return is_current_ != 0; }
  /// Finds them where the points of bonds are now. When memory runs out nothing has changed.
  void find(const Blocks<D>& blocks);
  /// Looks at the points again, some of which have broken: true when blocks are no longer held that had been.
  bool look(std::span<const BondPoint<D>> points);
  /// Does a ring hold two blocks that no bond holds?
  bool hold(std::int32_t a, std::int32_t b) const;

  /// All that forces write to.
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
    std::int32_t group = 0;  // members of a ring with the same number are held together
    std::int32_t former_group = 0;

    auto key() const { return std::tie(block, ring); }
  };
  /// Two members that a point of a bond holds, or the mesh that both are of.
  struct Link {
    std::int64_t point = -1;  // -1 for a mesh
    std::int32_t one = 0;     // of the members
    std::int32_t other = 0;
  };
  struct End;
  class Finder;
  void regroup(std::span<const BondPoint<D>> points);

  Array<Member> members_;  // in order of their keys
  Array<Link> links_;
  Array<std::uint64_t>
      faced_;  // pairs of blocks with a face in common, which touch there; in ascending order
  std::int32_t is_current_ = 1;
};

extern template class BondRings<2>;
extern template class BondRings<3>;

}  // namespace halfspace
