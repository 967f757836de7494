// halfspace/query.h against results of geometry: rays, closest points, and pairs of boxes.

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "capi/refusals.h"
#include "capi/snapshot_worlds.h"
#include "catch.h"

namespace halfspace_test {
namespace {

constexpr double right[3] = {1, 0, 0}, down[3] = {0, -1, 0};

hs_ray_hit cast(const Shape& shape, const hs_pose& pose, const Point3& origin, const Point3& direction,
                double length = 100) {
  const double from[3] = {origin.x, origin.y, origin.z}, along[3] = {direction.x, direction.y, direction.z};
  hs_ray_hit hit;
  if (hs_shape_cast_ray(shape.get(), &pose, from, along, length, &hit) != HS_OK)
    throw std::runtime_error("no ray");
  return hit;
}

hs_ray_hit cast(const World& world, const Point3& origin, const double (&direction)[3], double length = 100) {
  const double from[3] = {origin.x, origin.y, origin.z};
  hs_ray_hit hit;
  if (hs_world_cast_ray(world.get(), from, direction, length, &hit) != HS_OK)
    throw std::runtime_error("no ray");
  return hit;
}

hs_closest_points closest(const Shape& a, const hs_pose& at_a, const Shape& b, const hs_pose& at_b) {
  hs_closest_points points;
  if (hs_pair_distance(a.get(), &at_a, b.get(), &at_b, &points) != HS_OK)
    throw std::runtime_error("no distance");
  return points;
}

void check_vector(const double (&found)[3], double x, double y, double z, double margin = 1e-15) {
  CHECK(found[0] == Approx(x).margin(margin));
  CHECK(found[1] == Approx(y).margin(margin));
  CHECK(found[2] == Approx(z).margin(margin));
}

void check_miss(const hs_ray_hit& hit) {
  CHECK(hit.is_hit == 0);
  CHECK(hit.face == -1);
  CHECK(hit.distance == 0);
}

}  // namespace

TEST_CASE("a ray meets the face of a box that it enters through") {
  const Context context = make_context();
  const int dimension = GENERATE(2, 3);
  const Shape box = shape_of_box(context.get(), dimension);  // half a unit wide
  const hs_pose at = pose_at(3, 1);
  const hs_ray_hit hit = cast(box, at, {0, 1.125, 0.125}, {2, 0, 0});
  CHECK(hit.is_hit == 1);
  CHECK(hit.block == 0);
  CHECK(hit.distance == 2.75);
  check_vector(hit.point, 2.75, 1.125, dimension == 2 ? 0 : 0.125);
  check_vector(hit.normal, -1, 0, 0);
  CHECK(hit.face == (dimension == 2 ? 3 : 4));  // the last edge goes down at the left

  check_miss(cast(box, at, {0, 1.125, 0}, {-2, 0, 0}));        // away
  check_miss(cast(box, at, {0, 1.26, 0}, {1, 0, 0}));          // above
  check_miss(cast(box, at, {0, 1.125, 0}, {1, 0, 0}, 2.749));  // too short
  CHECK(cast(box, at, {0, 1.125, 0}, {1, 0, 0}, 2.751).is_hit == 1);
  // Along the upper side: it touches.
  CHECK(cast(box, at, {0, 1.25, 0}, {1, 0, 0}).distance == 2.75);
}

TEST_CASE("a ray that starts inside a shape ends there") {
  const Context context = make_context();
  const Shape box = shape_of_box(context.get(), GENERATE(2, 3));
  const hs_ray_hit hit = cast(box, pose_at(3, 1), {3.1, 0.9, 0}, {1, 2, 0});
  CHECK(hit.is_hit == 1);
  CHECK(hit.face == -1);
  CHECK(hit.distance == 0);
  check_vector(hit.point, 3.1, 0.9, 0);
  check_vector(hit.normal, 0, 0, 0);
}

TEST_CASE("a ray meets a square on its corner where geometry says") {
  const Context context = make_context();
  const Shape square = make_shape(context.get(), box(-0.5, -0.5, 0.5, 0.5));
  const double eighth = std::acos(-1) / 8;  // half of the angle of 45 degrees
  const hs_pose at = pose_at(2, 0, std::sin(eighth), std::cos(eighth));
  // Its outline is |x - 2| + |y| = sqrt(1/2).
  const hs_ray_hit hit = cast(square, at, {0, 0.1, 0}, {1, 0, 0});
  CHECK(hit.distance == Approx(2 - (std::sqrt(0.5) - 0.1)).epsilon(1e-15));
  check_vector(hit.normal, -std::sqrt(0.5), std::sqrt(0.5), 0);
}

TEST_CASE("no ray passes between boxes with a common side") {
  const Context context = make_context();
  const Shape square = make_shape(context.get(), box(-0.15, -0.15, 0.15, 0.15));
  const double joint = 0.1 + 0.3;  // not a double, and neither are the sides
  const hs_pose left = pose_at(joint - 0.15, 0), right_of_it = pose_at(joint + 0.15, 0);
  for (int i = 0; i <= 100; ++i) {
    const double angle = (i - 50) * 0.02, distance = 1;
    const Point3 from{joint + distance * std::sin(angle), 0.15 + distance * std::cos(angle), 0};
    const Point3 along{-std::sin(angle), -std::cos(angle), 0};
    const hs_ray_hit a = cast(square, left, from, along), b = cast(square, right_of_it, from, along);
    CHECK((a.is_hit || b.is_hit));
  }
}

TEST_CASE("a ray into a world meets the nearest block of any kind") {
  const Context context = make_context();
  const int dimension = GENERATE(2, 3);
  const World world = make_world(context.get(), world_def(dimension));
  std::int32_t material = -1;
  require_ok(hs_world_add_material(world.get(), 1000, &material), context.get());
  const hs_elasticity_def elasticity = elasticity_def(1e9);
  require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context.get());
  const Shape box = shape_of_box(context.get(), dimension);
  check_miss(cast(world, {0, 0, 0}, right));

  const hs_block far = add_block(context.get(), world.get(), box, HS_BLOCK_FIXED, pose_at(9, 0));
  CHECK(cast(world, {0, 0, 0}, right).block == far);
  const hs_block near = add_block(context.get(), world.get(), box, HS_BLOCK_RIGID, pose_at(5, 0));
  hs_ray_hit hit = cast(world, {0, 0, 0}, right);
  CHECK(hit.block == near);
  CHECK(hit.distance == 4.75);
  check_vector(hit.normal, -1, 0, 0);

  // Stretched to four times its width, an affine block is met far outside its first bounding sphere.
  const hs_block affine = add_block(context.get(), world.get(), box, HS_BLOCK_AFFINE, pose_at(7, 20));
  const double stretched[9] = {4, 0, 0, 0, 1, 0, 0, 0, 1}, still[9] = {};
  require_ok(hs_world_set_deformation(world.get(), affine, stretched, still), context.get());
  hit = cast(world, {0, 20, 0}, right);
  CHECK(hit.block == affine);
  CHECK(hit.distance == Approx(7 - 4 * 0.25).epsilon(1e-15));

  // A compound is met at its parts.
  const hs_shape* const shapes[2] = {box.get(), box.get()};
  const hs_pose poses[2] = {pose_at(5, 30), pose_at(5.5, 30)};
  hs_block_def def;
  require_ok(hs_compound_def_init(&def, sizeof def, shapes, poses, 2), context.get());
  hs_block compound = 0, parts[2];
  require_ok(hs_world_add_compound(world.get(), shapes, poses, 2, &def, &compound), context.get());
  require_ok(hs_world_get_compound_parts(world.get(), compound, parts, 2, nullptr), context.get());
  hit = cast(world, {9, 30, 0}, {-1, 0, 0});
  CHECK(hit.block == parts[1]);
  CHECK(hit.distance == Approx(9 - 5.75).epsilon(1e-15));

  // A mesh is met at a cell of its surface.
  add_body(context.get(), world.get(), bar(dimension), body_def(pose_at(2, 40)));
  hit = cast(world, {2.5, 50, 0.5}, down);
  CHECK(hit.distance == Approx(50 - 41).epsilon(1e-14));
  check_vector(hit.normal, 0, 1, 0);
  CHECK(hit.block != 0);
}

TEST_CASE("closest points of boxes are those of geometry") {
  const Context context = make_context();
  const int dimension = GENERATE(2, 3);
  const Shape box = shape_of_box(context.get(), dimension);
  SECTION("faces that are opposite") {
    const hs_closest_points points = closest(box, pose_at(0, 0), box, pose_at(2, 0.125));
    CHECK(points.distance == 1.5);
    check_vector(points.normal, 1, 0, 0);
    CHECK(points.point_a[0] == 0.25);
    CHECK(points.point_b[0] == 1.75);
    CHECK(points.point_a[1] == points.point_b[1]);
  }
  SECTION("corners") {
    const hs_closest_points points = closest(box, pose_at(0, 0), box, pose_at(3.5, 4.5));
    CHECK(points.distance == 5);  // 3 and 4
    check_vector(points.normal, 0.6, 0.8, 0);
    CHECK(points.point_a[0] == 0.25);
    CHECK(points.point_a[1] == 0.25);
    CHECK(points.point_b[0] == 3.25);
    CHECK(points.point_b[1] == 4.25);
  }
  SECTION("faces that touch") {
    const hs_closest_points points = closest(box, pose_at(0, 0), box, pose_at(0.125, 0.5));
    CHECK(points.distance == 0);
    check_vector(points.normal, 0, 0, 0);
    CHECK(points.point_a[1] == 0.25);
    CHECK(points.point_b[1] == 0.25);
  }
  SECTION("an overlap has a common point") {
    const hs_closest_points points = closest(box, pose_at(7, 0), box, pose_at(7.25, 0.125));
    CHECK(points.distance == 0);
    for (int i = 0; i < 3; ++i) CHECK(points.point_a[i] == Approx(points.point_b[i]).margin(1e-15));
    CHECK(points.point_a[0] == Approx(7.125).margin(0.125));
    CHECK(points.point_a[1] == Approx(0.0625).margin(0.1875));
  }
  SECTION("one place") { CHECK(closest(box, pose_at(7, 0), box, pose_at(7, 0)).distance == 0); }
  SECTION("a far place costs accuracy of the places only") {
    const hs_closest_points points = closest(box, pose_at(1e6, 0), box, pose_at(1e6 + 3.5, 4.5));
    CHECK(points.distance == 5);
    check_vector(points.normal, 0.6, 0.8, 0);
  }
}

TEST_CASE("closest points of crossing edges are on these edges") {
  const Context context = make_context();
  const Shape cube_shape = make_polyhedron(context.get(), cube());
  const double eighth = std::acos(-1) / 4;
  // One cube on an edge along y, the other above it on an edge along x.
  const hs_pose below = pose_at(Point3{0, 0, 0}, {0, 1, 0}, eighth);
  const hs_pose above = pose_at(Point3{0.125, 0.25, 3}, {1, 0, 0}, eighth);
  const hs_closest_points points = closest(cube_shape, below, cube_shape, above);
  CHECK(points.distance == Approx(3 - std::sqrt(2)).epsilon(1e-15));
  check_vector(points.normal, 0, 0, 1);
  check_vector(points.point_a, 0, 0.25 - 0.25 + points.point_a[1], std::sqrt(0.5));
  CHECK(points.point_a[0] == Approx(points.point_b[0]).margin(1e-15));
  CHECK(points.point_a[1] == Approx(points.point_b[1]).margin(1e-15));
}

TEST_CASE("pairs of boxes are those of all combinations") {
  const Context context = make_context();
  const int dimension = GENERATE(2, 3);
  Random random(11);
  Points3 lower, upper;
  for (int i = 0; i < 300; ++i) {
    const double size = std::pow(10, uniform_between(random, -4, 0.5));
    const Point3 low{uniform_between(random, -3, 3), uniform_between(random, -3, 3),
                     uniform_between(random, -1, 1)};
    lower.push_back(low);
    upper.push_back({low.x + size, low.y + size * uniform_between(random, 0, 2), low.z + size});
  }
  lower.push_back(upper[0]);  // touches box 0 at its corner, and has no extent
  upper.push_back(upper[0]);
  std::vector<std::pair<std::int32_t, std::int32_t>> expected;
  for (std::int32_t a = 0; a < 301; ++a) {
    for (std::int32_t b = a + 1; b < 301; ++b) {
      const std::size_t i = std::size_t(a), j = std::size_t(b);
      const bool in_z = dimension == 2 || (lower[i].z <= upper[j].z && lower[j].z <= upper[i].z);
      if (in_z && lower[i].x <= upper[j].x && lower[j].x <= upper[i].x && lower[i].y <= upper[j].y &&
          lower[j].y <= upper[i].y)
        expected.emplace_back(a, b);
    }
  }
  std::int64_t count = -1;
  REQUIRE(hs_boxes_find_pairs(context.get(), dimension, view_of(lower), view_of(upper), nullptr, 0, &count) ==
          HS_NOTE_TRUNCATED);
  REQUIRE(count == std::int64_t(expected.size()));
  std::vector<std::int32_t> pairs(2 * expected.size());
  require_ok(hs_boxes_find_pairs(context.get(), dimension, view_of(lower), view_of(upper), pairs.data(),
                                 count, nullptr),
             context.get());
  std::vector<std::pair<std::int32_t, std::int32_t>> found;
  for (std::size_t i = 0; i < expected.size(); ++i) found.emplace_back(pairs[2 * i], pairs[2 * i + 1]);
  std::sort(found.begin(), found.end());
  CHECK(found == expected);

  // Too little room: the first ones.
  std::int32_t first[4] = {-1, -1, -1, -1};
  CHECK(hs_boxes_find_pairs(context.get(), dimension, view_of(lower), view_of(upper), first, 1, &count) ==
        HS_NOTE_TRUNCATED);
  CHECK(first[0] == pairs[0]);
  CHECK(first[1] == pairs[1]);
  CHECK(first[2] == -1);
  CHECK(hs_boxes_find_pairs(context.get(), dimension, {}, {}, nullptr, 0, &count) == HS_OK);
  CHECK(count == 0);
}

TEST_CASE("along the curve each point of a full grid is followed by a neighbour") {
  const Context context = make_context();
  std::mt19937 random(3);
  for (const std::int32_t dimension : {2, 3}) {
    const int n = dimension == 2 ? 32 : 16;
    Points3 points;
    for (int i = 0; i < n * n * (dimension == 2 ? 1 : n); ++i)
      points.push_back({7.5 + 0.1 * (i % n), -3 + 0.1 * (i / n % n), 0.1 * (i / (n * n))});
    std::shuffle(points.begin(), points.end(), random);
    std::vector<std::int32_t> order(points.size());
    require_ok(hs_points_order_along_curve(context.get(), dimension, view_of(points), order.data()),
               context.get());
    int steps = 0;
    for (std::size_t i = 1; i < order.size(); ++i) {
      const Point3 &p = points.at(std::size_t(order[i - 1])), &q = points.at(std::size_t(order[i]));
      steps += std::abs(std::hypot(p.x - q.x, p.y - q.y, p.z - q.z) - 0.1) < 1e-9;
    }
    CHECK(steps == int(points.size()) - 1);
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i) REQUIRE(order[i] == std::int32_t(i));
  }
}

TEST_CASE("points in one place keep their order, and no point has none") {
  const Context context = make_context();
  const Points3 same(5, {1e9, -2, 3}), line{{4, 0, 0}, {0, 0, 0}, {4, 0, 0}, {1e-300, 0, 0}};
  std::int32_t order[5] = {-1, -1, -1, -1, -1};
  require_ok(hs_points_order_along_curve(context.get(), 3, view_of(same), order), context.get());
  for (std::int32_t i = 0; i < 5; ++i) CHECK(order[i] == i);
  require_ok(hs_points_order_along_curve(context.get(), 2, view_of(line), order), context.get());
  const std::vector<std::int32_t> expected{1, 3, 0, 2};
  CHECK(std::equal(expected.begin(), expected.end(), order));
  CHECK(hs_points_order_along_curve(context.get(), 2, {}, nullptr) == HS_OK);
}

TEST_CASE("queries refuse what they cannot read, by name and value") {
  const Context context = make_context();
  hs_context* c = context.get();
  const Shape square = shape_of_box(c, 2), solid = shape_of_box(c, 3);
  const hs_pose pose = pose_at(0, 0), turned_off{{0, 0, 0}, {0, 0, 0, 2}};
  const double origin[3] = {}, nan[3] = {0, NAN, 0};
  hs_ray_hit hit{7, 7, 7, 7, {}, {}};
  const auto ray = [&](const hs_shape* shape, const hs_pose* at, const double* from, const double* along,
                       double length,
                       hs_ray_hit* out) { return hs_shape_cast_ray(shape, at, from, along, length, out); };
  const hs_shape* s = square.get();
  check_refusals(c, "hs_shape_cast_ray",
                 {{"pose", "NULL", [&] { return ray(s, nullptr, origin, right, 1, &hit); }},
                  {"pose", "2", [&] { return ray(s, &turned_off, origin, right, 1, &hit); }},
                  {"origin", "NULL", [&] { return ray(s, &pose, nullptr, right, 1, &hit); }},
                  {"origin", "nan", [&] { return ray(s, &pose, nan, right, 1, &hit); }},
                  {"direction", "NULL", [&] { return ray(s, &pose, origin, nullptr, 1, &hit); }},
                  {"direction", "(0, 0)", [&] { return ray(s, &pose, origin, origin, 1, &hit); }},
                  {"max_distance", "-1", [&] { return ray(s, &pose, origin, right, -1, &hit); }},
                  {"max_distance", "inf", [&] { return ray(s, &pose, origin, right, HUGE_VAL, &hit); }},
                  {"hit", "NULL", [&] { return ray(s, &pose, origin, right, 1, nullptr); }}});
  CHECK(hs_shape_cast_ray(nullptr, &pose, origin, right, 1, &hit) == HS_ERROR_ARGUMENT);

  const World world = make_world(c, world_def(3));
  check_refusals(
      c, "hs_world_cast_ray",
      {{"origin", "nan", [&] { return hs_world_cast_ray(world.get(), nan, right, 1, &hit); }},
       {"direction", "(0, 0, 0)", [&] { return hs_world_cast_ray(world.get(), origin, origin, 1, &hit); }},
       {"max_distance", "nan", [&] { return hs_world_cast_ray(world.get(), origin, right, NAN, &hit); }},
       {"hit", "NULL", [&] { return hs_world_cast_ray(world.get(), origin, right, 1, nullptr); }}});
  CHECK(hs_world_cast_ray(nullptr, origin, right, 1, &hit) == HS_ERROR_ARGUMENT);
  CHECK(hit.is_hit == 7);  // untouched

  hs_closest_points points{7, {}, {}, {}};
  const hs_shape* d = solid.get();
  check_refusals(c, "hs_pair_distance",
                 {{"shape_b", "NULL", [&] { return hs_pair_distance(s, &pose, nullptr, &pose, &points); }},
                  {"shape_a", "NULL", [&] { return hs_pair_distance(nullptr, &pose, s, &pose, &points); }},
                  {"pose_a", "NULL", [&] { return hs_pair_distance(s, nullptr, s, &pose, &points); }},
                  {"pose_b", "2", [&] { return hs_pair_distance(s, &pose, s, &turned_off, &points); }},
                  {"shape_b", "3", [&] { return hs_pair_distance(s, &pose, d, &pose, &points); }},
                  {"points", "NULL", [&] { return hs_pair_distance(s, &pose, s, &pose, nullptr); }}});
  CHECK(points.distance == 7);

  const Points3 low{{0, 0, 0}, {1, 1, 1}}, high{{1, 1, 1}, {2, 0, 2}}, invalid{{0, 0, 0}, {NAN, 1, 1}};
  const hs_view l = view_of(low), h = view_of(high);
  std::int64_t count = 7;
  const auto find = [&](std::int32_t dimension, hs_view from, hs_view to, std::int64_t capacity) {
    return hs_boxes_find_pairs(c, dimension, from, to, nullptr, capacity, &count);
  };
  const hs_view none{};
  check_refusals(c, "hs_boxes_find_pairs",
                 {{"dimension", "4", [&] { return find(4, l, l, 0); }},
                  {"upper.count", "0", [&] { return find(2, l, none, 0); }},
                  {"capacity", "-1", [&] { return find(2, l, l, -1); }},
                  {"pairs", "NULL", [&] { return find(2, l, l, 1); }},
                  {"lower[1]", "(1, 1)", [&] { return find(2, l, h, 0); }},
                  {"lower[1]", "nan", [&] { return find(3, view_of(invalid), l, 0); }}});
  CHECK(count == 7);
  CHECK(hs_boxes_find_pairs(nullptr, 2, l, l, nullptr, 0, &count) == HS_ERROR_ARGUMENT);

  std::int32_t order[2] = {7, 7};
  const auto put_in_order = [&](std::int32_t dimension, hs_view points, std::int32_t* out) {
    return hs_points_order_along_curve(c, dimension, points, out);
  };
  check_refusals(c, "hs_points_order_along_curve",
                 {{"dimension", "1", [&] { return put_in_order(1, l, order); }},
                  {"points[1]", "nan", [&] { return put_in_order(3, view_of(invalid), order); }},
                  {"order", "NULL", [&] { return put_in_order(2, l, nullptr); }}});
  CHECK(order[0] == 7);
  CHECK(hs_points_order_along_curve(nullptr, 2, l, order) == HS_ERROR_ARGUMENT);
}

}  // namespace halfspace_test
