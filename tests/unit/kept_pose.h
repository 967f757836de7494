#pragma once

#include "geometry/pose.h"

namespace halfspace::test {

/// A pose where a host keeps it.
struct Kept {
  double position[3];
  double quaternion[4] = {0, 0, 0, 1};

  GivenPose given() const { return {position, quaternion}; }
};

}  // namespace halfspace::test
