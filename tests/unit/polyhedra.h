#pragma once

#include <initializer_list>
#include <vector>

#include "geometry/polyhedron/check.h"
#include "geometry/shape.h"
#include "polygons.h"

namespace halfspace::test {

using Cloud = std::vector<Vector<3>>;

/// Vertices and loops alone, without normals.
Polyhedron faces_of(const Cloud& vertices, std::initializer_list<std::initializer_list<int>> loops);
/// The box from -size / 2 to size / 2, as vertices and loops.
Polyhedron box(const Vector<3>& size, const Vector<3>& center = {0, 0, 0});
/// What complete_polyhedron() makes of it; it must find no fault.
Polyhedron completed(Polyhedron polyhedron);
/// The hull of a cloud that has one.
Polyhedron hull_of(const Cloud& points);
Polyhedron copy_of(const Polyhedron& polyhedron);
Shape<3> shape_of(const Polyhedron& polyhedron);
/// What two blocks have in common, by cutting one by all faces of the other. Empty when there is nothing.
Polyhedron intersection_by_cutting(const Shape<3>& a, const Shape<3>& b, const Vector<3>& to_b);

Vector<3> random_vector(Random& random, double lower, double upper);
Vector<3> random_direction(Random& random);
/// A right-handed rotation.
Eigen::Matrix3d random_rotation(Random& random);
/// Points between two concentric spheres.
Cloud random_cloud(Random& random, int count, double inner_radius, double outer_radius);

/// One of the five, as the hull of its vertices, with edges of length 1.
struct PlatonicSolid {
  const char* name;
  Cloud vertices;
  int faces;
  int corners_of_face;
  int faces_at_vertex;
};
std::vector<PlatonicSolid> platonic_solids();

}  // namespace halfspace::test
