#pragma once

#include <algorithm>

#include "force/law.h"
#include "force/spring/pressure_room.h"
#include "geometry/tolerances.h"

namespace halfspace {

/// A block of the pair, relative to the centroid of a.
template <int D>
struct PlacedOutline {
  const Outline<D>& outline;
  Vector<D> at;
  int block;  // 0 a, 1 b

  Vector<D> vertex(int v) const { return outline.vertex(v) + at; }
};

/// Blocks cut along a joint touch up to rounding: a smaller distance from a face counts as none.
template <int D>
double flush_of(const PlacedOutline<D>& block, int face) {
  return touch_reach * block.outline.offset[face];
}

template <int D>
PressureFace<D> face_of(const PlacedOutline<D>& block, int face) {
  const Vector<D> normal = block.outline.normal(face);
  const double offset = block.outline.offset[face];
  return {normal, offset + normal.dot(block.at), flush_of(block, face), block.block, face};
}

/// The face of least energy: by a linear depth, the one nearest to the overlap's centroid. A face that does
/// not bound the overlap is farther away. The first is kept against one that is nearer by rounding only, so
/// that a search from the face that was found finds it again.
template <int D, class Sides>
PressureFace<D> face_of_min_energy(const PlacedOutline<D> (&blocks)[2], const PressureFace<D>& first,
                                   const Sides& sides, const Vector<D>& centroid) {
  PressureFace<D> least = first;
  double depth = first.depth(centroid);
  depth -= std::min(same_face * first.flush, equal_within * std::abs(depth));
  for (const auto& side : sides) {
    const PressureFace<D> face = face_of(blocks[side.block], side.face);
    const double depth_here = face.depth(centroid);
    if (depth_here >= depth) continue;
    least = face;
    depth = depth_here;
  }
  return least;
}

/// Do two faces look the same way, up to rounding?
template <int D>
bool are_parallel(const Vector<D>& normal, const Vector<D>& other) {
  return normal.dot(other) >= 1 - 0.5 * strictly_parallel * strictly_parallel;
}

/// The part of a side on which the owner of the contact face keeps the pressure from the other block: a side
/// that both blocks share counts half for each. On the face itself there is no pressure.
template <class Side, int D>
double kept_part(const Side& side, const PressureFace<D>& face) {
  if (side.is_shared) return 0.5;
  return side.block == face.block && side.face != face.face;
}

/// The volume of the overlap, in 2D its area, and its centroid.
template <int D>
struct OverlapVolume {
  double volume = 0;
  Vector<D> centroid = Vector<D>::Zero();
};

template <int D>
Pressure<D> no_pressure(const PressureFace<D>& face) {
  Pressure<D> pressure;
  pressure.face_normal = face.normal;
  pressure.normal = face.block == 0 ? face.normal : Vector<D>(-face.normal);
  return pressure;
}

/// Sums over the surface of the overlap, with positions from the centroid of a. The pressure on the whole
/// surface follows from the volume by the divergence theorem; what is kept by sides of the owner is
/// subtracted.
template <int D>
struct PressureSums {
  double depth = 0;                           // greatest
  Vector<D> kept = Vector<D>::Zero();         // force of the pressure on those sides
  Tensor<D> kept_virial = Tensor<D>::Zero();  // force times position^T
  double base = 0;
  Vector<D> base_moment = Vector<D>::Zero();
  Tensor<D> base_spread = Tensor<D>::Zero();

  /// A part of the surface that the owner keeps: its depth, and the depth times the position, integrated.
  void keep(const Vector<D>& normal, double depth, const Vector<D>& moment) {
    kept -= depth * normal;
    kept_virial -= normal * moment.transpose();
  }

  /// A part of the base: the shadow of a segment or a triangle, with this length or area.
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

  /// The middle gets the depth of the overlap's centroid.
  Pressure<D> pressure(const PotentialPair<D>& pair, const PressureFace<D>& face,
                       const OverlapVolume<D>& overlap) const {
    const auto& [volume, centroid] = overlap;
    const double energy = volume * face.depth(centroid);
    if (!(energy > 0 && base > 0)) return no_pressure(face);
    const Vector<D> force = volume * face.normal - kept;
    const Tensor<D> virial =
        volume * face.normal * centroid.transpose() - energy * Tensor<D>::Identity() - kept_virial;
    const double on_b = face.block == 0 ? 1 : -1;
    const Vector<D> mean = base_moment / base;
    const Tensor<D> spread = base_spread / base - mean * mean.transpose();
    const Tensor<D> shadow = Tensor<D>::Identity() - face.normal * face.normal.transpose();
    const Vector<D> middle = mean + (face.depth(mean) - face.depth(centroid)) * face.normal;
    // None where the owner lies within the other block: what rounding leaves has no direction.
    const double length = force.norm();
    const Vector<D> direction = length > touch_reach * volume ? Vector<D>(force / length) : face.normal;
    return {pair, face.block,   face.normal,   on_b * direction, energy, depth,
            base, on_b * force, on_b * virial, centroid,         middle, shadow * spread * shadow};
  }
};

}  // namespace halfspace
