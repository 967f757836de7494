#pragma once

#include <box2d/b2_collision.h>

#include "face.h"

namespace halfspace::box2d {

/// Box2D's manifold at a reference face: the incident edge, cut off where it leaves the strip of the face and
/// of the skins at its ends; of the two ends left, those within reach of the skins, `radii` together.
/// Computed in double; each number is rounded to float once. Points carry the feature ids that Box2D gives
/// them.
void write_manifold(const SeenFromFace& seen, const Face& face, int deepest, double radii,
                    b2Manifold& manifold);

}  // namespace halfspace::box2d
