// A proof of separation that was found with the blocks far apart, put to the test where they overlap.

#include <algorithm>
#include <cmath>

#include "capi/polyhedra.h"
#include "catch.h"

namespace halfspace_test {
namespace {

/// What rounding may do to a gap of blocks that reach no farther than 2 together.
constexpr double rounding = 2 * 48 * 0x1p-53;

struct Turn {
  Point3 axis;
  double angle;
};

/// With each block turned as it is, b far away in random directions and then so near that it overlaps a, by
/// whatever little or much: a cache filled there must not hide it here.
void check_far_proofs(const hs_shape* a, const hs_shape* b, double distance, Random& random, bool in_plane) {
  const auto direction = [&] {
    const Point3 d = random_direction(random);
    return in_plane ? unit({d.x, d.y, 0}) : d;
  };
  const auto turn = [&] {
    return Turn{in_plane ? Point3{0, 0, 1} : random_direction(random), uniform_between(random, -3, 3)};
  };
  const Turn of_a = turn(), of_b = turn();
  const hs_pose at_a = pose_at({0, 0, 0}, of_a.axis, of_a.angle);
  const auto b_at = [&](const Point3& at) { return pose_at(at, of_b.axis, of_b.angle); };
  const Point3 away = direction();
  hs_pair_cache cache{};
  REQUIRE(detect_pair(a, at_a, b, b_at(distance * away), &cache).type == HS_CONTACT_NONE);
  // Along the direction by which it was away and by others; nearer and nearer until it touches.
  const Point3 along = random() % 2 ? away : direction();
  double touching = 0, apart = 2.5;
  for (int halvings = 0; halvings < 45; ++halvings) {
    const double middle = 0.5 * (touching + apart);
    const hs_contact cold = detect_pair(a, at_a, b, b_at(middle * along));
    hs_pair_cache filled = cache;
    const hs_contact warm = detect_pair(a, at_a, b, b_at(middle * along), &filled);
    INFO("filled " << distance << " away, now " << middle << ", gap " << cold.gap);
    if (cold.gap < -rounding) CHECK(warm.type != HS_CONTACT_NONE);
    if (cold.gap > rounding) CHECK(warm.type == HS_CONTACT_NONE);
    (cold.type == HS_CONTACT_NONE ? apart : touching) = middle;
  }
}

}  // namespace

TEST_CASE("a cache filled however far away hides no overlap") {
  const Context context = make_context();
  Random random(17);
  const Shape triangle = make_shape(context.get(), {{-0.7, -0.4}, {0.8, -0.5}, {0.1, 0.6}});
  const Shape square = make_shape(context.get(), box(-0.5, -0.5, 0.5, 0.5));
  const Shape cube_shape = make_polyhedron(context.get(), cube());
  const Shape round = make_hull(context.get(), round_points(random, 40));
  for (double distance = 4; distance < 1e70; distance *= distance < 1e20 ? 8 : 1e7) {
    for (int i = 0; i < 20; ++i) {
      check_far_proofs(triangle.get(), square.get(), distance, random, true);
      check_far_proofs(square.get(), triangle.get(), distance, random, true);
      check_far_proofs(cube_shape.get(), round.get(), distance, random, false);
      check_far_proofs(cube_shape.get(), cube_shape.get(), distance, random, false);
    }
  }
}

}  // namespace halfspace_test
