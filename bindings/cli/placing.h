#pragma once

#include <array>

#include "scene.h"

namespace halfspace::cli {

/// The quaternion of a turn by an axis times an angle.
std::array<double, 4> quaternion_of(const Point& turn);

/// Where a scene puts a point.
Point placed(const Point& p, const Placing& placing);

/// Moves a pose from where the shape was given to where the scene puts it.
void place(hs_pose& pose, const Placing& placing);

}  // namespace halfspace::cli
