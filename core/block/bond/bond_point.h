#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "block/bond/bond_law.h"
#include "geometry/finite.h"
#include "geometry/vector.h"

namespace halfspace {

/// The failure mode of a point of a bond. The values are those of the C API.
enum class BondFailure : std::int32_t { none = 0, tension = 1, shear = 2 };

/// An integration point of a bond: its places in both blocks, and its state. Without implicit padding, so
/// that all saved bytes are defined.
template <int D>
struct BondPoint {
  Vector<D> on_a = Vector<D>::Zero();  // in the frames of the shapes
  Vector<D> on_b = Vector<D>::Zero();
  Vector<D> slid = Vector<D>::Zero();   // slip without spring force, in a's rotating frame
  Vector<D> shear = Vector<D>::Zero();  // traction on b, in the world's frame, at the last evaluation
  double area = 0;
  double normal_traction = 0;  // > 0 in tension, at the last evaluation
  double widest = 0;           // largest opening so far, during softening
  double faded_slip = 0;       // slip so far, during softening
  double damage = 0;           // fraction of the strength that is lost
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

/// Traction and energies of a point per area, for an opening and an elastic slip.
template <int D>
struct BondTraction {
  double normal = 0;                    // > 0 in tension
  Vector<D> shear = Vector<D>::Zero();  // in the direction of the slip
  double energy = 0;                    // of the springs
  double fracture_loss = 0;             // in this evaluation
  double friction_loss = 0;
  bool breaks = false;  // in this evaluation
};

/// Computes the traction of a point and updates its state. `slip` is measured from the force-free state;
/// `yielded` returns its inelastic part. A held bond never fails.
template <int D>
BondTraction<D> traction_of(const BondLaw& law, double opening, const Vector<D>& slip, bool is_held,
                            BondPoint<D>& point, Vector<D>& yielded);

extern template BondTraction<2> traction_of(const BondLaw&, double, const Vector<2>&, bool, BondPoint<2>&,
                                            Vector<2>&);
extern template BondTraction<3> traction_of(const BondLaw&, double, const Vector<3>&, bool, BondPoint<3>&,
                                            Vector<3>&);

}  // namespace halfspace
