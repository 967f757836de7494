#pragma once

#include <cstdint>
#include <span>

#include "block/bond/bond_point.h"
#include "block/bond/rings.h"

namespace halfspace {

/// Two blocks that hold together along a common face. There is no gap between members.
template <int D>
struct Bond {
  std::int32_t a = -1;  // slots, a < b; -1 when one has been removed
  std::int32_t b = -1;
  std::int32_t law = 0;
  std::int32_t is_joint = 1;  // 0: it has come apart, and contact has taken over
  std::int64_t first_point = 0;
  std::int64_t point_count = 0;
  Vector<D> normal_a = Vector<D>::Zero();  // of the face, from a to b, in a's frame, and in b's
  Vector<D> normal_b = Vector<D>::Zero();
  double extent = 0;            // of the face
  std::int32_t hands_over = 0;  // 1: its contact does not know its shear force yet
  std::int32_t reserved = 0;
};

/// A point of a bond that has failed. There is no gap between members.
template <int D>
struct BondEvent {
  std::int64_t bond = 0;
  std::int64_t point = 0;  // of the bond
  std::int64_t step = 0;
  BondFailure failure = BondFailure::none;
  std::int32_t reserved = 0;
  double time = 0;
  double area = 0;
  double normal_traction = 0;  // that it bore before
  double shear_traction = 0;
  double energy = 0;  // lost at once
  double padding = 0;
  Vector<D> position = Vector<D>::Zero();
  Vector<D> normal = Vector<D>::Zero();
};

/// The bonds of a world, with their points side by side, and what has failed so far. A world without any has
/// none of it.
template <int D>
class Bonds {
 public:
  explicit Bonds(Memory* memory)
      : laws_(memory), bonds_(memory), points_(memory), events_(memory), sorted_(memory), rings_(memory) {}

  bool empty() const { return bonds_.empty(); }
  Array<Bond<D>>& all() { return bonds_; }
  const Array<Bond<D>>& all() const { return bonds_; }
  const Array<BondLaw>& laws() const { return laws_; }
  const BondLaw& law_of(const Bond<D>& bond) const { return laws_[std::size_t(bond.law)]; }
  std::span<BondPoint<D>> points_of(const Bond<D>& bond) {
    return {points_.data() + bond.first_point, std::size_t(bond.point_count)};
  }
  std::span<const BondPoint<D>> points_of(const Bond<D>& bond) const {
    return {points_.data() + bond.first_point, std::size_t(bond.point_count)};
  }
  std::span<const BondPoint<D>> points() const { return points_; }
  const Array<BondEvent<D>>& events() const { return events_; }
  BondRings<D>& rings() { return rings_; }
  const BondRings<D>& rings() const { return rings_; }

  /// Returns the law's number.
  std::int32_t add_law(const BondLaw& law) {
    laws_.push_back(law);
    return std::int32_t(laws_.size()) - 1;
  }
  /// Takes the law back that was added last, with all bonds that have it; they were added since.
  void take_back_law();
  /// Takes a bond in, with its points. When memory runs out nothing has changed. Call index() when all are
  /// in.
  void add(Bond<D> bond, std::span<const BondPoint<D>> points);
  /// Makes keeps() know of the bonds.
  void index();
  /// There is room for one event of each point.
  void add_event(const BondEvent<D>& event) { events_.push_back(event); }
  /// Ends the bonds of a block that is removed.
  void forget(std::int32_t block);
  /// Is there a bond, whole or failed, that keeps two blocks from being a contact?
  bool keeps(std::int32_t a, std::int32_t b) const;

  /// Divides all strengths by a factor.
  void weaken(double factor);

  bool are_held() const { return is_held_; }
  void hold(bool is_held) { is_held_ = is_held; }

  /// All that forces write to.
  auto state() { return std::tie(bonds_, points_, events_, rings_.groups()); }

  bool is_consistent(std::size_t slots) const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(laws_, bonds_, points_, events_, is_held_, rings_);
    if constexpr (Archive::reads) {
      events_.reserve(points_.size());
      sorted_.reserve(bonds_.size());
      index();
    }
  }

 private:
  struct Named {
    std::uint64_t pair;
    std::int64_t bond;
  };

  Array<BondLaw> laws_;
  Array<Bond<D>> bonds_;
  Array<BondPoint<D>> points_;
  Array<BondEvent<D>> events_;
  Array<Named> sorted_;  // by their pairs, for the search
  BondRings<D> rings_;
  std::int32_t is_held_ = 0;
};

extern template class Bonds<2>;
extern template class Bonds<3>;

}  // namespace halfspace
