#pragma once

// Scenes of polygons for Box2D worlds with gravity of 10 m/s2.

#include <box2d/box2d.h>

namespace halfspace_benchmark {

/// Box2D's own pyramid: boxes of 1 m, 20 of them in the lowest row, on a floor. They start a little apart, as
/// in its testbed; the floor is a polygon, so that its pairs count as well.
void add_pyramid(b2World& world);

/// Random polygons of about 0.6 m and 3 to 8 vertices in a square drum of 20 m that turns once in ten
/// seconds: nothing comes to rest.
void add_drum(b2World& world);

}  // namespace halfspace_benchmark
