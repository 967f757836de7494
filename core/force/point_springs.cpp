#include "force/point_springs.h"

#include <cmath>

namespace halfspace {

/// A share depends on the slopes from the deepest point to the others (detect/region_3d_shares.h), and such a
/// slope grows as b turns about the direction at right angles to it in the contact plane.
Angular<3> couple_of_shares(const Contact<3>& contact, const double* depth) {
  Angular<3> couple = Angular<3>::Zero();
  if (contact.point_count == 1) return couple;
  double mean_square = 0;
  for (int i = 0; i < contact.point_count; ++i) mean_square += contact.shares[i] * depth[i] * depth[i];
  for (int i = 0; i < contact.point_count; ++i) {
    if (contact.share_rates[i] == 0) continue;
    const Vector<3> away = (contact.points[i] - contact.points[contact.deepest]).normalized();
    couple -=
        0.5 * contact.share_rates[i] * (depth[i] * depth[i] - mean_square) * moment(away, contact.normal);
  }
  return couple;
}

double twist_radius(const Contact<3>& contact, const Vector<3>& center, const double* share) {
  double squared = 0;
  for (int i = 0; i < contact.point_count; ++i)
    squared += share[i] * (contact.points[i] - center).squaredNorm();
  return std::sqrt(squared);
}

}  // namespace halfspace
