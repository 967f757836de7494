#pragma once

#include <algorithm>
#include <cmath>

#include "force/potential/line_of_action.h"
#include "geometry/convex_reach.h"
#include "geometry/outline.h"
#include "narrow_phase/contact.h"

namespace halfspace {

// Springs per area as a field of pressure (Elandt et al. 2019). The block that owns the contact face is a
// fluid: at depth d below that face its pressure is k d, and it acts on the surface of the other block inside
// the owner.
//
//   U = k int d dV over the overlap       the energy
//   F = - k int d n dS over that surface  the force on the other block, the negative gradient of U
//
// The face is the one of either block with the least energy. The minimum of energies is continuous, so a
// contact that turns from one face to another makes no energy, and the sums over blocks with a common joint
// are those over one block. Nothing is remembered, and no third block is asked.

/// The pressure between two overlapping blocks, for k = 1. Positions are relative to the centroid of a.
template <int D>
struct Pressure {
  PotentialPair<D> face{};  // the contact face
  int owner = 0;            // of the face: 0 a, 1 b
  Vector<D> face_normal = Vector<D>::Zero();
  Vector<D> normal = Vector<D>::Zero();    // unit, of the force on b; that of the face but at ends and joints
  double energy = 0;                       // the force is its negative gradient
  double depth = 0;                        // greatest of the overlap
  double base = 0;                         // length or area of the overlap, projected onto the face
  Vector<D> force = Vector<D>::Zero();     // on b, opposite on a
  Tensor<D> virial = Tensor<D>::Zero();    // that force times position^T
  Vector<D> centroid = Vector<D>::Zero();  // of the overlap
  Vector<D> middle = Vector<D>::Zero();    // centroid of the base, at the depth of the overlap's centroid
  Tensor<D> spread = Tensor<D>::Zero();    // mean over the base of r r^T about its centroid

  bool is_empty() const { return base == 0; }
  double normal_force() const { return normal.dot(force); }
  /// On b, with the force in the middle of the base.
  Angular<D> couple() const { return moment(virial) - moment(middle, force); }
  /// From the middle to the centre of pressure, where the force has no couple but about the normal.
  Vector<D> way_to_center() const;

  /// Force times arm^T from the centroid of each block. The fluid strains with the owner of the face.
  Tensor<D> virial_a() const { return owner == 0 ? Tensor<D>(of_fluid() - virial) : Tensor<D>(-virial); }
  Tensor<D> virial_b(const Vector<D>& to_b) const {
    const Tensor<D> pressed = virial - force * to_b.transpose();
    return owner == 1 ? Tensor<D>(of_fluid() + pressed) : pressed;
  }

  /// Bound of the distance between the centre of pressure and the middle of the base, divided by the certain
  /// extent of the base; at most 1. It is 0 for a constant depth. The pressure at ends of the base shifts the
  /// centre besides.
  double unevenness() const {
    const double onto_face = face_normal.dot(force);
    const double mean_square = 2 * energy * base / (onto_face * onto_face);
    const double of_depth = mean_square > 1 ? std::sqrt(mean_square - 1) / certain_reach_of_area : 0;
    return std::min(std::max(of_depth, part_of_extent(way_to_force())), 1.0);
  }

 private:
  Vector<D> way_to_force() const {
    const double here = normal_force();
    return here > 0 ? way_to_line(Vector<D>(here * normal), couple()) : Vector<D>::Zero();
  }
  /// The length of a way along the base over the certain extent of the base that way.
  double part_of_extent(const Vector<D>& way) const {
    const double square = way.squaredNorm(), spread_along = way.dot(spread * way);
    if (square == 0) return 0;
    return spread_along > 0 ? square / (certain_reach_of_area * std::sqrt(spread_along)) : HUGE_VAL;
  }
  /// A common strain of both blocks changes the energy by its trace and by the strain along the face's
  /// normal.
  Tensor<D> of_fluid() const {
    return -energy * (Tensor<D>::Identity() + face_normal * face_normal.transpose());
  }
};

/// It stays within the certain extent of the base, where a small force across it has a long arm.
template <int D>
Vector<D> Pressure<D>::way_to_center() const {
  const Vector<D> way = way_to_force();
  const double part = part_of_extent(way);
  return part > 1 ? Vector<D>(way / part) : way;
}

/// The virials besides those of a resultant at the centre of pressure.
template <int D>
Stretch<D> stretch_besides(const Pressure<D>& pressure, double stiffness, const Vector<D>& to_b) {
  const Vector<D> way = pressure.way_to_center(), center = pressure.middle + way;
  const Angular<D> couple = pressure.couple() - moment(way, pressure.force);
  return {stiffness * (pressure.virial_a() + virial_of<D>(pressure.force, center, couple, pressure.normal)),
          stiffness * (pressure.virial_b(to_b) -
                       virial_of<D>(pressure.force, center - to_b, couple, pressure.normal))};
}

/// Working memory. After growth to the largest blocks it allocates nothing.
template <int D>
struct PressureRoom;

/// `near`: a pair where the search starts; any is right. The search from the pair of the result has the same
/// bits. The pressure is 0 where the overlap has no area or volume.
Pressure<2> pressure_between(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                             const PotentialPair<2>& near, PressureRoom<2>& room);
Pressure<3> pressure_between(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                             const PotentialPair<3>& near, PressureRoom<3>& room);

}  // namespace halfspace
