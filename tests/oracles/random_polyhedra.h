#pragma once

// Random convex polyhedra and turns, from a seed. Shared by the oracles and the benchmarks.

#include <random>

#include "oracles/polyhedron_3d.h"
#include "oracles/random_gap.h"

namespace halfspace_test {

using Random3 = std::mt19937_64;

/// Uniform on the unit sphere.
Point3 random_direction(Random3& random);

/// Uniform over all turns, at a position.
hs_pose turned_at_random(const Point3& position, Random3& random);

/// A point of the frame of a pose, about its position, turned only.
Point3 turned(const hs_pose& pose, const Point3& direction);

/// The box from low to high.
Polyhedron box_3d(const Point3& low, const Point3& high);

/// Vertices on a sphere, each off its regular place by up to a fifth of the spacing. The regular places are
/// those of a tetrahedron for 4 vertices, and on a spiral from pole to pole for more.
Polyhedron round_polyhedron(int vertices, double radius, Random3& random);

}  // namespace halfspace_test
