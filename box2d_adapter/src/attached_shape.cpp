#include <algorithm>
#include <cmath>
#include <halfspace/box2d.hpp>

#include "polygon.h"

namespace halfspace::box2d {
namespace {

/// The smallest float that is at least the value.
float rounded_up(double value) {
  const float nearest = float(value);
  return nearest < value ? std::nextafter(nearest, INFINITY) : nearest;
}

}  // namespace

b2PolygonShape box_around(const hs_shape& shape) {
  const Polygon polygon(shape);
  Vector low = polygon.vertex(0), high = low;
  for (int i = 1; i < polygon.count(); ++i) {
    const Vector& v = polygon.vertex(i);
    low = {std::min(low.x, v.x), std::min(low.y, v.y)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y)};
  }
  low = low + polygon.centroid();
  high = high + polygon.centroid();
  const b2Vec2 center = rounded(0.5 * (low + high));
  const auto half = [](double from, double to, float middle) {
    return rounded_up(std::max(to - middle, middle - from));
  };
  b2PolygonShape box;
  box.SetAsBox(half(low.x, high.x, center.x), half(low.y, high.y, center.y), center, 0);
  return box;
}

b2MassData mass_of(const hs_shape& shape, float density) {
  const hs_shape_properties properties = properties_of_polygon(shape);
  const Vector centroid{properties.centroid[0], properties.centroid[1]};
  const double polar = properties.second_moment[0] + properties.second_moment[1];
  b2MassData mass;
  mass.mass = float(density * properties.volume);
  mass.center = rounded(centroid);
  mass.I = float(density * (polar + properties.volume * dot(centroid, centroid)));
  return mass;
}

}  // namespace halfspace::box2d
