#pragma once

#include "force/law.h"
#include "force/spring/pressure.h"

namespace halfspace {

/// A block of the pair, relative to the centroid of a.
template <int D>
struct PlacedOutline {
  const Outline<D>& outline;
  Vector<D> at;
  int block;  // 0 a, 1 b

  Vector<D> vertex(int v) const { return outline.vertex(v) + at; }
};

/// A face as the surface of a fluid, which its block is.
template <int D>
struct PressureFace {
  Vector<D> normal;
  double offset;
  double flush;  // a smaller distance counts as none

  PressureFace(const PlacedOutline<D>& owner, int face)
      : normal(owner.outline.normal(face)),
        offset(owner.outline.offset[face] + normal.dot(owner.at)),
        flush(touch_reach * owner.outline.offset[face]) {}

  double depth(const Vector<D>& p) const { return offset - normal.dot(p); }
};

/// The greatest depth of points below a face; any value above the limit if it is greater. `place` gives the
/// place of a point.
template <int D, class Points, class Place>
double greatest_depth(const PressureFace<D>& face, const Points& points, double limit, Place place) {
  double deepest = 0;
  for (const auto& point : points) {
    deepest = std::max(deepest, face.depth(place(point)));
    if (deepest > limit) break;
  }
  return deepest;
}

/// The face of either block with the least energy.
struct LeastFace {
  int block = 0;  // that owns it: 0 a, 1 b
  int face = -1;
  double energy = HUGE_VAL;

  bool is_found() const { return energy > 0 && energy < HUGE_VAL; }
};

/// `depth_below(face, limit)`: the greatest depth of the overlap, any value above the limit if it is greater.
/// `energy_below(face)`. The mean depth of a convex overlap lies between its greatest depth and 1 / (D + 1)
/// of it: a face whose greatest depth is more than D + 1 times the least one has not the least energy.
template <int D, class Depth, class Energy>
LeastFace least_face(const PlacedOutline<D> (&blocks)[2], Depth depth_below, Energy energy_below) {
  double least_depth = HUGE_VAL;
  for (const PlacedOutline<D>& owner : blocks) {
    for (int f = 0; f < owner.outline.face_count(); ++f)
      least_depth = std::min(least_depth, depth_below(PressureFace<D>(owner, f), least_depth));
  }
  const double limit = (D + 1) * least_depth;
  LeastFace least;
  for (const PlacedOutline<D>& owner : blocks) {
    for (int f = 0; f < owner.outline.face_count(); ++f) {
      const PressureFace<D> face(owner, f);
      if (depth_below(face, limit) > limit) continue;
      const double energy = energy_below(face);
      if (energy < least.energy) least = {owner.block, f, energy};
    }
  }
  return least;
}

/// Is a point of a surface with this outer normal on a face that looks the same way, up to rounding? Where
/// flush faces of both blocks bound the overlap, rounding must not decide whose surface the pressure is on.
template <int D>
bool are_flush(const PressureFace<D>& face, const Vector<D>& normal, double depth) {
  return std::abs(depth) <= face.flush && face.normal.dot(normal) >= 1 - 0.5 * touch_reach * touch_reach;
}

/// Sums over the surface of the overlap, with positions from the centroid of a.
template <int D>
struct PressureSums {
  Vector<D> force = Vector<D>::Zero();   // on the block that does not own the face
  Tensor<D> virial = Tensor<D>::Zero();  // force times position^T
  double base = 0;
  Vector<D> base_moment = Vector<D>::Zero();
  Tensor<D> base_spread = Tensor<D>::Zero();

  /// The pressure on a part of the surface: its depth, and the depth times the position, integrated.
  void add_pressure(const Vector<D>& normal, double depth, const Vector<D>& moment) {
    force -= depth * normal;
    virial -= normal * moment.transpose();
  }

  /// A part of the base: a segment, or a triangle.
  void add_base(const Vector<2>& p, const Vector<2>& q, double length) {
    base += length;
    base_moment += length / 2 * (p + q);
    base_spread += length / 6 * (p * p.transpose() + q * q.transpose() + (p + q) * (p + q).transpose());
  }
  void add_base(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r, double area) {
    const Vector<3> sum = p + q + r;
    base += area;
    base_moment += area / 3 * sum;
    base_spread +=
        area / 12 * (p * p.transpose() + q * q.transpose() + r * r.transpose() + sum * sum.transpose());
  }

  /// The owner's virial follows from that of both blocks together, which is what a common strain adds to the
  /// energy.
  Pressure<D> pressure(const PotentialPair<D>& face, const Vector<D>& normal, double energy,
                       const PlacedOutline<D>& owner, const PlacedOutline<D>& pressed) const {
    const Tensor<D> of_both = -energy * (Tensor<D>::Identity() + normal * normal.transpose());
    const Tensor<D> on_other = virial - force * pressed.at.transpose();
    const Tensor<D> on_owner = of_both - (virial - force * owner.at.transpose());
    const bool a_owns = owner.block == 0;
    Pressure<D> pressure;
    pressure.face = face;
    pressure.normal = a_owns ? normal : Vector<D>(-normal);
    pressure.energy = energy;
    pressure.force = a_owns ? force : Vector<D>(-force);
    pressure.virial_a = a_owns ? on_owner : on_other;
    pressure.virial_b = a_owns ? on_other : on_owner;
    pressure.base = base;
    pressure.middle = base_moment / base;
    pressure.spread = base_spread / base - pressure.middle * pressure.middle.transpose();
    return pressure;
  }
};

}  // namespace halfspace
