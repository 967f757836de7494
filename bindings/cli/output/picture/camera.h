#pragma once

#include "common/vector.h"

namespace halfspace::cli {

/// An orthographic camera: lengths across the view are to scale.
class Camera {
 public:
  /// The direction of the camera, rad: azimuth clockwise from +y seen from above, elevation above the
  /// horizontal.
  Camera(double azimuth, double elevation);

  /// A point or vector in the view: to the right, upwards, towards the camera.
  Point seen(const Point& p) const;

 private:
  std::array<Point, 3> axes_;  ///< right, up, towards the camera
};

}  // namespace halfspace::cli
