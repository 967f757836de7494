#pragma once

#include <halfspace/box2d.hpp>

namespace halfspace::box2d {

// Box2D has one table of contact types per process. While any world has a narrow phase, its entry for two
// polygons is replaced; for other worlds it calls Box2D's own function.

/// New contacts of the world use the installation from now on. False if the world already has one.
bool enter(const b2World& world, NarrowPhase::Installation& installation);
void withdraw(const b2World& world);

}  // namespace halfspace::box2d
