#include "narrow_phase/space/shares.h"

#include <algorithm>
#include <cmath>

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

/// Ways between corners count as longer by this, so that no slope grows without bound where two corners
/// become one: a tenth of the region's size.
double softening(const Contact<3>& contact) {
  double square = 0;
  for (int i = 0; i < contact.point_count; ++i)
    square = std::max(square, (contact.points[i] - contact.center).squaredNorm());
  return 0.2 * std::sqrt(square);
}

struct WayDown {
  double slope = 0;
  Vector<3> direction = Vector<3>::Zero();  // from below; the slope by the gap's gradient
};

/// To any other corner.
WayDown steepest_way_down(const Contact<3>& contact, int from, double short_way) {
  WayDown steepest;
  for (int i = 0; i < contact.point_count; ++i) {
    const double climb = contact.gaps[from] - contact.gaps[i];
    if (!(climb > steepest.slope * short_way)) continue;  // however near
    const Vector<3> way = contact.points[from] - contact.points[i];
    const double length = way.norm() + short_way;
    if (climb > steepest.slope * length) steepest = {climb / length, way / length};
  }
  return steepest;
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
  share_by_area(contact);
  const double short_way = softening(contact);
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const WayDown way = steepest_way_down(contact, i, short_way);
    const Step step = step_down(way.slope, options.parallel_angle);
    contact.share_rates[i] = contact.shares[i] * step.rate * way.direction;
    contact.shares[i] *= step.value;
    sum += contact.shares[i];
  }
  for (int i = 0; i < count; ++i) {
    contact.shares[i] /= sum;
    contact.share_rates[i] /= sum;
  }
}

void keep_what_bears(Contact<3>& contact) {
  int kept = 0;
  for (int i = 0; i < contact.point_count; ++i) {
    if (contact.shares[i] == 0) continue;
    contact.points[kept] = contact.points[i];
    contact.gaps[kept] = contact.gaps[i];
    contact.shares[kept] = contact.shares[i];
    contact.share_rates[kept] = contact.share_rates[i];
    ++kept;
  }
  contact.point_count = kept;
}

}  // namespace halfspace
