#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <tuple>

#include "world/motion/velocity_change.h"

namespace halfspace {

/// The features by which two blocks meet. The values are those of the C API's HS_PAIR_.
enum class Meeting : std::int32_t { corner_and_face = 1, edges = 2 };

/// Two points of two blocks that meet without any spring: the force between them is the one that keeps them
/// apart (Li et al. 2015, section 4). There is no gap between members.
template <int D>
struct ContactConstraint {
  std::int32_t a = -1;  // slot of the block whose corner it is, or of the first of two edges
  std::int32_t b = -1;  // slot of the block whose face it is, or of the second edge
  Meeting meeting = Meeting::corner_and_face;
  std::int32_t feature_a = 0;      // corner or edge of a
  std::int32_t feature_b = 0;      // face or edge of b
  std::int32_t is_bonded = 0;      // pulls and coheres, as long as it has not failed
  std::int32_t is_persistent = 0;  // from the motion before
  std::int32_t is_new_impact = 0;  // in this motion
  MaterialPoint<D> of_a;
  MaterialPoint<D> of_b;
  Vector<D> normal = Vector<D>::Zero();   // unit, outwards from b
  Vector<D> impulse = Vector<D>::Zero();  // on a, of the coming or the last kick
  Vector<D> force = Vector<D>::Zero();    // on a, that the kick at the end of the last motion stands for
  double touched_at = 0;                  // time
  double gap = 0;                         // > 0 apart
  double area = 0;                        // that it stands for; 0 unless it is bonded
  double stored_normal_work = 0;          // J: see HardContacts::stop()

  // Between two kicks.
  Vector<D> velocity = Vector<D>::Zero();                 // of a against b, that is to be stopped
  Vector<D> applied_velocity_change = Vector<D>::Zero();  // by other forces, in half of the motion
  Vector<D> approach_velocity =
      Vector<D>::Zero();  // that the second kick would meet, had no blow strained any element
  Vector<D> previous_impulse = Vector<D>::Zero();          // two rounds ago
  Vector<D> course = Vector<D>::Zero();                    // of the impulse, from round to round
  Vector<D> normal_velocity_response = Vector<D>::Zero();  // that velocity over a normal impulse
  double normal_inverse_mass = 0;
  double shear_inverse_mass = 0;
  double tan_friction = 0;
  double tension_limit = 0;    // normal impulse that pulls
  double cohesion_limit = 0;   // shear impulse without pressure
  double gap_floor = 0;        // allowed at the end of the motion: 0, unless it began deeper
  double impact_fraction = 0;  // of the motion, before they touch
  double impact_loss = 0;      // J, that it loses in this motion

  /// Is strength reached where it still moves on, at the velocity that is left?
  bool fails(const Vector<D>& left) const;

  auto key() const { return std::tie(a, b, meeting, feature_a, feature_b); }
};

static_assert(sizeof(ContactConstraint<2>) == 368 && sizeof(ContactConstraint<3>) == 472,
              "saved reactions hold stray bytes");

/// Finds the impulses of all together that stop what has to be stopped: no normal one pulls, and no shear one
/// is larger, than strength bears; and as far as neither is at its bound, nothing moves on. Impulses that are
/// there already are where it begins.
///
/// By turns (Gauss and Seidel), led on by conjugate gradients, with the blocks' changes of velocity at hand,
/// so that a contact costs the same whatever the number of them. Returns how often all have been gone
/// through.
template <int D>
int solve_constraints(std::span<ContactConstraint<D>> reactions, VelocityChange<D>& kicks);

extern template int solve_constraints(std::span<ContactConstraint<2>>, VelocityChange<2>&);
extern template int solve_constraints(std::span<ContactConstraint<3>>, VelocityChange<3>&);

}  // namespace halfspace
