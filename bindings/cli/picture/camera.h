#pragma once

#include "scene.h"

namespace halfspace::cli {

/// Looks at a scene from so far away that all rays are parallel: lengths across the view are true.
class Camera {
 public:
  /// Azimuth: from where it looks, clockwise from +y seen from above; elevation above the horizontal. In rad.
  Camera(double azimuth, double elevation);

  /// A point or vector as seen: to the right, upwards, towards the camera.
  Point seen(const Point& p) const;

 private:
  std::array<Point, 3> axes_;  ///< right, up, towards the camera
};

}  // namespace halfspace::cli
