#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "block/bond/bond_law.h"
#include "geometry/finite.h"
#include "geometry/vector.h"

namespace halfspace {

/// The way in which a point of a bond has failed, or none. The values are those of the C API.
enum class BondFailure : std::int32_t { none = 0, tension = 1, shear = 2 };

/// An integration point of a bond: where it is in both blocks, and what has become of it. There is no gap
/// between members: a saved one holds no stray bytes.
template <int D>
struct BondPoint {
  Vector<D> on_a = Vector<D>::Zero();  // in the shapes' frames
  Vector<D> on_b = Vector<D>::Zero();
  Vector<D> slid = Vector<D>::Zero();   // slip without a spring force, in a's frame as a is turned
  Vector<D> shear = Vector<D>::Zero();  // traction on b, in space, of the last forces
  double area = 0;
  double normal_traction = 0;  // > 0 in tension, of the last forces
  double widest = 0;           // opening so far, while strength fades
  double faded_slip = 0;       // likewise
  double damage = 0;           // share of the strength that is gone
  BondFailure failure = BondFailure::none;
  std::int32_t reserved = 0;

  bool is_broken() const { return damage >= 1; }
  bool is_consistent() const {
    return all_finite(on_a) && all_finite(on_b) && all_finite(slid) && all_finite(shear) &&
           is_positive(area) && is_finite(normal_traction) && is_nonnegative(widest) &&
           is_nonnegative(faded_slip) && is_fraction(damage, 1) && failure >= BondFailure::none &&
           failure <= BondFailure::shear;
  }
};

/// The answer of a bond's point to an opening and an elastic slip, per area.
template <int D>
struct BondTraction {
  double normal = 0;                    // > 0 in tension
  Vector<D> shear = Vector<D>::Zero();  // as the slip
  double energy = 0;                    // of the springs
  double fracture_loss = 0;             // of this motion
  double friction_loss = 0;
  bool breaks = false;  // now
};

/// Works out the traction of a point, and what becomes of it. `slip` is that since the springs were without
/// force; what it loses of that is `yielded`. A held bond never fails.
template <int D>
BondTraction<D> traction_of(const BondLaw& law, double opening, const Vector<D>& slip, bool is_held,
                            BondPoint<D>& point, Vector<D>& yielded);

extern template BondTraction<2> traction_of(const BondLaw&, double, const Vector<2>&, bool, BondPoint<2>&,
                                            Vector<2>&);
extern template BondTraction<3> traction_of(const BondLaw&, double, const Vector<3>&, bool, BondPoint<3>&,
                                            Vector<3>&);

}  // namespace halfspace
