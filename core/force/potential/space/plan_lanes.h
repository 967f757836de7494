#pragma once

#include "geometry/coordinates.h"

namespace halfspace {

/// Positions or directions by component, with padding for lanes after the last ones.
template <int most>
struct Places {
  static constexpr int room = most + 8;
  alignas(32) double x[room], y[room], z[room];

  Vector<3> operator[](int at) const { return {x[at], y[at], z[at]}; }
  void put(int at, const Vector<3>& place) {
    x[at] = place.x();
    y[at] = place.y();
    z[at] = place.z();
  }
  template <class Four>
  [[gnu::always_inline]] Coordinates<Four> four_from(int first) const {
    return {load_four<Four>(x + first), load_four<Four>(y + first), load_four<Four>(z + first)};
  }
  template <class Four>
  [[gnu::always_inline]] void put_four(int first, const Coordinates<Four>& four) {
    store_four(x + first, four.x);
    store_four(y + first, four.y);
    store_four(z + first, four.z);
  }
};

/// The indices of faces, planes or corners in four lanes.
struct FourOf {
  int first, second, third, fourth;

  template <class Four>
  [[gnu::always_inline]] Four lanes(const double* values) const {
    return four_of<Four>(values[first], values[second], values[third], values[fourth]);
  }
  template <class Four, int most>
  [[gnu::always_inline]] Coordinates<Four> lanes(const Places<most>& places) const {
    return {lanes<Four>(places.x), lanes<Four>(places.y), lanes<Four>(places.z)};
  }
};

/// Inside is where the height along the normal, of any length, is at most the offset.
template <class Number>
struct LanesOfPlanes {
  Coordinates<Number> normal;
  Number offset;
};

/// The intersection of three planes, by Cramer's rule.
template <class Number>
[[gnu::always_inline]] inline Coordinates<Number> meeting(const LanesOfPlanes<Number>& p,
                                                          const LanesOfPlanes<Number>& q,
                                                          const LanesOfPlanes<Number>& r) {
  const Coordinates<Number> qr = cross_product(q.normal, r.normal), rp = cross_product(r.normal, p.normal),
                            pq = cross_product(p.normal, q.normal);
  const Number share = 1.0 / dot_product(p.normal, qr);
  return share * (p.offset * qr + q.offset * rp + r.offset * pq);
}

}  // namespace halfspace
