#pragma once

#include "block/blocks.h"
#include "geometry/vector.h"
#include "pose_and_vector.h"
#include "strided_view.h"

// Angular velocities and torques have three components in the C interface; in 2D only z is used.

namespace halfspace::capi {

inline Vector<3> in_space(const Angular<2>& angular) { return {0, 0, angular[0]}; }
inline const Vector<3>& in_space(const Angular<3>& angular) { return angular; }

template <class Angular>
void write_angular(const Angular& angular, double out[3]) {
  write_vector(in_space(angular), out);
}

template <int D>
Angular<D> read_finite_angular(const double* values, const char* name) {
  require_pointer(values, name);
  Angular<D> angular;
  for (int k = 0; k < angular.size(); ++k) {
    const int component = D == 2 ? 2 : k;
    angular[k] = require_component(values[component], name, component);
  }
  return angular;
}

/// Refuses a kinetic energy so large that sums over blocks could overflow. `prefix` precedes the names of the
/// arguments in the error text.
template <int D>
void require_energy(double mass, const Inertia<D>& inertia, const Rotation<D>& rotation,
                    const Vector<D>& velocity, const Angular<D>& spin, const char* prefix = "") {
  constexpr double largest = 1e300;
  const double energy = 0.5 * (mass * velocity.squaredNorm() + spin.dot(inertia.momentum(spin, rotation)));
  if (energy <= largest) return;
  refuse(HS_ERROR_ARGUMENT,
         "%svelocity and %sangular_velocity have max components of %g and %g: the kinetic energy is %g; it "
         "must be at most %g",
         prefix, prefix, velocity.cwiseAbs().maxCoeff(), spin.cwiseAbs().maxCoeff(), energy, largest);
}

template <int D>
void require_energy_of(const Blocks<D>& blocks, std::int32_t slot, const Vector<D>& velocity,
                       const Angular<D>& spin) {
  const std::size_t s = std::size_t(slot);
  require_energy(blocks.mass[s], blocks.inertia[s], blocks.rotation[s], velocity, spin);
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
    if (!is_within_limits(z)) {
      refuse(HS_ERROR_ARGUMENT, "%s[%lld].z is %g; it must be finite and at most 1e75", name,
             static_cast<long long>(i), z);
    }
    return Angular<2>(z);
  }
}

template <class Angular>
void write_angular(const hs_mutable_view& view, std::int64_t i, const Angular& angular) {
  write_point(view, i, in_space(angular));
}

}  // namespace halfspace::capi
