#include "geometry/polyhedron/fit_plane.h"

#include <algorithm>
#include <cmath>

#include "geometry/unit_vector.h"

namespace halfspace {
namespace {

/// Each iteration squares the error of the slope: from 0.1 to below rounding.
constexpr int rounds = 5;

Vector<3> mean_of(std::span<const Vector<3>> points) {
  Vector<3> sum = Vector<3>::Zero();
  for (const Vector<3>& p : points) sum += p;
  return sum / double(points.size());
}

Vector<3> farthest_from(const Vector<3>& mean, std::span<const Vector<3>> points) {
  Vector<3> farthest = Vector<3>::Zero();
  for (const Vector<3>& p : points) {
    if ((p - mean).squaredNorm() > farthest.squaredNorm()) farthest = p - mean;
  }
  return farthest;
}

/// The normal corrected by the slope of the heights over it. The slope across is that of the residual after
/// the slope along the longest extent, so that there is no cancellation for a narrow face.
Vector<3> without_slope(std::span<const Vector<3>> points, const Vector<3>& mean, const Vector<3>& longest,
                        const Vector<3>& normal) {
  const Vector<3> u = unit_vector<3>(longest - normal.dot(longest) * normal);
  const Vector<3> v = cross_product(normal, u);
  double uu = 0, uv = 0, uh = 0;
  for (const Vector<3>& p : points) {
    const Vector<3> arm = p - mean;
    const double along = u.dot(arm);
    uu += along * along;
    uv += along * v.dot(arm);
    uh += along * normal.dot(arm);
  }
  if (!(uu > 0)) return normal;
  double ww = 0, wh = 0;
  for (const Vector<3>& p : points) {
    const Vector<3> arm = p - mean;
    const double across = v.dot(arm) - uv / uu * u.dot(arm);
    ww += across * across;
    wh += across * normal.dot(arm);
  }
  const double slope_across = ww > 0 ? wh / ww : 0;
  const double slope_along = uh / uu - slope_across * uv / uu;
  return unit_vector<3>(normal - slope_along * u - slope_across * v);
}

}  // namespace

FittedPlane fit_plane(std::span<const Vector<3>> points, const Vector<3>& direction) {
  const Vector<3> mean = mean_of(points), longest = farthest_from(mean, points);
  Vector<3> normal = unit_vector(direction);
  for (int round = 0; round < rounds; ++round) normal = without_slope(points, mean, longest, normal);

  FittedPlane fitted{{normal, normal.dot(mean)}, 0};
  for (const Vector<3>& p : points)
    fitted.deviation = std::max(fitted.deviation, std::abs(normal.dot(p - mean)));
  return fitted;
}

}  // namespace halfspace
