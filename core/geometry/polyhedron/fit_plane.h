#pragma once

#include <span>

#include "geometry/halfspace.h"
#include "geometry/vector.h"

namespace halfspace {

/// A plane and the largest distance of the points that it was fitted to.
struct FittedPlane {
  Halfspace<3> plane{Vector<3>::Zero(), 0};  // with a unit normal
  double deviation = HUGE_VAL;
};

/// The plane with the least sum of squared distances to points, its normal on the side of `direction`, which
/// is near it and not 0. The heights over a plane are regressed on the coordinates in it, until they have no
/// slope left: then the plane is the one of total least squares. Unlike the eigenvector of a covariance it
/// keeps all digits of faces that are long and narrow.
FittedPlane fit_plane(std::span<const Vector<3>> points, const Vector<3>& direction);

}  // namespace halfspace
