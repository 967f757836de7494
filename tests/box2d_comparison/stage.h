#pragma once

// A Box2D world that is furnished with bodies of one polygon each, whose true vertices Box2D may have no
// place for.

#include <box2d/box2d.h>

#include <deque>

#include "capi/handles.h"

namespace box2d_comparison {

using halfspace_test::Points;

/// What a polygon is meant to be where that is more than its fixture can hold.
struct TruePolygon {
  Points vertices;  // counter-clockwise, in the coordinates of the body
  halfspace_test::Shape shape;
};

/// That of a fixture, or NULL when the fixture's own shape is the truth.
const TruePolygon* true_polygon_of(const b2Fixture& fixture);

/// How a body is made, beyond its shape. Densities in kg/m2.
struct Placing {
  b2Vec2 at = {0, 0};
  float angle = 0;
  b2BodyType type = b2_dynamicBody;
  float density = 1;
  float friction = 0.6f;
};

class Stage {
 public:
  /// `rest_gap` is between the edges of blocks that lie on each other, in m: the two skins in Box2D.
  explicit Stage(float rest_gap) : rest_gap_(rest_gap), context_(halfspace_test::make_context()) {
    world_.SetAllowSleeping(false);
  }

  b2World& world() { return world_; }
  float rest_gap() const { return rest_gap_; }

  b2Body& add(const b2PolygonShape& shape, const Placing& placing);

  /// A polygon of at most b2_maxPolygonVertices. Box2D is given it as well, and welds vertices nearer than
  /// 2.5 mm; mass and inertia are those of what it has made of it, in all worlds.
  b2Body& add(const Points& vertices, const Placing& placing);

  b2Body& add_box(float width, float height, const Placing& placing);

  /// The middle of its top is at the place.
  b2Body& add_floor(float width, b2Vec2 place = {0, 0}, float friction = 0.6f);

 private:
  b2Body& add(const b2PolygonShape& shape, const Placing& placing, const TruePolygon* truth);

  float rest_gap_;
  // Shapes end after the world that uses them.
  halfspace_test::Context context_;
  std::deque<TruePolygon> true_polygons_;
  b2World world_{{0, -10}};
};

}  // namespace box2d_comparison
