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

/// The pressure between two overlapping blocks, for k = 1.
template <int D>
struct Pressure {
  PotentialPair<D> face{};                 // the contact face
  Vector<D> normal = Vector<D>::Zero();    // of the face: unit, from a to b
  double energy = 0;                       // the force is its negative gradient
  double base = 0;                         // length or area of the overlap, projected onto the face
  Vector<D> force = Vector<D>::Zero();     // on b, opposite on a
  Tensor<D> virial_a = Tensor<D>::Zero();  // force times arm^T from the centroid of a
  Tensor<D> virial_b = Tensor<D>::Zero();  // and from that of b
  Vector<D> middle = Vector<D>::Zero();    // centroid of the base, on the face; relative to the centroid of a
  Tensor<D> spread = Tensor<D>::Zero();    // mean over the base of r r^T about its centroid

  bool is_empty() const { return base == 0; }
  double normal_force() const { return normal.dot(force); }
  Vector<D> lateral_force() const { return force - normal_force() * normal; }
  /// On b, with the force in the middle of the base.
  Angular<D> couple(const Vector<D>& to_b) const { return moment(virial_b) - moment(middle - to_b, force); }
  /// From the middle to the centre of pressure, where the force has no couple but about the normal.
  Vector<D> way_to_center(const Vector<D>& to_b) const;

  /// Bound of the distance between the centre of pressure and the middle of the base, divided by the certain
  /// extent of the base; at most 1. It is 0 for a constant depth; in 2D 1/3 for one that is 0 at one end.
  double unevenness() const {
    const double mean_square = 2 * energy * base / (normal_force() * normal_force());
    return mean_square > 1 ? std::min(std::sqrt(mean_square - 1) / certain_reach(D - 1), 1.0) : 0;
  }
};

/// It stays within the certain extent of the base, where a small force across it has a long arm.
template <int D>
Vector<D> Pressure<D>::way_to_center(const Vector<D>& to_b) const {
  const double force_here = normal_force();
  if (!(force_here > 0)) return Vector<D>::Zero();
  const Vector<D> way = way_to_line(Vector<D>(force_here * normal), couple(to_b));
  const double most = certain_reach(D - 1) * std::sqrt(std::max(spread.trace(), 0.0)), length = way.norm();
  return length > most ? Vector<D>(most / length * way) : way;
}

/// The virials besides those of a resultant at the centre of pressure.
template <int D>
Stretch<D> stretch_besides(const Pressure<D>& pressure, double stiffness, const Vector<D>& to_b) {
  const Vector<D> way = pressure.way_to_center(to_b), center = pressure.middle + way;
  const Angular<D> couple = pressure.couple(to_b) - moment(way, pressure.force);
  return {
      stiffness * (pressure.virial_a + virial_of<D>(pressure.force, center, couple, pressure.normal)),
      stiffness * (pressure.virial_b - virial_of<D>(pressure.force, center - to_b, couple, pressure.normal))};
}

/// Working memory. After growth to the largest blocks it allocates nothing.
template <int D>
struct PressureRoom;

/// A corner of the overlap in the plane, and the side that starts there.
struct OverlapCorner {
  Vector<2> at;      // relative to the centroid of a
  Vector<2> normal;  // of the side, out of the overlap
  int block;         // that the side belongs to: 0 a, 1 b
  bool is_shared;    // the side lies on one of the other block, too
};

template <>
struct PressureRoom<2> {
  explicit PressureRoom(Memory* memory) : overlap(memory), clipped(memory) {}

  /// Reserves for two blocks of up to `edges` edges.
  void reserve(std::size_t edges) {
    overlap.reserve(2 * edges);
    clipped.reserve(2 * edges);
  }

  Array<OverlapCorner> overlap;
  Array<OverlapCorner> clipped;
};

/// A face of the overlap in space: its corners in the room, counter-clockwise seen from outside.
struct OverlapFace {
  Vector<3> normal;  // out of the overlap
  int block;         // that the face belongs to: 0 a, 1 b
  bool is_shared;    // the face lies on one of the other block, which is listed, too
  std::int32_t first;
  std::int32_t end;
};

template <>
struct PressureRoom<3> {
  explicit PressureRoom(Memory* memory)
      : near_a(memory), near_b(memory), faces(memory), corners(memory), polygon(memory), clipped(memory) {}

  /// Reserves for two blocks of up to `edges` edges. The overlap is convex: with the faces of both blocks, at
  /// most two thirds of their edges, it has at most three times as many edges, each a side of two faces.
  void reserve(std::size_t edges) {
    near_a.reserve(edges);
    near_b.reserve(edges);
    faces.reserve(2 * edges);
    corners.reserve(8 * edges);
    polygon.reserve(3 * edges);
    clipped.reserve(3 * edges);
  }

  Array<std::int32_t> near_a;  // faces of a that may bound the overlap
  Array<std::int32_t> near_b;
  Array<OverlapFace> faces;
  Array<Vector<3>> corners;
  Array<Vector<3>> polygon;
  Array<Vector<3>> clipped;
};

/// `near`: a face of the contact and its deepest vertex, where the search starts; any pair that overlaps is
/// right. The pressure is 0 where the overlap has no area or volume.
Pressure<2> pressure_between(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                             const PotentialPair<2>& near, PressureRoom<2>& room);
Pressure<3> pressure_between(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                             const PotentialPair<3>& near, PressureRoom<3>& room);

}  // namespace halfspace
