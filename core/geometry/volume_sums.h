#pragma once

#include "geometry/two_lanes.h"
#include "geometry/vector.h"

namespace halfspace {

/// Integrals over a body.
struct VolumeAndMoment {
  double volume = 0;
  Vector<3> moment = Vector<3>::Zero();  // of the position
};
struct VolumeAndSpread : VolumeAndMoment {
  Tensor<3> spread = Tensor<3>::Zero();  // mean of the way from the centroid times itself^T
};

/// A vertex in two registers.
struct Point {
  TwoLanes xy, z;
};

/// Of tetrahedra with the origin for a vertex.
struct VolumeSums {
  TwoLanes volume{}, moment_xy{}, moment_z{};  // six times, and 24 times

  /// Adds one, and returns six times its volume.
  TwoLanes add(const Point& p, const Point& q, const Point& r) {
    const TwoLanes q_yz{q.xy[1], q.z[0]}, r_yz{r.xy[1], r.z[0]};
    const TwoLanes zx = q.xy * r_yz - q_yz * r.xy, y = q.z * r.xy - q.xy * r.z;
    const TwoLanes sixfold = both(p.z[0] * zx[0] + p.xy[0] * zx[1] + p.xy[1] * y[0]);
    volume += sixfold;
    moment_xy += sixfold * (p.xy + q.xy + r.xy);
    moment_z += sixfold * (p.z + q.z + r.z);
    return sixfold;
  }

  VolumeAndMoment with_origin_at(const Vector<3>& p) const {
    const double v = volume[0] / 6;
    return {v, Vector<3>(moment_xy[0], moment_xy[1], moment_z[0]) / 24 + v * p};
  }
};

struct SpreadSums : VolumeSums {
  TwoLanes squares{}, across{}, with_z{}, z_square{};  // 120 times xx and yy, xy, zx and zy, zz

  void add(const Point& p, const Point& q, const Point& r) {
    const TwoLanes sixfold = VolumeSums::add(p, q, r);
    const Point sum{p.xy + q.xy + r.xy, p.z + q.z + r.z};
    TwoLanes squares_here{}, across_here{}, with_z_here{}, z_square_here{};
    for (const Point& v : {p, q, r, sum}) {
      squares_here += v.xy * v.xy;
      across_here += v.xy * exchanged(v.xy);
      with_z_here += v.xy * both(v.z[0]);
      z_square_here += v.z * v.z;
    }
    squares += sixfold * squares_here;
    across += sixfold * across_here;
    with_z += sixfold * with_z_here;
    z_square += sixfold * z_square_here;
  }

  Tensor<3> spread() const {
    Tensor<3> mean;
    mean << squares[0], across[0], with_z[0],  //
        across[0], squares[1], with_z[1],      //
        with_z[0], with_z[1], z_square[0];
    const Vector<3> centroid = Vector<3>(moment_xy[0], moment_xy[1], moment_z[0]) / (4 * volume[0]);
    return mean / (20 * volume[0]) - centroid * centroid.transpose();
  }
};

}  // namespace halfspace
