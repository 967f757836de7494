#include "detect/region_3d_shares.h"

#include <algorithm>

namespace halfspace {
namespace {

/// Shares of the corners of a polygon, or of the ends of a segment, not yet divided by their sum: the area of
/// both triangles that a corner has with the centroid and its neighbours.
void share_by_area(Contact<3>& contact) {
  const int count = contact.point_count;
  if (count == 2) {
    contact.shares[0] = contact.shares[1] = 1;
    return;
  }
  std::fill_n(contact.shares, count, 0.0);
  for (int i = 0; i < count; ++i) {
    const int j = i + 1 == count ? 0 : i + 1;
    const double twice_area = contact.normal.dot(
        cross_product(contact.points[i] - contact.center, contact.points[j] - contact.center));
    contact.shares[i] += twice_area;
    contact.shares[j] += twice_area;
  }
}

/// A smooth step down, as a function of the slope.
struct Step {
  double value;
  double rate;
};

Step step_down(double slope, double parallel_angle) {
  const double u = (0.5 * parallel_angle - slope) / (0.25 * parallel_angle);
  if (u >= 1) return {1, 0};
  if (u <= 0) return {0, 0};
  return {u * u * (3 - 2 * u), -6 * u * (1 - u) / (0.25 * parallel_angle)};
}

}  // namespace

void share_stiffness(const DetectOptions& options, Contact<3>& contact) {
  const int count = contact.point_count;
  if (count == 1) return share_at_point(contact);
  contact.deepest = int(std::min_element(contact.gaps, contact.gaps + count) - contact.gaps);
  share_by_area(contact);
  const Vector<3>& lowest = contact.points[contact.deepest];
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const double distance = (contact.points[i] - lowest).norm();
    const double slope = distance > 0 ? (contact.gaps[i] - contact.gaps[contact.deepest]) / distance : 0;
    const Step step = step_down(slope, options.parallel_angle);
    contact.share_rates[i] = contact.shares[i] * step.rate;
    contact.shares[i] *= step.value;
    sum += contact.shares[i];
  }
  for (int i = 0; i < count; ++i) {
    contact.shares[i] /= sum;
    contact.share_rates[i] /= sum;
  }
}

}  // namespace halfspace
