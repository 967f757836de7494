#include <Eigen/LU>
#include <cmath>

#include "block/deformation.h"
#include "catch.h"
#include "contacts_3d.h"
#include "force/spring/overlap.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

Memory* const memory = std::pmr::get_default_resource();

/// Of a body the mean squared distance from the line through its centroid along a normal.
double squared_radius_about(const Shape<3>& body, const Vector<3>& normal) {
  const Eigen::Matrix3d moment = second_moment_of(body);
  return (moment.trace() - normal.dot(moment * normal)) / body.volume();
}

/// Area of a body's shadow along a normal.
double shadow(const Shape<3>& body, const Vector<3>& normal) {
  const Topology& t = body.topology();
  double area = 0;
  for (int f = 0; f < body.face_count(); ++f) {
    const Vector<3> first = body.outline().vertex(t.face_vertex[t.first_of_face[f]]);
    for (int k = t.first_of_face[f] + 1; k + 1 < t.first_of_face[f + 1]; ++k)
      area += 0.25 * std::abs(normal.dot(cross_product(body.outline().vertex(t.face_vertex[k]) - first,
                                                       body.outline().vertex(t.face_vertex[k + 1]) - first)));
  }
  return area;
}

Overlap<3> overlap_along(const Shape<3>& a, const Shape<3>& b, const Vector<3>& to_b,
                         const Vector<3>& normal) {
  return measure_overlap(a.outline(), b.outline(), to_b, normal, Vector<3>(0.5 * to_b));
}

}  // namespace

TEST_CASE("cubes face to face: volume, area, centre and radius are exact") {
  const Shape<3> cube = block_of(prism(rectangle(1, 1), 1));
  const Vector<3> to_b(0.25, 0.5, 0.875);
  const Overlap<3> overlap =
      measure_overlap(cube.outline(), cube.outline(), to_b, {0, 0, 1}, Vector<3>(0, 0, 0.5));
  CHECK(overlap.content == Approx(0.125 * 0.75 * 0.5).epsilon(1e-15));
  CHECK(overlap.base == Approx(0.75 * 0.5).epsilon(1e-15));
  CHECK(overlap.depth_squared == Approx(0.125 * 0.125 * 0.75 * 0.5).epsilon(1e-15));
  CHECK((overlap.center - Vector<3>(0.125, 0.25, 0.5)).norm() < 1e-15);
  CHECK(overlap.twist_radius == Approx(std::sqrt((0.75 * 0.75 + 0.5 * 0.5) / 12)).epsilon(1e-14));
}

TEST_CASE("random blocks: the overlap is that of their intersection, seen along any normal") {
  Random random(3);
  int overlapping = 0;
  for (int i = 0; i < 300; ++i) {
    const Shape<3> a = random_block(random, random.integer(4, 24)),
                   b = random_block(random, random.integer(4, 24));
    const Vector<3> to_b = random_vector(random, -0.8, 0.8), normal = random_direction(random);
    const Overlap<3> overlap = overlap_along(a, b, to_b, normal);
    const Polyhedron part = intersection_by_cutting(a, b, to_b);
    if (part.is_empty()) {
      CHECK(overlap.content < 1e-12);
      continue;
    }
    const Shape<3> body(part, memory);
    // Cutting puts its new corners off by some roundings of the coordinates, which are about 1; the radius of
    // a thin body by as much over its volume.
    const double rounding = 1e-13 / body.volume();
    CHECK(overlap.content == Approx(body.volume()).margin(1e-13));
    if (body.volume() < 1e-5) continue;
    ++overlapping;
    const Vector<3> off = overlap.center - body.centroid();
    CHECK((off - normal.dot(off) * normal).norm() < rounding);
    CHECK(std::abs(normal.dot(overlap.center - 0.5 * to_b)) < 1e-14);
    CHECK(overlap.twist_radius == Approx(std::sqrt(squared_radius_about(body, normal))).margin(rounding));
    // Where the intersection goes all the way from a's upper side to b's lower side, which it does along the
    // normal of least depth.
    const Separation<3> least = pair_of_largest_gap(a.outline(), b.outline(), to_b);
    if (least.gap > -0.05) {
      const Overlap<3> at_contact = overlap_along(a, b, to_b, least.normal);
      CHECK(at_contact.base <= shadow(body, least.normal) + rounding);
    }
  }
  CHECK(overlapping > 100);
}

TEST_CASE("the depth squared is twice the integral of the volume over the way in") {
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    const Shape<3> a = random_block(random, random.integer(4, 20)),
                   b = random_block(random, random.integer(4, 20));
    const Vector<3> to_b = random_vector(random, -0.6, 0.6), normal = random_direction(random);
    // The volume is smooth but for its third derivatives: central differences are off by the square of the
    // step, and by rounding over the step.
    const double step = 1e-5;
    const double rate = (overlap_along(a, b, to_b - step * normal, normal).depth_squared -
                         overlap_along(a, b, to_b + step * normal, normal).depth_squared) /
                        (2 * step);
    CHECK(rate == Approx(2 * overlap_along(a, b, to_b, normal).content).margin(1e-8));
  }
}

TEST_CASE("seen from the other block the overlap is the same") {
  Random random(9);
  for (int i = 0; i < 100; ++i) {
    const Shape<3> a = random_block(random, 12), b = random_block(random, 9);
    const Vector<3> to_b = random_vector(random, -0.6, 0.6), normal = random_direction(random);
    const Overlap<3> one = overlap_along(a, b, to_b, normal), other = overlap_along(b, a, -to_b, -normal);
    CHECK(one.content == Approx(other.content).margin(1e-14));
    CHECK(one.depth_squared == Approx(other.depth_squared).margin(1e-14));
    CHECK(one.base == Approx(other.base).margin(1e-14));
    if (one.content > 1e-4) CHECK((one.center - (other.center + to_b)).norm() < 1e-9);
  }
}

TEST_CASE("faces of many corners and blocks of many vertices are taken in pieces") {
  const Shape<3> a = block_of(prism(regular_polygon(100, 1), 1));
  const Shape<3> b = block_of(prism(regular_polygon(70, 1, 0.1), 1));
  const Vector<3> to_b(0.1, 0.2, 0.9);
  const Overlap<3> overlap = overlap_along(a, b, to_b, {0, 0, 1});
  const Shape<3> body(intersection_by_cutting(a, b, to_b), memory);
  CHECK(overlap.content == Approx(body.volume()).epsilon(1e-12));
  CHECK(overlap.base == Approx(body.volume() / 0.1).epsilon(1e-12));
  CHECK(overlap.depth_squared == Approx(body.volume() * 0.1).epsilon(1e-12));
}

TEST_CASE("scaling by a power of two scales the overlap bit for bit") {
  Random random(13);
  for (int i = 0; i < 20; ++i) {
    const Cloud p = random_cloud(random, 10, 0.4, 0.6), q = random_cloud(random, 10, 0.4, 0.6);
    const Vector<3> to_b = random_vector(random, -0.5, 0.5), normal = random_direction(random);
    const double f = 0x1p20;
    Cloud large_p = p, large_q = q;
    for (Vector<3>& v : large_p) v *= f;
    for (Vector<3>& v : large_q) v *= f;
    const Overlap<3> small = overlap_along(block_of(p), block_of(q), to_b, normal);
    const Overlap<3> large = overlap_along(block_of(large_p), block_of(large_q), f * to_b, normal);
    CHECK(large.content == f * f * f * small.content);
    CHECK(large.depth_squared == f * f * f * f * small.depth_squared);
    CHECK(large.base == f * f * small.base);
    CHECK(large.center == f * small.center);
    CHECK(large.twist_radius == f * small.twist_radius);
  }
}
