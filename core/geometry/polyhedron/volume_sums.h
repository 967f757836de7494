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

/// Six times the volume of the tetrahedron of these points and the origin.
template <class Number>
[[gnu::always_inline]] inline Number sixfold_volume(const Coordinates<Number>& p,
                                                    const Coordinates<Number>& q,
                                                    const Coordinates<Number>& r) {
  return dot_product(p, cross_product(q, r));
}

/// Sums over tetrahedra with one vertex at the origin; lanes add several at a time.
template <class Number>
struct VolumeSums {
  Number volume{};               // six times
  Coordinates<Number> moment{};  // 24 times

  /// Adds a tetrahedron and returns six times its volume.
  [[gnu::always_inline]] Number add(const Coordinates<Number>& p, const Coordinates<Number>& q,
                                    const Coordinates<Number>& r) {
    const Number sixfold = sixfold_volume(p, q, r);
    volume = volume + sixfold;
    moment = moment + sixfold * (p + q + r);
    return sixfold;
  }
};

template <class Number>
struct SpreadSums : VolumeSums<Number> {
  Coordinates<Number> squares{}, across{};  // 120 times xx, yy, zz; yz, zx, xy

  [[gnu::always_inline]] void add(const Coordinates<Number>& p, const Coordinates<Number>& q,
                                  const Coordinates<Number>& r) {
    const Number sixfold = VolumeSums<Number>::add(p, q, r);
    const Coordinates<Number> s = p + q + r;
    const auto of_vertices = [&](Number Coordinates<Number>::*i, Number Coordinates<Number>::*k)
        __attribute__((always_inline)) {
      return p.*i * p.*k + q.*i * q.*k + r.*i * r.*k + s.*i * s.*k;
    };
    constexpr auto x = &Coordinates<Number>::x, y = &Coordinates<Number>::y, z = &Coordinates<Number>::z;
    squares =
        squares + sixfold * Coordinates<Number>{of_vertices(x, x), of_vertices(y, y), of_vertices(z, z)};
    across = across + sixfold * Coordinates<Number>{of_vertices(y, z), of_vertices(z, x), of_vertices(x, y)};
  }
};

inline Tensor<3> symmetric_tensor(const Vector<3>& squares, const Vector<3>& across) {
  Tensor<3> tensor;
  tensor << squares.x(), across.z(), across.y(),  //
      across.z(), squares.y(), across.x(),        //
      across.y(), across.x(), squares.z();
  return tensor;
}

template <class Number>
VolumeAndMoment with_origin_at(const Vector<3>& p, const VolumeSums<Number>& sums) {
  const double volume = reduce(sums.volume) / 6;
  return {volume, reduce(sums.moment) / 24 + volume * p};
}
template <class Number>
VolumeAndSpread with_origin_at(const Vector<3>& p, const SpreadSums<Number>& sums) {
  const double sixfold = reduce(sums.volume);
  const Vector<3> centroid = reduce(sums.moment) / (4 * sixfold);
  const Tensor<3> mean = symmetric_tensor(reduce(sums.squares), reduce(sums.across)) / (20 * sixfold);
  return {with_origin_at<Number>(p, static_cast<const VolumeSums<Number>&>(sums)),
          mean - centroid * centroid.transpose()};
}

}  // namespace halfspace
