#pragma once

#include "geometry/vector.h"

namespace halfspace {

/// Integrals over a body.
struct VolumeAndMoment {
  double volume = 0;
  Vector<3> moment = Vector<3>::Zero();  // of the position
};
struct VolumeAndSpread : VolumeAndMoment {
  Tensor<3> spread = Tensor<3>::Zero();  // mean of r r^T about the centroid
};

/// Sums over tetrahedra with one vertex at the origin.
struct VolumeSums {
  double volume = 0;                     // six times
  Vector<3> moment = Vector<3>::Zero();  // 24 times

  /// Adds a tetrahedron and returns six times its volume.
  double add(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) {
    const double sixfold = p.dot(cross_product(q, r));
    volume += sixfold;
    moment += sixfold * (p + q + r);
    return sixfold;
  }
  VolumeAndMoment with_origin_at(const Vector<3>& p) const {
    return {volume / 6, moment / 24 + volume / 6 * p};
  }
};

struct SpreadSums : VolumeSums {
  Vector<3> squares = Vector<3>::Zero();  // 120 times xx, yy, zz
  Vector<3> across = Vector<3>::Zero();   // 120 times yz, zx, xy

  void add(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) {
    const double sixfold = VolumeSums::add(p, q, r);
    const Vector<3> s = p + q + r;
    const auto products = [](const Vector<3>& v) {
      return Vector<3>(v.y() * v.z(), v.z() * v.x(), v.x() * v.y());
    };
    squares += sixfold * (p.cwiseAbs2() + q.cwiseAbs2() + r.cwiseAbs2() + s.cwiseAbs2());
    across += sixfold * (products(p) + products(q) + products(r) + products(s));
  }
  VolumeAndSpread with_origin_at(const Vector<3>& p) const {
    const Vector<3> centroid = moment / (4 * volume);
    Tensor<3> spread;
    spread << squares.x(), across.z(), across.y(),  //
        across.z(), squares.y(), across.x(),        //
        across.y(), across.x(), squares.z();
    return {VolumeSums::with_origin_at(p), spread / (20 * volume) - centroid * centroid.transpose()};
  }
};

}  // namespace halfspace
