#pragma once

// The law of force mode: one rule for all scenes.

#include <box2d/box2d.h>
#include <halfspace/halfspace.h>

namespace box2d_comparison {

/// m, of the usual block on the ground under its share of the weight of all: a fiftieth of what Box2D's
/// solver leaves its skins to overlap.
constexpr double bearing_overlap = 0.02 * b2_linearSlop;

/// N/m, by which as many blocks carry a world with that overlap.
double force_stiffness(const b2World& world, int bearers);

/// That stiffness along the normal. Along the face it is four times as much: where the slope is the friction
/// angle, a force on the edge of the friction cone is vertical, so that a block that is let go falls
/// vertically and stops, as long as the shear spring grows faster than friction lets it; and as it rocks on
/// its lower edge when it comes down, that goes along the slope half as far as its centre. Damping is
/// critical: no block bounces, as none does in Box2D without restitution.
hs_law_def law_of_forces(double stiffness);

}  // namespace box2d_comparison
