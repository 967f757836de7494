#include "polyhedra.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "catch.h"
#include "geometry/polyhedron/cut.h"
#include "geometry/polyhedron/hull.h"

namespace halfspace::test {

Polyhedron faces_of(const Cloud& vertices, std::initializer_list<std::initializer_list<int>> loops) {
  Polyhedron p(std::pmr::get_default_resource());
  p.vertices.assign(vertices.begin(), vertices.end());
  for (const auto& loop : loops) {
    for (const int v : loop) p.append_corner(v);
    p.end_face();
  }
  return p;
}

Polyhedron box(const Vector<3>& size, const Vector<3>& center) {
  Cloud vertices;
  for (int i = 0; i < 8; ++i) {
    const Vector<3> corner(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
    vertices.push_back(center + size.cwiseProduct(corner));
  }
  return faces_of(vertices,
                  {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

Polyhedron completed(Polyhedron polyhedron) {
  REQUIRE(complete_polyhedron(polyhedron).fault == Fault::none);
  return polyhedron;
}

Polyhedron hull_of(const Cloud& points) {
  Polyhedron hull(std::pmr::get_default_resource());
  const PolyhedronFault report = convex_hull(points, hull);
  INFO(fault_text(report.fault) << ", vertex " << report.vertex << ", face " << report.face);
  REQUIRE(int(report.fault) == int(Fault::none));
  return hull;
}

Polyhedron copy_of(const Polyhedron& polyhedron) {
  return Polyhedron(polyhedron, std::pmr::get_default_resource());
}

Shape<3> shape_of(const Polyhedron& polyhedron) {
  return Shape<3>(polyhedron, std::pmr::get_default_resource());
}

Polyhedron intersection_by_cutting(const Shape<3>& a, const Shape<3>& b, const Vector<3>& to_b) {
  Memory* const memory = std::pmr::get_default_resource();
  Polyhedron part = polyhedron_of(b, memory);
  for (Vector<3>& v : part.vertices) v += to_b - b.centroid();
  const Outline<3>& o = a.outline();
  for (int f = 0; f < a.face_count() && !part.is_empty(); ++f) {
    const Vector<3> corner = o.vertex(a.topology().face_vertex[a.topology().first_of_face[f]]);
    part = cut_polyhedron(part, corner, o.normal(f), memory).behind;
  }
  return part;
}

Vector<3> random_vector(Random& random, double lower, double upper) {
  const double x = random.uniform(lower, upper);
  const double y = random.uniform(lower, upper);
  const double z = random.uniform(lower, upper);
  return {x, y, z};
}

Vector<3> random_direction(Random& random) {
  while (true) {
    const Vector<3> v = random_vector(random, -1, 1);
    if (v.norm() > 0.1 && v.norm() <= 1) return v.normalized();
  }
}

Eigen::Matrix3d random_rotation(Random& random) {
  const Vector<3> axis = random_direction(random);
  return Eigen::AngleAxisd(random.uniform(0, 2 * std::numbers::pi), axis).toRotationMatrix();
}

Cloud random_cloud(Random& random, int count, double inner_radius, double outer_radius) {
  Cloud points;
  for (int i = 0; i < count; ++i) {
    const Vector<3> direction = random_direction(random);
    points.push_back(random.uniform(inner_radius, outer_radius) * direction);
  }
  return points;
}

std::vector<PlatonicSolid> platonic_solids() {
  const double g = std::numbers::phi;
  // Coordinates of edge length `edge`, divided by it.
  const auto with_edge = [](double edge, Cloud vertices) {
    for (Vector<3>& v : vertices) v /= edge;
    return vertices;
  };
  const auto with_all_signs = [](std::initializer_list<Vector<3>> vertices) {
    Cloud all;
    for (const Vector<3>& v : vertices) {
      for (int i = 0; i < 8; ++i) {
        const Vector<3> sign(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        const bool is_new = !((v.x() == 0 && i & 1) || (v.y() == 0 && i & 2) || (v.z() == 0 && i & 4));
        if (is_new) all.push_back(sign.cwiseProduct(v));
      }
    }
    return all;
  };
  return {
      {"tetrahedron", with_edge(2 * std::sqrt(2), {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}), 4, 3,
       3},
      {"cube", with_edge(2, with_all_signs({{1, 1, 1}})), 6, 4, 3},
      {"octahedron", with_edge(std::sqrt(2), with_all_signs({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})), 8, 3, 4},
      {"dodecahedron",
       with_edge(2 / g, with_all_signs({{1, 1, 1}, {0, 1 / g, g}, {1 / g, g, 0}, {g, 0, 1 / g}})), 12, 5, 3},
      {"icosahedron", with_edge(2, with_all_signs({{0, 1, g}, {1, g, 0}, {g, 0, 1}})), 20, 3, 5},
  };
}

}  // namespace halfspace::test
