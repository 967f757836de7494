#include "catch.h"
#include "contacts_3d.h"
#include "geometry/polyhedron/clipped.h"
#include "geometry/polyhedron/cut.h"

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

}  // namespace

TEST_CASE("a clipped polyhedron is the part that cutting it leaves") {
  Random random(91);
  int clipped_twice = 0;
  for (int round = 0; round < 300; ++round) {
    const Shape<3> block = random_block(random, random.integer(4, 40));
    Polyhedron whole = polyhedron_of(block, memory);
    for (Vector<3>& v : whole.vertices) v -= block.centroid();
    const Vector<3> point = random_vector(random, -0.2, 0.2), normal = random_direction(random);
    const Polyhedron first = cut_polyhedron(whole, point, normal, memory).behind;

    VertexDepths sounding(memory);
    const DepthRange height = sounding.take(block.outline(), plane_at(point, normal));
    if (height.least > -0.01 || height.most < 0.01) continue;
    ClippedPolyhedron clipped(memory), ahead(memory);
    clipped.begin(block.outline(), sounding);
    check_content(clipped.measure(), first);
    check_content(clipped.measure_with_spread(), first);
    ahead.begin(clipped);

    const Vector<3> next_point = random_vector(random, -0.2, 0.2), next_normal = random_direction(random);
    const DepthRange depths = clipped.sound(plane_at(next_point, next_normal));
    if (depths.least > -0.01 || depths.most < 0.01) continue;
    ++clipped_twice;
    const PolyhedronParts parts = cut_polyhedron(first, next_point, next_normal, memory);
    clipped.cut();
    check_content(clipped.measure(), parts.behind);
    ahead.sound(plane_at(next_point, -next_normal));
    ahead.cut();
    check_content(ahead.measure(), parts.ahead);
  }
  CHECK(clipped_twice > 200);
}

TEST_CASE("a clipped polyhedron loses nothing where planes pass through its vertices, edges and faces") {
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
    ClippedPolyhedron part(memory), behind(memory), ahead(memory);
    part.begin(cube.outline(), sounding);
    for (int cut = 0; cut < 4; ++cut) {
      const VolumeAndMoment content = part.measure();
      const Halfspace<3> plane = draw_plane();
      const auto keep = [&](ClippedPolyhedron& kept, const Halfspace<3>& what) {
        kept.begin(part);
        kept.sound(what);
        kept.cut();
        return kept.measure();
      };
      const VolumeAndMoment inside = keep(behind, plane),
                            outside = keep(ahead, {-plane.normal, -plane.offset});
      CHECK(inside.volume + outside.volume == Approx(content.volume).margin(1e-14));
      CHECK((inside.moment + outside.moment - content.moment).norm() <= 1e-14);
      part.begin(inside.volume > outside.volume ? behind : ahead);
    }
  }
}
