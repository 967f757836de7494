#pragma once

#include <array>
#include <cstdint>

#include "geometry/outline.h"
#include "geometry/rotation.h"
#include "geometry/vector.h"
#include "narrow_phase/contact.h"
#include "narrow_phase/features.h"

namespace halfspace {

/// A rigid block at some pose.
template <int D>
struct PosedBlock {
  Outline<D> own;  // in its shape's frame
  Vector<D> position;
  Rotation<D> rotation;
};

/// The most points of a manifold.
template <int D>
constexpr int max_manifold_points = D == 2 ? 2 : max_region_points;

/// The features that give a manifold its normal.
enum class ManifoldPlane : std::int32_t { face_of_a = 0, face_of_b = 1, edges = 2 };

/// The region of two faces in space, also where it has more corners than the manifold has points.
template <int D>
struct ManifoldRegion {};
template <>
struct ManifoldRegion<3> {
  double area = 0;  // m²
};

/// The plane through which two blocks touch or come near each other, and the points in front of it: of a face
/// of one block, or in space of an edge of each. Points are material: each is given in the frame of the other
/// block's shape; between edges there is one, of block b.
template <int D>
struct Manifold : ManifoldRegion<D> {
  ManifoldPlane plane = ManifoldPlane::face_of_a;
  std::int32_t feature = 0;        // the face, or the edge of a
  std::int32_t other_feature = 0;  // the edge of b
  std::int32_t count = 0;
  std::array<Vector<D>, max_manifold_points<D>> point;

  Manifold() { point.fill(Vector<D>::Zero()); }
};

/// Finds the manifold of two blocks whose separation is at most `margin`: the plane of largest separation,
/// and the part of the other block's facing face in front of it. The plane in `manifold` is kept while no
/// other has a larger separation by more than rounding. False when they are farther apart, or only their ends
/// meet.
bool find_manifold(const PosedBlock<2>& a, const PosedBlock<2>& b, double margin, Manifold<2>& manifold);
bool find_manifold(const PosedBlock<3>& a, const PosedBlock<3>& b, double margin, Manifold<3>& manifold);

/// The unit normal of a manifold from a to b, with the blocks where they are now.
Vector<2> normal_of(const Manifold<2>& manifold, const PosedBlock<2>& a, const PosedBlock<2>& b);
Vector<3> normal_of(const Manifold<3>& manifold, const PosedBlock<3>& a, const PosedBlock<3>& b);

/// Does a manifold that was read from a snapshot name features that the blocks have?
template <int D>
bool names_features(const Manifold<D>& manifold, const Outline<D>& a, const Outline<D>& b) {
  if (manifold.count < 1 || manifold.count > max_manifold_points<D>) return false;
  switch (manifold.plane) {
    case ManifoldPlane::face_of_a:
      return is_below(manifold.feature, a.face_count());
    case ManifoldPlane::face_of_b:
      return is_below(manifold.feature, b.face_count());
    case ManifoldPlane::edges:
      return D == 3 && is_below(manifold.feature, a.edge_count()) &&
             is_below(manifold.other_feature, b.edge_count());
    default:
      return false;
  }
}

/// Does block b carry the points?
template <int D>
bool is_carried_by_b(const Manifold<D>& manifold) {
  return manifold.plane != ManifoldPlane::face_of_b;
}

/// A point of a manifold, from the centroid of a.
template <int D>
Vector<D> arm_of(const Manifold<D>& manifold, std::size_t point, const PosedBlock<D>& a,
                 const PosedBlock<D>& b) {
  if (!is_carried_by_b(manifold)) return a.rotation * manifold.point[point];
  return b.rotation * manifold.point[point] + (b.position - a.position);
}

/// The points of a manifold, from the centroid of a.
template <int D>
using Arms = std::array<Vector<D>, max_manifold_points<D>>;

template <int D>
Arms<D> arms_of(const Manifold<D>& manifold, const PosedBlock<D>& a, const PosedBlock<D>& b) {
  Arms<D> arms;
  for (std::size_t i = 0; i < std::size_t(manifold.count); ++i) arms[i] = arm_of(manifold, i, a, b);
  return arms;
}

/// The gap at a point; `normal` is that of the manifold.
template <int D>
double gap_of(const Manifold<D>& manifold, std::size_t point, const Vector<D>& normal, const PosedBlock<D>& a,
              const PosedBlock<D>& b) {
  const Vector<D> arm = arm_of(manifold, point, a, b);
  switch (manifold.plane) {
    case ManifoldPlane::face_of_a:
      return normal.dot(arm) - a.own.offset[manifold.feature];
    case ManifoldPlane::face_of_b:
      return -normal.dot(arm - (b.position - a.position)) - b.own.offset[manifold.feature];
    default:
      break;
  }
  if constexpr (D == 3) {
    const Vector<D> start = a.own.vertex(a.own.topology->edge_start[manifold.feature]);
    return normal.dot(arm - a.rotation * start);
  }
  return 0;
}

/// The gaps at the points of a manifold, m.
template <int D>
using Gaps = std::array<double, max_manifold_points<D>>;

template <int D>
Gaps<D> gaps_of(const Manifold<D>& manifold, const Vector<D>& normal, const PosedBlock<D>& a,
                const PosedBlock<D>& b) {
  Gaps<D> gaps{};
  for (std::size_t i = 0; i < std::size_t(manifold.count); ++i) gaps[i] = gap_of(manifold, i, normal, a, b);
  return gaps;
}

}  // namespace halfspace
