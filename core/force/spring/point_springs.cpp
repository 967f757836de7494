#include "force/spring/point_springs.h"

#include <algorithm>
#include <cmath>

namespace halfspace {

/// A share depends on a slope between two points (narrow_phase/space/shares.h), which grows as b turns about
/// the direction at right angles to the way between them in the contact plane.
Angular<3> couple_of_shares(const Contact<3>& contact, const double* depth) {
  Angular<3> couple = Angular<3>::Zero();
  if (contact.point_count == 1) return couple;
  double mean_square = 0;
  for (int i = 0; i < contact.point_count; ++i) mean_square += contact.shares[i] * depth[i] * depth[i];
  for (int i = 0; i < contact.point_count; ++i) {
    const double excess = depth[i] * depth[i] - mean_square;
    couple -= 0.5 * excess * moment(contact.share_rates[i], contact.normal);
  }
  return couple;
}

/// With the depths d0 and d1 = d0 - L theta and the share s of the shallower point, the energy
/// ((1 - s) d0^2 + s d1^2) / 2 is curved by s'' (d1^2 - d0^2) / 2 - 2 s' d1 L + s L^2. Of s(theta), which
/// falls from 1/2 to 0 over half the parallel angle (narrow_phase/plane/manifold.cpp), the first two are at
/// most 6.4 d L / angle, and, as a spring that has opened does not act, at most 6 (d / angle)^2.
double turning_stiffness_of_shares(const Contact<2>& contact, double parallel_angle) {
  if (contact.point_count == 1) return 0;
  const double depth = std::max(0.0, -contact.gap), length = contact.length;
  const double tilt = depth / parallel_angle;
  return std::min(6.4 * tilt * length, 6 * tilt * tilt) + 0.5 * length * length;
}

/// In space by what 99.9 % of random polygons keep to, at random tilts within the transition, each corner
/// with the share that shares.cpp gives it.
double turning_stiffness_of_shares(const Contact<3>& contact, double parallel_angle) {
  if (contact.point_count == 1) return 0;
  double reach = 0;
  for (int i = 0; i < contact.point_count; ++i)
    reach = std::max(reach, (contact.points[i] - contact.center).norm());
  const double length = 2 * reach, tilt = std::max(0.0, -contact.gap) / parallel_angle;
  return std::min(20 * tilt * length, 30 * tilt * tilt) + 0.5 * length * length;
}

double twist_radius(const Contact<3>& contact, const Vector<3>& center, const double* share) {
  double squared = 0;
  for (int i = 0; i < contact.point_count; ++i)
    squared += share[i] * (contact.points[i] - center).squaredNorm();
  return std::sqrt(squared);
}

}  // namespace halfspace
