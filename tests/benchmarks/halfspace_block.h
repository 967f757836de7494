#pragma once

#include <memory_resource>
#include <stdexcept>
#include <vector>

#include "benchmarks/peers_3d.h"
#include "geometry/polyhedron/hull.h"
#include "geometry/shape.h"

namespace halfspace_benchmark {

/// A shape, and where its centroid is seen from what a pose puts at its position.
struct HalfspaceBlock {
  explicit HalfspaceBlock(const Polyhedron& polyhedron)
      : shape(hull_of(polyhedron), std::pmr::get_default_resource()),
        centroid(shape.centroid() - centre_of(polyhedron)) {}

  static halfspace::Vector<3> centre_of(const Polyhedron& p) { return {p.centre.x, p.centre.y, p.centre.z}; }

  static halfspace::Polyhedron hull_of(const Polyhedron& polyhedron) {
    std::vector<halfspace::Vector<3>> points;
    for (const auto& p : polyhedron.vertices) points.push_back({p.x, p.y, p.z});
    halfspace::Polyhedron hull(std::pmr::get_default_resource());
    if (halfspace::convex_hull(points, hull).fault != halfspace::Fault::none)
      throw std::runtime_error("no hull of one of the polyhedra");
    return hull;
  }

  halfspace::Shape<3> shape;
  halfspace::Vector<3> centroid;
};

}  // namespace halfspace_benchmark
