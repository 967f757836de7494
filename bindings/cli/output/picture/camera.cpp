#include "output/picture/camera.h"

#include <cmath>

#include "common/vector.h"

namespace halfspace::cli {

Camera::Camera(double azimuth, double elevation) {
  const double sa = std::sin(azimuth), ca = std::cos(azimuth);
  const double se = std::sin(elevation), ce = std::cos(elevation);
  axes_ = {{{-ca, sa, 0}, {-se * sa, -se * ca, ce}, {ce * sa, ce * ca, se}}};
}

Point Camera::seen(const Point& p) const { return {dot(axes_[0], p), dot(axes_[1], p), dot(axes_[2], p)}; }

}  // namespace halfspace::cli
