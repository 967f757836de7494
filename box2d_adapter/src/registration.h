#pragma once

#include <halfspace/box2d.hpp>

namespace halfspace::box2d {

// Box2D keeps one table of contact types for the whole process. While any world has a narrow phase, its entry
// for two polygons leads here; contacts of other worlds are passed on to Box2D's own.

/// From now on new contacts of the world are the installation's. False when it has one already.
bool enter(const b2World& world, NarrowPhase::Installation& installation);
void withdraw(const b2World& world);

}  // namespace halfspace::box2d
