#include "model/placing.h"

#include <algorithm>
#include <cmath>

#include "common/vector.h"

namespace halfspace::cli {
namespace {

/// p rotated by a quaternion q = (v, w): p + 2 w (v x p) + 2 v x (v x p).
Point rotated(const std::array<double, 4>& q, const Point& p) {
  const Point v = point_of(q.data());
  const Point once = cross(v, p);
  return plus(p, times(2, plus(times(q[3], once), cross(v, once))));
}

}  // namespace

std::array<double, 4> quaternion_of(const Point& rotation) {
  const double angle = length(rotation);
  if (angle == 0) return {0, 0, 0, 1};
  const Point along = times(std::sin(angle / 2) / angle, rotation);
  return {along[0], along[1], along[2], std::cos(angle / 2)};
}

Point placed(const Point& p, const Placing& placing) {
  return plus(rotated(quaternion_of(placing.rotation), p), placing.shift);
}

Point unplaced(const Point& p, const Placing& placing) {
  return rotated(quaternion_of(times(-1, placing.rotation)), minus(p, placing.shift));
}

void place(hs_pose& pose, const Placing& placing) {
  const std::array<double, 4> rotation = quaternion_of(placing.rotation);
  const Point centroid = placed(point_of(pose.position), placing);
  std::copy(centroid.begin(), centroid.end(), pose.position);
  std::copy(rotation.begin(), rotation.end(), pose.rotation);  // the given shape has no rotation
}

}  // namespace halfspace::cli
