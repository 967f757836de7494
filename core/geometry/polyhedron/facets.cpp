#include "geometry/polyhedron/facets.h"

#include <algorithm>

#include "geometry/precise.h"

namespace halfspace {
namespace {

bool is_inside_out(const Polyhedron& p) {
  const Vector<3>& origin = p.vertices[0];
  double volume = 0;
  for (std::int32_t f = 0; f < p.face_count(); ++f) volume += area_vector(p, f).dot(p.corner(f, 0) - origin);
  return volume < 0;
}

}  // namespace

Vector<3> area_vector(const Polyhedron& polyhedron, std::int32_t face) {
  Vector<3> area = Vector<3>::Zero();
  for (std::size_t i = 1; i + 1 < polyhedron.loop(face).size(); ++i) {
    area += precise_cross_product(polyhedron.corner(face, 0), polyhedron.corner(face, i),
                                  polyhedron.corner(face, i + 1));
  }
  return area;
}

void turn_outward(Polyhedron& polyhedron) {
  if (!is_inside_out(polyhedron)) return;
  for (std::int32_t f = 0; f < polyhedron.face_count(); ++f) {
    std::reverse(polyhedron.face_vertices.begin() + polyhedron.first_of_face[std::size_t(f)],
                 polyhedron.face_vertices.begin() + polyhedron.first_of_face[std::size_t(f) + 1]);
  }
}

}  // namespace halfspace
