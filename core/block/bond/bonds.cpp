#include "block/bond/bonds.h"

#include <algorithm>

#include "block/bond/pair_key.h"
#include "geometry/numbers.h"

namespace halfspace {
template <int D>
void Bonds<D>::add(Bond<D> bond, std::span<const BondPoint<D>> points) {
  make_room_for_one(bonds_);
  if (sorted_.capacity() < bonds_.capacity()) sorted_.reserve(bonds_.capacity());
  const std::size_t wanted = points_.size() + points.size();
  if (points_.capacity() < wanted) points_.reserve(2 * wanted);
  if (events_.capacity() < wanted) events_.reserve(2 * wanted);
  bond.first_point = std::int64_t(points_.size());
  bond.point_count = std::int64_t(points.size());
  bonds_.push_back(bond);
  points_.insert(points_.end(), points.begin(), points.end());
}

template <int D>
void Bonds<D>::take_back_law() {
  laws_.pop_back();
  while (!bonds_.empty() && bonds_.back().law == std::int32_t(laws_.size())) {
    points_.resize(std::size_t(bonds_.back().first_point));
    bonds_.pop_back();
  }
}

template <int D>
void Bonds<D>::index() {
  sorted_.clear();
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    if (bonds_[i].a >= 0) sorted_.push_back({pair_key(bonds_[i].a, bonds_[i].b), std::int64_t(i)});
  }
  std::sort(sorted_.begin(), sorted_.end(), [](const Named& p, const Named& q) {
    return p.pair < q.pair || (p.pair == q.pair && p.bond < q.bond);
  });
}

template <int D>
void Bonds<D>::forget(std::int32_t block) {
  if (!empty()) rings_.invalidate();
  for (Bond<D>& bond : bonds_) {
    if (bond.a == block || bond.b == block) {
      bond.a = bond.b = -1;
      bond.is_joint = bond.hands_over = 0;
    }
  }
}

template <int D>
bool Bonds<D>::keeps(std::int32_t a, std::int32_t b) const {
  const std::uint64_t pair = pair_key(a, b);
  auto named = std::lower_bound(sorted_.begin(), sorted_.end(), pair,
                                [](const Named& p, std::uint64_t wanted) { return p.pair < wanted; });
  for (; named != sorted_.end() && named->pair == pair; ++named) {
    if (bonds_[std::size_t(named->bond)].is_joint) return true;
  }
  return false;
}

template <int D>
void Bonds<D>::weaken(double factor) {
  for (BondLaw& law : laws_) law = law.weaker_by(factor);
}

template <int D>
bool Bonds<D>::is_consistent(std::size_t slots) const {
  const auto is_slot = [&](std::int32_t slot) { return slot >= 0 && std::size_t(slot) < slots; };
  std::int64_t counted = 0;
  for (const Bond<D>& bond : bonds_) {
    const bool is_gone = bond.a < 0 && bond.b < 0 && !bond.is_joint && !bond.hands_over;
    if (!is_gone && !(is_slot(bond.a) && is_slot(bond.b) && bond.a < bond.b)) return false;
    if (bond.law < 0 || std::size_t(bond.law) >= laws_.size()) return false;
    const std::int64_t left = std::int64_t(points_.size()) - counted;
    if (bond.first_point != counted || bond.point_count < 1 || bond.point_count > left) return false;
    if (bond.hands_over && bond.is_joint) return false;
    if (!all_finite(bond.normal_a) || !all_finite(bond.normal_b) || !is_positive(bond.extent)) return false;
    counted += bond.point_count;
  }
  const auto has_failed = [&](const BondEvent<D>& event) {
    return event.bond >= 0 && std::size_t(event.bond) < bonds_.size() && event.point >= 0 &&
           event.point < bonds_[std::size_t(event.bond)].point_count &&
           (event.failure == BondFailure::tension || event.failure == BondFailure::shear);
  };
  return std::size_t(counted) == points_.size() && events_.size() <= points_.size() &&
         halfspace::all(events_, has_failed) && rings_.is_consistent(slots, points_.size()) &&
         halfspace::all(laws_, [](const BondLaw& law) { return law.is_consistent(); }) &&
         halfspace::all(points_, [](const BondPoint<D>& point) { return point.is_consistent(); });
}

template class Bonds<2>;
template class Bonds<3>;

}  // namespace halfspace
