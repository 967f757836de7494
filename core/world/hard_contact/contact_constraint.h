#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <tuple>

#include "world/hard_contact/conjugate_direction.h"
#include "world/motion/velocity_change.h"

namespace halfspace {

/// The features by which two blocks meet. The values are those of the C API's HS_PAIR_.
enum class Meeting : std::int32_t { corner_and_face = 1, edges = 2 };

/// A contact of a law without springs, as it is kept from step to step, listed and saved. There is no gap
/// between members.
template <int D>
struct PointContact {
  std::int32_t a = -1;  // slot of the block of the vertex, or of the first of two edges
  std::int32_t b = -1;  // slot of the block of the face, or of the second edge
  Meeting meeting = Meeting::corner_and_face;
  std::int32_t feature_a = 0;  // vertex or edge of a
  std::int32_t feature_b = 0;  // face or edge of b
  std::int32_t is_bonded = 0;  // carries tension and cohesion until it fails
  double touched_at = 0;       // time
  MaterialPoint<D> of_a;
  MaterialPoint<D> of_b;
  Vector<D> normal = Vector<D>::Zero();   // unit, outwards from b
  Vector<D> impulse = Vector<D>::Zero();  // on a, in the coming or the last half step
  Vector<D> force = Vector<D>::Zero();    // on a, of the half step at the end of the last motion
  double gap = 0;                         // > 0 apart
  double area = 0;                        // of the face that it represents; 0 unless it is bonded
  double stored_normal_work = 0;          // J: see PointContacts::stop_approach()
  double impact_loss = 0;                 // J, in the last motion

  auto key() const { return std::tie(a, b, meeting, feature_a, feature_b); }
};

static_assert(sizeof(PointContact<2>) == 208 && sizeof(PointContact<3>) == 264,
              "saved contacts hold stray bytes");

/// A unilateral constraint between two points of two blocks; the contact force is its multiplier (Li et al.
/// 2015, section 4). What it adds to the contact is of the present motion only.
template <int D>
struct ContactConstraint : PointContact<D> {
  bool is_persistent = false;                             // from the motion before
  bool is_new_impact = false;                             // in this motion
  Vector<D> velocity = Vector<D>::Zero();                 // of a against b, without the impulses
  Vector<D> applied_velocity_change = Vector<D>::Zero();  // by other forces, in half of the motion
  Vector<D> approach_velocity =
      Vector<D>::Zero();  // before the second half step, without the strain of impacts
  Vector<D> previous_impulse = Vector<D>::Zero();          // two iterations ago
  Vector<D> direction = Vector<D>::Zero();                 // search direction of the impulse
  Vector<D> normal_velocity_response = Vector<D>::Zero();  // velocity change per unit normal impulse
  double normal_inverse_mass = 0;                          // inverse effective mass along the normal
  double shear_inverse_mass = 0;                           // and across it
  double tan_friction = 0;
  double tension_limit = 0;    // largest tensile impulse
  double cohesion_limit = 0;   // largest shear impulse at zero normal impulse
  double gap_floor = 0;        // least gap allowed at the end of the motion: 0, unless it began deeper
  double impact_fraction = 0;  // of the motion that has passed at the touch

  /// Is its strength reached while it still opens or slips, at the velocity that remains?
  bool fails(const Vector<D>& left) const;
};

/// Constraints as rows of AcceleratedSweeps, on the blocks' changes of velocity. Their impulses are normal
/// ones within the tension limit and shear ones within friction and cohesion, and leave no relative velocity
/// where neither is at its limit. The impulses given are the warm start.
template <int D>
class PointRows {
 public:
  PointRows(std::span<ContactConstraint<D>> constraints, VelocityChange<D>& changes)
      : constraints_(constraints), changes_(changes) {}

  /// Applies the warm start. Returns the largest velocity by an impulse of it.
  double begin();
  /// Returns the largest change, as a velocity.
  double sweep(bool is_backwards);
  /// The change of the impulses since the last acceleration, in the metric of the inverse masses.
  double squared_change() const;
  void accelerate(const ConjugateDirection& direction);

 private:
  std::span<ContactConstraint<D>> constraints_;
  VelocityChange<D>& changes_;
};

extern template class PointRows<2>;
extern template class PointRows<3>;

}  // namespace halfspace
