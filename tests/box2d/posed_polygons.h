#pragma once

// Pairs of Box2D polygons as posed.

#include <box2d/box2d.h>

#include <vector>

#include "benchmarks/random_polygon.h"
#include "face_gaps.h"

namespace halfspace_test {

using halfspace_benchmark::Random;

/// Two polygons touch within this, by their skins.
constexpr double radii = b2_polygonRadius + b2_polygonRadius;
/// Box2D's tolerance when it chooses between the faces of a and b.
constexpr double same_gap = 0.1f * b2_linearSlop;

struct PosedPolygons {
  b2PolygonShape a, b;
  b2Vec2 at_a, at_b;
  float angle_a = 0, angle_b = 0;

  b2Transform transform_a() const { return {at_a, b2Rot(angle_a)}; }
  b2Transform transform_b() const { return {at_b, b2Rot(angle_b)}; }
};

/// As face_gaps() of the floats of the shapes.
std::vector<FaceGap> face_gaps(const PosedPolygons& pair);

/// The face that a manifold refers to, known by its normal.
FaceGap reference_of(const b2Manifold& manifold, const PosedPolygons& pair, const std::vector<FaceGap>& gaps);

/// Random polygons of about 1 m and 3 to 8 vertices, so far apart as wanted but for the rounding of their
/// positions to float; a is `from_origin` from the origin.
PosedPolygons draw_polygons(double from_origin, double wanted_gap, Random& random);

}  // namespace halfspace_test
