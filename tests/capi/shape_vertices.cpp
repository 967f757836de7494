// hs_shape_set_vertices(): the shape is as if it had been created so, or has not changed.

#include <algorithm>
#include <cmath>
#include <cstring>

#include "capi/refusals.h"
#include "capi/snapshot_worlds.h"
#include "catch.h"

namespace halfspace_test {
namespace {

/// Properties, vertices and half-spaces have the same bits.
void check_same(const hs_shape* a, const hs_shape* b) {
  const hs_shape_properties of_a = properties_of(a), of_b = properties_of(b);
  CHECK(std::memcmp(&of_a, &of_b, sizeof of_a) == 0);
  const Points3 vertices_a = vertices_3d_of(a), vertices_b = vertices_3d_of(b);
  CHECK(std::memcmp(vertices_a.data(), vertices_b.data(), vertices_a.size() * sizeof(Point3)) == 0);
  const Halfspaces half_a = halfspaces_of(a), half_b = halfspaces_of(b);
  CHECK(half_a.offsets == half_b.offsets);
  CHECK(std::memcmp(half_a.normals.data(), half_b.normals.data(), half_a.normals.size() * sizeof(Point3)) ==
        0);
}

/// Sheared, stretched and moved: planes stay planes.
Points3 deformed(Points3 points, double shear) {
  for (Point3& p : points)
    p = {3 + 1.25 * p.x + shear * p.y, 0.5 * p.y - shear * p.z, 2 * p.z + 0.25 * shear * p.x};
  return points;
}

Solid shape_of(const Points3& vertices, const Faces& faces) { return {vertices, faces}; }

}  // namespace

TEST_CASE("a polygon with moved vertices is the one made of them") {
  const Context context = make_context();
  const bool is_clockwise = GENERATE(false, true);
  Points before{{0, 0}, {2, 0}, {3, 1}, {2, 2.5}, {0, 2}},
      after{{0.5, 1}, {2, 0.25}, {3.5, 1}, {2, 3}, {0, 2}};
  if (is_clockwise) {
    std::reverse(before.begin(), before.end());
    std::reverse(after.begin(), after.end());
  }
  const Shape moved = make_shape(context.get(), before), made = make_shape(context.get(), after);
  require_ok(hs_shape_set_vertices(moved.get(), view_of(after)), context.get());
  check_same(moved.get(), made.get());
  require_ok(hs_shape_set_vertices(moved.get(), view_of(before)), context.get());
  check_same(moved.get(), make_shape(context.get(), before).get());
}

TEST_CASE("a polyhedron with moved vertices is the one made of them") {
  const Context context = make_context();
  Random random(5);
  const int count = GENERATE(8, 40, 200);  // the last one with a Gauss map
  const Shape moved = count == 8 ? make_polyhedron(context.get(), cube())
                                 : make_hull(context.get(), round_points(random, count));
  const Faces faces = faces_of(moved.get());
  const Points3 before = vertices_3d_of(moved.get());
  for (const double shear : {0.0, 0.5, -0.75}) {
    const Points3 after = deformed(before, shear);
    require_ok(hs_shape_set_vertices(moved.get(), view_of(after)), context.get());
    const Shape made = make_polyhedron(context.get(), shape_of(after, faces));
    check_same(moved.get(), made.get());
    // Detection sees it, too.
    const Shape box = make_polyhedron(context.get(), cube());
    const hs_pose here = pose_at(0, 0), there = pose_at(0.75, 0.25);
    hs_contact one{}, other{};
    require_ok(hs_pair_detect(moved.get(), &here, box.get(), &there, nullptr, nullptr, &one), context.get());
    require_ok(hs_pair_detect(made.get(), &here, box.get(), &there, nullptr, nullptr, &other), context.get());
    CHECK(one.type == other.type);
    CHECK(one.gap == Approx(other.gap).epsilon(1e-14));
  }
}

TEST_CASE("a pair cache survives the motion of vertices") {
  const Context context = make_context();
  const int dimension = GENERATE(2, 3);
  const Shape moving = shape_of_box(context.get(), dimension), other = shape_of_box(context.get(), dimension);
  const Points3 start = vertices_3d_of(moving.get());
  hs_pair_cache cache{};
  // Grows to the right until it touches, and shrinks again.
  for (const double stretch : {1.0, 2.0, 2.9, 3.1, 4.0, 3.1, 2.9, 1.0}) {
    Points3 vertices = start;
    for (Point3& p : vertices) p.x *= stretch;
    require_ok(hs_shape_set_vertices(moving.get(), view_of(vertices)), context.get());
    const hs_pose here = pose_at(0, 0), there = pose_at(1, 0);
    hs_contact contact{};
    require_ok(hs_pair_detect(moving.get(), &here, other.get(), &there, nullptr, &cache, &contact),
               context.get());
    CHECK((contact.type != HS_CONTACT_NONE) == (stretch > 3));
    CHECK(contact.gap == Approx(0.75 - 0.25 * stretch).margin(1e-14));
  }
}

TEST_CASE("a world keeps its copy of a shape whose vertices move") {
  const Context context = make_context();
  const Shape square = shape_of_box(context.get(), 2);
  const World world = make_world(context.get(), world_def(2));
  std::int32_t material = -1;
  require_ok(hs_world_add_material(world.get(), 1000, &material), context.get());
  add_block(context.get(), world.get(), square, HS_BLOCK_FIXED, pose_at(0, 0));
  const std::vector<unsigned char> before = saved(world.get());
  require_ok(hs_shape_set_vertices(square.get(), view_of(box(0, 0, 3, 2))), context.get());
  CHECK(saved(world.get()) == before);
}

TEST_CASE("faulty vertices leave a shape as it is") {
  const Context context = make_context();
  hs_context* c = context.get();
  const Shape square = shape_of_box(c, 2), solid = shape_of_box(c, 3), twin = shape_of_box(c, 2),
              twin_solid = shape_of_box(c, 3);
  const Points few{{0, 0}, {1, 0}, {0, 1}}, dented{{0, 0}, {1, 0}, {0.2, 0.2}, {0, 1}};
  Points3 skew = vertices_3d_of(solid.get()), mirrored = skew, flat = skew, infinite = skew;
  skew[7].z += 0.01;
  for (Point3& p : mirrored) p.x = -p.x;
  for (Point3& p : flat) p.z = 0;
  infinite[2].y = HUGE_VAL;
  const auto set = [](const Shape& shape, hs_view vertices) {
    return [s = shape.get(), vertices] { return hs_shape_set_vertices(s, vertices); };
  };
  check_refusals(c, "hs_shape_set_vertices",
                 {{"vertices.count", "3", set(square, view_of(few))},
                  {"vertices[2]", "(0.2", set(square, view_of(dented)), HS_ERROR_GEOMETRY},
                  {"vertices.y", "NULL", set(square, {&few[0].x, nullptr, nullptr, 16, 4})},
                  {"face", "plane", set(solid, view_of(skew)), HS_ERROR_GEOMETRY},
                  {"face", "vertices[", set(solid, view_of(mirrored)), HS_ERROR_GEOMETRY},
                  {"vertices", "8 points", set(solid, view_of(flat)), HS_ERROR_GEOMETRY},
                  {"vertices[2]", "inf", set(solid, view_of(infinite)), HS_ERROR_GEOMETRY}});
  CHECK(hs_shape_set_vertices(nullptr, view_of(few)) == HS_ERROR_ARGUMENT);
  check_same(square.get(), twin.get());
  check_same(solid.get(), twin_solid.get());
}

}  // namespace halfspace_test
