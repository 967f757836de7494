#pragma once

// Polygons for Box2D.

#include <box2d/b2_polygon_shape.h>

#include <vector>

#include "random_polygon.h"

namespace halfspace_benchmark {

inline b2PolygonShape box2d_shape(const Points& polygon) {
  std::vector<b2Vec2> vertices;
  for (const Point& p : polygon) vertices.push_back({float(p.x), float(p.y)});
  b2PolygonShape shape;
  shape.Set(vertices.data(), int32(vertices.size()));
  return shape;
}

/// Of 3 to 8 vertices, which are as many as Box2D has.
inline b2PolygonShape random_box2d_shape(double least_radius, double largest_radius, Random& random) {
  const int count = std::uniform_int_distribution<int>(3, 8)(random);
  return box2d_shape(random_polygon(count, uniform(random, least_radius, largest_radius), random));
}

}  // namespace halfspace_benchmark
