#include "catch.h"
#include "contacts_3d.h"
#include "geometry/polyhedron/cut.h"
#include "geometry/polyhedron/division.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

Memory* const memory = std::pmr::get_default_resource();

void check_content(const VolumeAndMoment& found, const Polyhedron& expected) {
  const Shape<3> body(expected, memory);
  CHECK(found.volume == Approx(body.volume()).margin(1e-13));
  CHECK((found.moment - body.volume() * body.centroid()).norm() <= 1e-13);
}

/// Behind a plane through a point.
Halfspace<3> plane_at(const Vector<3>& point, const Vector<3>& normal) { return {normal, normal.dot(point)}; }

/// The number of a new face: the block's own come before it.
DividedPolyhedron::Index first_number(const Shape<3>& block) {
  return DividedPolyhedron::Index(block.outline().face_count());
}

}  // namespace

TEST_CASE("the parts of a divided polyhedron are those that cutting it leaves") {
  Random random(91);
  int divided_twice = 0;
  for (int round = 0; round < 300; ++round) {
    const Shape<3> block = random_block(random, random.integer(4, 40));
    Polyhedron whole = polyhedron_of(block, memory);
    for (Vector<3>& v : whole.vertices) v -= block.centroid();
    const Vector<3> point = random_vector(random, -0.2, 0.2), normal = random_direction(random);
    const Polyhedron first = cut_polyhedron(whole, point, normal, memory).behind;

    VertexDepths sounding(memory);
    const DepthRange height = sounding.take(block.outline(), plane_at(point, normal));
    if (height.least > -0.01 || height.most < 0.01) continue;
    DividedPolyhedron divided(memory);
    divided.begin(block.outline(), sounding, first_number(block));
    Array<DividedPolyhedron::Index> part(divided.inside().begin(), divided.inside().end());
    const VolumeAndMoment content = divided.measure(part);
    check_content(content, first);

    const Vector<3> next_point = random_vector(random, -0.2, 0.2), next_normal = random_direction(random);
    const DepthRange depths = divided.sound(part, plane_at(next_point, next_normal));
    if (depths.least > -0.01 || depths.most < 0.01) continue;
    ++divided_twice;
    const PolyhedronParts parts = cut_polyhedron(first, next_point, next_normal, memory);
    divided.cut_edges(part);
    check_content(divided.measure_inside(), parts.behind);
    divided.close_both(first_number(block) + 1);
    const Array<DividedPolyhedron::Index> inside(divided.inside().begin(), divided.inside().end()),
        outside(divided.outside().begin(), divided.outside().end());
    check_content(divided.measure(inside), parts.behind);
    check_content(divided.measure(outside), parts.ahead);
  }
  CHECK(divided_twice > 200);
}

TEST_CASE("a divided polyhedron loses nothing where planes pass through its vertices, edges and faces") {
  const Shape<3> cube = shape_of(completed(box({2, 2, 2})));
  Random random(92);
  for (int round = 0; round < 300; ++round) {
    const auto draw_plane = [&] {
      Vector<3> normal;
      do {
        for (double& component : normal) component = random.integer(-1, 1);
      } while (normal.isZero(0));
      return Halfspace<3>{normal, double(random.integer(-1, 1))};
    };
    VertexDepths sounding(memory);
    const Halfspace<3> first = draw_plane();
    if (sounding.take(cube.outline(), first).most <= 0) continue;
    DividedPolyhedron divided(memory);
    divided.begin(cube.outline(), sounding, first_number(cube));
    Array<DividedPolyhedron::Index> part(divided.inside().begin(), divided.inside().end());
    for (int cut = 0; cut < 4; ++cut) {
      const VolumeAndMoment content = divided.measure(part);
      divided.sound(part, draw_plane());
      divided.cut_edges(part);
      const VolumeAndMoment inside = divided.measure_inside();
      divided.close_both(first_number(cube) + 1 + DividedPolyhedron::Index(cut));
      const Array<DividedPolyhedron::Index> kept(divided.inside().begin(), divided.inside().end()),
          rest(divided.outside().begin(), divided.outside().end());
      const VolumeAndMoment outside = divided.measure(rest);
      CHECK(divided.measure(kept).volume == Approx(inside.volume).margin(1e-14));
      CHECK(inside.volume + outside.volume == Approx(content.volume).margin(1e-14));
      CHECK((inside.moment + outside.moment - content.moment).norm() <= 1e-14);
      part = inside.volume > outside.volume ? kept : rest;
    }
  }
}
