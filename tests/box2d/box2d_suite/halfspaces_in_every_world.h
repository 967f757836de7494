#pragma once

// Included in front of every source file of Box2D's suite: the worlds that it makes meet polygons by
// half-spaces.

#include <box2d/box2d.h>

#include <halfspace/box2d.hpp>

class WorldOfHalfspaces : public b2World {
 public:
  explicit WorldOfHalfspaces(const b2Vec2& gravity) : b2World(gravity) {}

 private:
  halfspace::box2d::NarrowPhase narrow_phase_{*this};
};

#define b2World WorldOfHalfspaces
