#pragma once

#include <array>

#include "force/potential/space/division_plan.h"
#include "force/potential/space/plan_lanes.h"

namespace halfspace {

/// A face, or two and the plane between them.
using FacePair = std::array<PlanCode, 2>;

/// Planes that may tell where a corner is: the first ones of too many.
class PlanesOfCorner {
 public:
  /// The normal has any length, and the depth is as many times too large.
  void add(const FacePair& faces, const Vector<3>& normal, double depth) {
    if (count_ == plane_.size()) return;
    plane_[count_++] = {faces, normal, normal.norm(), depth};
  }

  /// Moves it where three planes meet. False when all of them but meet in a line.
  ///
  /// The longer the normals of the three are and the less they agree, the better others that meet there are
  /// met as well: the volume that they span tells both. Two faces that all but agree span as little as one of
  /// them and the plane between them, which is the better choice.
  bool locate(Vector<3>& at, std::array<FacePair, 3>& faces) const {
    double best = 0, best_share = 0;
    std::array<const Plane*, 3> chosen{};
    for (std::size_t i = 0; i < count_; ++i)
      for (std::size_t j = i + 1; j < count_; ++j) {
        const Vector<3> along = cross_product(plane_[i].normal, plane_[j].normal);
        for (std::size_t k = j + 1; k < count_; ++k) {
          const Plane &p = plane_[i], &q = plane_[j], &r = plane_[k];
          const double span = std::abs(along.dot(r.normal));
          const double share = span / (p.length * q.length * r.length);
          const double merit = span * (1 + share);
          if (!(merit > best)) continue;
          best = merit;
          best_share = share;
          chosen = {&p, &q, &r};
        }
      }
    if (!(best_share > least_share)) return false;
    const auto& [p, q, r] = chosen;
    faces = {p->faces, q->faces, r->faces};
    const Coordinates<double> way =
        meeting(p->seen_from_corner(), q->seen_from_corner(), r->seen_from_corner());
    at += Vector<3>(way.x, way.y, way.z);
    return true;
  }

 private:
  /// Of the volume that normals of their lengths span at most.
  static constexpr double least_share = 1e-6;

  struct Plane {
    FacePair faces;
    Vector<3> normal;
    double length;
    double depth;  // of the place where the corner was thought to be

    LanesOfPlanes<double> seen_from_corner() const { return {{normal.x(), normal.y(), normal.z()}, depth}; }
  };

  std::array<Plane, 16> plane_;
  std::size_t count_ = 0;
};

}  // namespace halfspace
