#pragma once

#include <array>

#include "scene/scene.h"

namespace halfspace::cli {

/// The quaternion of a rotation vector: axis times angle.
std::array<double, 4> quaternion_of(const Point& rotation);

/// A point after its placing.
Point placed(const Point& p, const Placing& placing);

/// The point that is here after its placing.
Point unplaced(const Point& p, const Placing& placing);

/// Applies a placing to the pose of a shape.
void place(hs_pose& pose, const Placing& placing);

}  // namespace halfspace::cli
