#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "catch.h"
#include "geometry/polyhedron/hull.h"
#include "polyhedra.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

struct Moments {
  double volume;
  double second;  // of each axis: the solids are as round as a ball in this
  double cosine_of_dihedral;
};

/// Edge length 1. Textbook volumes and angles; the second moment is V/5 times the mean square of x over ...,
/// from the moment of inertia 2 * second, e.g. 1/20 m of the tetrahedron, 1/6 m of the cube, 1/10 m of the
/// octahedron.
Moments moments_of(const std::string& name) {
  const double g = std::numbers::phi;
  const double root2 = std::sqrt(2), root5 = std::sqrt(5);
  if (name == "tetrahedron") return {root2 / 12, root2 / 12 / 40, 1.0 / 3};
  if (name == "cube") return {1, 1.0 / 12, 0};
  if (name == "octahedron") return {root2 / 3, root2 / 3 / 20, -1.0 / 3};
  if (name == "dodecahedron") {
    const double volume = (15 + 7 * root5) / 4;
    return {volume, volume * (39 * g + 28) / 300, -1 / root5};
  }
  const double volume = 5 * g * g / 6;
  return {volume, volume * g * g / 20, -root5 / 3};
}

}  // namespace

TEST_CASE("Platonic solids have the textbook's volume, inertia, dihedral angle and whole faces") {
  for (const PlatonicSolid& solid : platonic_solids()) {
    INFO(solid.name);
    const Shape<3> shape = shape_of(hull_of(solid.vertices));
    const Moments wanted = moments_of(solid.name);
    REQUIRE(shape.face_count() == solid.faces);
    REQUIRE(shape.vertex_count() == int(solid.vertices.size()));
    // Each coordinate carries an ulp; volumes and moments are products of three and five, summed over few
    // faces.
    CHECK(shape.volume() == Approx(wanted.volume).epsilon(1e-14));
    CHECK(shape.centroid().norm() < 1e-15);
    for (int i = 0; i < 3; ++i) {
      CHECK(shape.second_moment()[i] == Approx(wanted.second).epsilon(1e-14));
      CHECK(std::abs(shape.second_moment()[i + 3]) < 1e-15 * wanted.volume);
    }
    CHECK((shape.inertia() - 2 * wanted.second * Eigen::Matrix3d::Identity()).norm() < 1e-13 * wanted.volume);
    CHECK(shape.shortest_edge() == Approx(1).epsilon(1e-15));
    CHECK(shape.longest_edge() == Approx(1).epsilon(1e-15));

    const Topology& t = shape.topology();
    for (int f = 0; f < t.face_count; ++f)
      CHECK(t.first_of_face[f + 1] - t.first_of_face[f] == solid.corners_of_face);
    for (int v = 0; v < t.vertex_count; ++v)
      CHECK(t.first_of_vertex[v + 1] - t.first_of_vertex[v] == solid.faces_at_vertex);
    for (int e = 0; e < t.edge_count; ++e) {
      const double cosine =
          shape.outline().normal(t.edge_left[e]).dot(shape.outline().normal(t.edge_right[e]));
      CHECK(-cosine == Approx(wanted.cosine_of_dihedral).margin(1e-15));
    }
  }
}

TEST_CASE("moments of a box are the textbook's, to the bit far from the origin too") {
  for (double away : {0.0, 1e8}) {
    const Shape<3> shape = shape_of(completed(box({4, 2, 1}, {away, -away, 2 * away})));
    CHECK(shape.volume() == 8);
    CHECK(shape.centroid() == Vector<3>(away, -away, 2 * away));
    CHECK(shape.second_moment()[0] == Approx(8 * 16 / 12.0).epsilon(1e-15));
    CHECK(shape.second_moment()[1] == Approx(8 * 4 / 12.0).epsilon(1e-15));
    CHECK(shape.second_moment()[2] == Approx(8 * 1 / 12.0).epsilon(1e-15));
    CHECK(shape.second_moment().tail<3>().norm() < 1e-14);
    CHECK(shape.inertia()(0, 0) == Approx(8 * (4 + 1) / 12.0).epsilon(1e-15));
    CHECK(shape.bounding_radius() == std::sqrt(4 + 1 + 0.25));
    CHECK(shape.shortest_edge() == 1);
    CHECK(shape.longest_edge() == 4);
  }
}

TEST_CASE("inertia turns with the shape") {
  Random random(11);
  for (int round = 0; round < 50; ++round) {
    const Cloud points = random_cloud(random, 30, 0.5, 1);
    const Eigen::Matrix3d turn = random_rotation(random);
    Cloud turned;
    for (const Vector<3>& p : points) turned.push_back(turn * p);
    const Shape<3> a = shape_of(hull_of(points));
    const Shape<3> b = shape_of(hull_of(turned));
    // Turning rounds each coordinate by an ulp or two.
    CHECK(b.volume() == Approx(a.volume()).epsilon(1e-14));
    CHECK((turn * a.centroid() - b.centroid()).norm() < 1e-14);
    CHECK((turn * a.inertia() * turn.transpose() - b.inertia()).norm() < 1e-13 * a.volume());
  }
}

TEST_CASE("scaling by a power of two gives the same bits, scaled") {
  Random random(12);
  for (const int exponent : {-60, -1, 3, 90}) {
    const Cloud points = random_cloud(random, 60, 0.8, 1);
    Cloud scaled;
    for (const Vector<3>& p : points) scaled.push_back(p * std::ldexp(1.0, exponent));
    const Shape<3> a = shape_of(hull_of(points));
    const Shape<3> b = shape_of(hull_of(scaled));
    REQUIRE(a.face_count() == b.face_count());
    CHECK(b.volume() == std::ldexp(a.volume(), 3 * exponent));
    for (int i = 0; i < 6; ++i) CHECK(b.second_moment()[i] == std::ldexp(a.second_moment()[i], 5 * exponent));
    for (int f = 0; f < a.face_count(); ++f) {
      CHECK(a.outline().normal(f) == b.outline().normal(f));
      CHECK(b.outline().offset[f] == std::ldexp(a.outline().offset[f], exponent));
    }
    CHECK(b.bounding_radius() == std::ldexp(a.bounding_radius(), exponent));
  }
}

TEST_CASE("neighbours in every list name each other, in cyclic order") {
  Random random(13);
  for (int round = 0; round < 20; ++round) {
    const Shape<3> shape = shape_of(hull_of(random_cloud(random, random.integer(4, 200), 0.2, 1)));
    const Topology& t = shape.topology();
    REQUIRE(t.vertex_count - t.edge_count + t.face_count == 2);
    for (int f = 0; f < t.face_count; ++f) {
      const int first = t.first_of_face[f], count = t.first_of_face[f + 1] - first;
      Vector<3> around = Vector<3>::Zero();
      for (int i = 0; i < count; ++i) {
        const int here = t.face_vertex[first + i], next = t.face_vertex[first + (i + 1) % count];
        const int e = t.face_edge[first + i];
        const bool is_left = t.edge_left[e] == f;
        REQUIRE((is_left ? t.edge_start[e] : t.edge_end[e]) == here);
        REQUIRE((is_left ? t.edge_end[e] : t.edge_start[e]) == next);
        REQUIRE((is_left ? t.edge_left[e] : t.edge_right[e]) == f);
        around += cross_product(shape.outline().vertex(here), shape.outline().vertex(next));
      }
      CHECK(around.dot(shape.outline().normal(f)) > 0);  // counter-clockwise seen from outside
    }
    for (int v = 0; v < t.vertex_count; ++v) {
      const int first = t.first_of_vertex[v], count = t.first_of_vertex[v + 1] - first;
      double turn = 0;
      const Vector<3> here = shape.outline().vertex(v);
      for (int k = 0; k < count; ++k) {
        const int e = t.vertex_edge[first + k], face = t.vertex_face[first + k];
        const int before = (k + count - 1) % count, after = (k + 1) % count;
        REQUIRE(((t.edge_start[e] == v && t.edge_end[e] == t.vertex_neighbour[first + k]) ||
                 (t.edge_end[e] == v && t.edge_start[e] == t.vertex_neighbour[first + k])));
        // Going out along the edge, the face that follows is on the left and the one before on the right.
        REQUIRE((t.edge_start[e] == v ? t.edge_left[e] : t.edge_right[e]) == face);
        REQUIRE((t.edge_start[e] == v ? t.edge_right[e] : t.edge_left[e]) == t.vertex_face[first + before]);
        const Vector<3> a = shape.outline().vertex(t.vertex_neighbour[first + k]) - here;
        const Vector<3> b = shape.outline().vertex(t.vertex_neighbour[first + after]) - here;
        turn += std::acos(std::clamp(a.normalized().dot(b.normalized()), -1.0, 1.0));
      }
      CHECK(turn < 2 * std::numbers::pi);  // once around: a convex corner's angles are less than a full turn
    }
  }
}

TEST_CASE("arrays are padded to fours with their last entry") {
  Random random(14);
  for (int count = 4; count < 12; ++count) {
    const Shape<3> shape = shape_of(hull_of(random_cloud(random, count, 1, 1)));
    const Outline<3>& o = shape.outline();
    for (int i = o.vertex_count(); i < Outline<3>::padded(o.vertex_count()); ++i)
      CHECK(o.vertex(i) == o.vertex(o.vertex_count() - 1));
    for (int f = o.face_count(); f < Outline<3>::padded(o.face_count()); ++f) {
      CHECK(o.normal(f) == o.normal(o.face_count() - 1));
      CHECK(o.offset[f] == o.offset[o.face_count() - 1]);
    }
  }
}

TEST_CASE("every vertex is inside every half-space and on those of its own faces") {
  Random random(15);
  for (int round = 0; round < 50; ++round) {
    const Shape<3> shape = shape_of(hull_of(random_cloud(random, 40, 0.7, 1)));
    const Outline<3>& o = shape.outline();
    const Topology& t = shape.topology();
    for (int f = 0; f < t.face_count; ++f) {
      CHECK(o.normal(f).norm() == Approx(1).epsilon(1e-15));
      for (int v = 0; v < t.vertex_count; ++v) {
        const double height = o.normal(f).dot(o.vertex(v)) - o.offset[f];
        const bool is_own =
            std::find(t.face_vertex + t.first_of_face[f], t.face_vertex + t.first_of_face[f + 1], v) !=
            t.face_vertex + t.first_of_face[f + 1];
        if (is_own) CHECK(std::abs(height) < flatness_tolerance(1));
        if (!is_own) CHECK(height < 0);
      }
    }
  }
}

TEST_CASE("a prism of a thousand sides, and a pyramid on it") {
  const int n = 1000;
  Cloud prism, pyramid;
  for (const Vector<2>& p : regular_polygon(n, 1)) {
    prism.push_back({p.x(), p.y(), -1});
    prism.push_back({p.x(), p.y(), 1});
    pyramid.push_back({p.x(), p.y(), 0});
  }
  pyramid.push_back({0, 0, 3});
  const double area = 0.5 * n * std::sin(2 * std::numbers::pi / n);
  const Shape<3> a = shape_of(hull_of(prism));
  CHECK(a.face_count() == n + 2);
  CHECK(a.volume() == Approx(2 * area).epsilon(n * 1e-15));
  const Shape<3> b = shape_of(hull_of(pyramid));
  CHECK(b.face_count() == n + 1);
  CHECK(b.volume() == Approx(area).epsilon(n * 1e-15));
  CHECK(b.centroid().z() == Approx(0.75).epsilon(n * 1e-15));
}

TEST_CASE("a hull keeps corners only: points inside, on faces and on edges go") {
  Cloud grid;
  for (int i = 0; i < 1000; ++i) grid.push_back({i % 10 * 0.3, i / 10 % 10 * 0.7, i / 100 * 1.1});
  const Polyhedron hull = hull_of(grid);
  CHECK(hull.face_count() == 6);
  REQUIRE(hull.vertex_count() == 8);
  CHECK(hull.vertices[0] == grid[0]);
  CHECK(hull.vertices[7] == grid[999]);
}

TEST_CASE("points without a hull are refused with the reason") {
  const auto fault_of = [](const Cloud& points) {
    Polyhedron hull(std::pmr::get_default_resource());
    const Fault fault = convex_hull(points, hull).fault;
    CHECK(hull.is_empty());
    return int(fault);
  };
  CHECK(fault_of({}) == int(Fault::fewer_than_four));
  CHECK(fault_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}) == int(Fault::fewer_than_four));
  CHECK(fault_of({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}) == int(Fault::out_of_range));
  CHECK(fault_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}, {6, 6, 6}}) == int(Fault::zero_volume));
  CHECK(fault_of({{0, 0, 0}, {1, 0, 0.1}, {0, 1, 0.1}, {1, 1, 0.2}, {3, 2, 0.5}}) == int(Fault::zero_volume));
  CHECK(fault_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, HUGE_VAL}}) == int(Fault::out_of_range));
}
