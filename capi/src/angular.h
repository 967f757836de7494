#pragma once

#include "check.h"
#include "geometry/vector.h"
#include "view.h"

// Angular velocities and torques have three components at the interface. In the plane z alone counts.

namespace halfspace::capi {

inline void write_angular(const Angular<2>& angular, double out[3]) {
  out[0] = out[1] = 0;
  out[2] = angular[0];
}
inline void write_angular(const Angular<3>& angular, double out[3]) { write_vector(angular, out); }

template <int D>
Angular<D> read_finite_angular(const double* values, const char* name) {
  require_pointer(values, name);
  Angular<D> angular;
  for (int k = 0; k < angular.size(); ++k) {
    const int component = D == 2 ? 2 : k;
    if (!std::isfinite(values[component]))
      refuse(HS_ERROR_ARGUMENT, "%s[%d] is %g; it must be finite", name, component, values[component]);
    angular[k] = values[component];
  }
  return angular;
}

template <int D, class View>
void require_angular_view(const View& view, const char* name) {
  if (view.count == 0) return;
  require_view<D>(view, name);
  if (!view.z) refuse(HS_ERROR_ARGUMENT, "%s.z is NULL", name);
}

template <int D>
Angular<D> read_finite_angular(const hs_view& view, std::int64_t i, const char* name) {
  if constexpr (D == 3) {
    return read_finite_point<3>(view, i, name);
  } else {
    const double z = *at(view.z, view.stride, i);
    if (!std::isfinite(z))
      refuse(HS_ERROR_ARGUMENT, "%s[%lld].z is %g; it must be finite", name, static_cast<long long>(i), z);
    return Angular<2>(z);
  }
}

inline void write_angular(const hs_mutable_view& view, std::int64_t i, const Angular<2>& angular) {
  write_point(view, i, Vector<3>(0, 0, angular[0]));
}
inline void write_angular(const hs_mutable_view& view, std::int64_t i, const Angular<3>& angular) {
  write_point(view, i, angular);
}

}  // namespace halfspace::capi
