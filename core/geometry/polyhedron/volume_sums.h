#pragma once

#include "geometry/coordinates.h"
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
  double volume{};               // six times
  Coordinates<double> moment{};  // 24 times

  /// Adds a tetrahedron and returns six times its volume.
  [[gnu::always_inline]] double add(const Coordinates<double>& p, const Coordinates<double>& q,
                                    const Coordinates<double>& r) {
    const double sixfold = dot_product(p, cross_product(q, r));
    volume = volume + sixfold;
    moment = moment + sixfold * (p + q + r);
    return sixfold;
  }
};

struct SpreadSums : VolumeSums {
  Coordinates<double> squares{}, across{};  // 120 times xx, yy, zz; yz, zx, xy

  [[gnu::always_inline]] void add(const Coordinates<double>& p, const Coordinates<double>& q,
                                  const Coordinates<double>& r) {
    const double sixfold = VolumeSums::add(p, q, r);
    const Coordinates<double> s = p + q + r;
    const auto of_vertices = [&](double Coordinates<double>::*i, double Coordinates<double>::*k)
        __attribute__((always_inline)) {
      return p.*i * p.*k + q.*i * q.*k + r.*i * r.*k + s.*i * s.*k;
    };
    constexpr auto x = &Coordinates<double>::x, y = &Coordinates<double>::y, z = &Coordinates<double>::z;
    squares =
        squares + sixfold * Coordinates<double>{of_vertices(x, x), of_vertices(y, y), of_vertices(z, z)};
    across = across + sixfold * Coordinates<double>{of_vertices(y, z), of_vertices(z, x), of_vertices(x, y)};
  }
};

inline Tensor<3> symmetric_tensor(const Vector<3>& squares, const Vector<3>& across) {
  Tensor<3> tensor;
  tensor << squares.x(), across.z(), across.y(),  //
      across.z(), squares.y(), across.x(),        //
      across.y(), across.x(), squares.z();
  return tensor;
}

inline VolumeAndMoment with_origin_at(const Vector<3>& p, const VolumeSums& sums) {
  const double volume = sums.volume / 6;
  return {volume, vector_of(sums.moment) / 24 + volume * p};
}
inline VolumeAndSpread with_origin_at(const Vector<3>& p, const SpreadSums& sums) {
  const Vector<3> centroid = vector_of(sums.moment) / (4 * sums.volume);
  const Tensor<3> mean =
      symmetric_tensor(vector_of(sums.squares), vector_of(sums.across)) / (20 * sums.volume);
  return {with_origin_at(p, static_cast<const VolumeSums&>(sums)), mean - centroid * centroid.transpose()};
}

}  // namespace halfspace
