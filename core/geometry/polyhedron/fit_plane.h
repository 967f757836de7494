#pragma once

#include <span>

#include "geometry/halfspace.h"
#include "geometry/vector.h"

namespace halfspace {

/// A plane, and its largest distance from the points to which it was fitted.
struct FittedPlane {
  Halfspace<3> plane{Vector<3>::Zero(), 0};  // with a unit normal
  double deviation = HUGE_VAL;
};

/// The total least squares plane of points, with its normal on the side of `direction`, a rough normal that
/// is not 0. Heights over the plane are regressed on its coordinates until the slope vanishes. Unlike an
/// eigenvector of the covariance, this is accurate for long and narrow faces.
FittedPlane fit_plane(std::span<const Vector<3>> points, const Vector<3>& direction);

}  // namespace halfspace
