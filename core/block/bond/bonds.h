#pragma once

#include <cstdint>
#include <span>

#include "block/bond/bond_point.h"
#include "block/bond/rings.h"

namespace halfspace {

/// Two blocks bonded along a common face. Without implicit padding.
template <int D>
struct Bond {
  std::int32_t a = -1;  // slots, a < b; -1 after removal
  std::int32_t b = -1;
  std::int32_t law = 0;
  std::int32_t is_joint = 1;  // 0: the bond has separated, and contact replaces it
  std::int64_t first_point = 0;
  std::int64_t point_count = 0;
  Vector<D> normal_a = Vector<D>::Zero();  // of the face, from a to b, in a's frame, and in b's
  Vector<D> normal_b = Vector<D>::Zero();
  double extent = 0;            // of the face
  std::int32_t hands_over = 0;  // 1: its contact still has to take over the shear force
  std::int32_t reserved = 0;
};

/// The failure of a point of a bond. Without implicit padding.
template <int D>
struct BondEvent {
  std::int64_t bond = 0;
  std::int64_t point = 0;  // of the bond
  std::int64_t step = 0;
  BondFailure failure = BondFailure::none;
  std::int32_t reserved = 0;
  double time = 0;
  double area = 0;
  double normal_traction = 0;  // before failure
  double shear_traction = 0;
  double energy = 0;  // released by the failure
  double padding = 0;
  Vector<D> position = Vector<D>::Zero();
  Vector<D> normal = Vector<D>::Zero();
};

/// The bonds of a world, their points in one array, and the failures so far. Empty in worlds without bonds.
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

  /// Returns the index of the law.
  std::int32_t add_law(const BondLaw& law) {
    laws_.push_back(law);
    return std::int32_t(laws_.size()) - 1;
  }
  /// Removes the law added last, and the bonds of that law, which were added after it.
  void take_back_law();
  /// Adds a bond with its points. When memory runs out, nothing has changed. After the last one call index(),
  /// and rings().invalidate().
  void add(Bond<D> bond, std::span<const BondPoint<D>> points);
  /// Rebuilds the search index of keeps().
  void index();
  /// Memory is reserved for one event per point.
  void add_event(const BondEvent<D>& event) { events_.push_back(event); }
  /// Removes the bonds of a removed block.
  void forget(std::int32_t block);
  /// Is there a bond, intact or failed, that replaces the contact of two blocks?
  bool keeps(std::int32_t a, std::int32_t b) const;

  /// Divides all strengths by a factor.
  void weaken(double factor);

  bool are_held() const { return is_held_; }
  void hold(bool is_held) { is_held_ = is_held; }

  /// The state that the evaluation of forces changes.
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
  Array<Named> sorted_;  // by pair, for the search
  BondRings<D> rings_;
  std::int32_t is_held_ = 0;
};

extern template class Bonds<2>;
extern template class Bonds<3>;

}  // namespace halfspace
