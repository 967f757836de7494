#pragma once

#include <box2d/b2_collision.h>

#include "face.h"

namespace halfspace::box2d {

/// Writes Box2D's manifold at a reference face. The incident edge is clipped to the strip of the face,
/// extended by the skins at its ends; its ends are points if their gap is at most `radii`, the sum of both
/// skins. All numbers are computed in double and rounded to float once. Points have the feature ids of Box2D.
void write_manifold(const SeenFromFace& seen, const Face& face, int deepest, double radii,
                    b2Manifold& manifold);

}  // namespace halfspace::box2d
