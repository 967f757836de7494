// Worlds in space: what differs from those in the plane, and what must not.

#include <cstring>

#include "capi/polyhedra.h"
#include "capi/refusals.h"
#include "capi/world_fixture.h"

namespace halfspace_test {
namespace {

hs_block add_solid(hs_context* context, hs_world* world, const Points3& points, std::int32_t kind,
                   const hs_pose* pose = nullptr) {
  const Shape shape = make_hull(context, points);
  hs_block_def def;
  require_ok(hs_block_def_init(&def, sizeof def, shape.get()), context);
  def.kind = kind;
  if (pose) def.pose = *pose;
  hs_block block = 0;
  require_ok(hs_world_add_block(world, shape.get(), &def, &block), context);
  return block;
}

/// Polyhedra of 4 to 15 vertices, boxes among them, that fall into a box without a lid. All lengths are times
/// `scale`, a power of two, with the times as they are.
struct SolidPile {
  World world;
  std::vector<hs_block> blocks;

  SolidPile(hs_context* context, int count, double scale = 1) {
    hs_world_def def = world_def(3);
    def.gravity[2] *= scale;
    def.time_step = 2e-4;
    world = make_world(context, def);
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), 2500, &material), context);
    hs_law_def law = law_def(2e7 * scale * scale * scale, 0.4);
    law.normal_damping = 0.2;
    require_ok(hs_world_set_default_law(world.get(), &law), context);
    const auto wall = [&](const Point3& low, const Point3& high) {
      blocks.push_back(
          add_solid(context, world.get(), box_corners(scale * low, scale * high), HS_BLOCK_FIXED));
    };
    wall({-2, -2, -1}, {2, 2, 0});
    wall({-2, -2, 0}, {-1.5, 2, 8});
    wall({1.5, -2, 0}, {2, 2, 8});
    wall({-1.5, -2, 0}, {1.5, -1.5, 8});
    wall({-1.5, 1.5, 0}, {1.5, 2, 8});
    Random random(7);
    for (int i = 0; i < count; ++i) {
      const Points3 points = i % 3 == 0 ? box_corners({-0.3, -0.25, -0.4}, {0.3, 0.25, 0.4})
                                        : round_points(random, 4 + i % 12, 0.48);
      Points3 scaled;
      for (const Point3& p : points) scaled.push_back(scale * p);
      const hs_pose pose =
          pose_at(scale * Point3{double((i % 9) % 3 - 1), double((i % 9) / 3 - 1), 0.6 + i / 9},
                  random_direction(random), uniform_between(random, -3, 3));
      blocks.push_back(add_solid(context, world.get(), scaled, HS_BLOCK_RIGID, &pose));
    }
  }
};

constexpr int steps_to_pile_up = 5000;  // 1 s

}  // namespace

TEST_CASE("in space: a restored world goes on bit for bit in the middle of dense contact") {
  const Context context = make_context(), elsewhere = make_context();
  SolidPile pile(context.get(), 27);
  require_ok(hs_world_step(pile.world.get(), steps_to_pile_up), context.get());
  CHECK(report_of(pile.world.get()).contact_count > 20);
  require_ok(hs_world_remove_block(pile.world.get(), pile.blocks[20]), context.get());
  const std::vector<unsigned char> bytes = saved(pile.world.get());
  hs_world* made = nullptr;
  require_ok(hs_world_restore(elsewhere.get(), bytes.data(), bytes.size(), &made), elsewhere.get());
  const World copy(made);
  CHECK((saved(copy.get()) == bytes));
  require_ok(hs_world_step(pile.world.get(), 500), context.get());
  require_ok(hs_world_step(copy.get(), 500), elsewhere.get());
  CHECK((saved(copy.get()) == saved(pile.world.get())));
  const hs_block one =
      add_solid(context.get(), pile.world.get(), box_corners({0, 0, 9}, {1, 1, 10}), HS_BLOCK_RIGID);
  const hs_block other =
      add_solid(elsewhere.get(), copy.get(), box_corners({0, 0, 9}, {1, 1, 10}), HS_BLOCK_RIGID);
  CHECK(one == other);
}

TEST_CASE("in space: a scene of twice the size four times over moves by the same bits") {
  const Context context = make_context();
  SolidPile pile(context.get(), 18), large(context.get(), 18, 16);
  require_ok(hs_world_step(pile.world.get(), steps_to_pile_up), context.get());
  require_ok(hs_world_step(large.world.get(), steps_to_pile_up), context.get());
  const std::vector<hs_pose> small_poses = poses_of(pile.world.get()),
                             large_poses = poses_of(large.world.get());
  REQUIRE(small_poses.size() == large_poses.size());
  for (std::size_t i = 0; i < small_poses.size(); ++i) {
    for (int k = 0; k < 3; ++k) CHECK(16 * small_poses[i].position[k] == large_poses[i].position[k]);
    for (int k = 0; k < 4; ++k) CHECK(small_poses[i].rotation[k] == large_poses[i].rotation[k]);
  }
}

TEST_CASE("in space: forces sum to nothing over a pair, and each is what its contacts say") {
  const Context context = make_context();
  SolidPile pile(context.get(), 27);
  hs_world* w = pile.world.get();
  require_ok(hs_world_step(w, steps_to_pile_up), context.get());
  const std::size_t count = pile.blocks.size();
  Points3 forces(count), torques(count);
  require_ok(hs_world_detect(w, nullptr), context.get());
  require_ok(hs_world_forces(w, 0, mutable_view_of(forces), mutable_view_of(torques)), context.get());
  const std::vector<hs_pose> poses = poses_of(w);
  Points3 of_contacts(count), torques_of_contacts(count);
  double largest = 0;
  const auto index_of = [&](hs_block block) {
    return std::size_t(std::find(pile.blocks.begin(), pile.blocks.end(), block) - pile.blocks.begin());
  };
  for (const hs_contact& c : contacts_of(w)) {
    const Point3 force = vector_of(c.force), normal = vector_of(c.normal), shear = vector_of(c.shear_force);
    largest = std::max(largest, length(force));
    CHECK(length(force - c.normal_force * normal - shear) <= 1e-12 * length(force));
    CHECK(std::abs(dot(shear, normal)) <= 1e-12 * length(force));
    CHECK(length(shear) <= std::tan(0.4) * c.normal_force * (1 + 1e-12) + 1e-300);
    for (const auto& [block, sign] : {std::pair(c.block_a, -1.0), std::pair(c.block_b, 1.0)}) {
      const std::size_t i = index_of(block);
      of_contacts[i] = of_contacts[i] + sign * force;
      const Point3 arm = vector_of(c.force_point) - vector_of(poses[i].position);
      torques_of_contacts[i] = torques_of_contacts[i] + sign * (cross(arm, force) + vector_of(c.torque));
    }
  }
  REQUIRE(largest > 0);
  // Sums of some 20 terms in another order, arms of walls up to 10 m.
  for (std::size_t i = 0; i < count; ++i) {
    CHECK(length(forces[i] - of_contacts[i]) <= 1e-13 * 20 * largest);
    CHECK(length(torques[i] - torques_of_contacts[i]) <= 1e-13 * 200 * largest);
  }
}

TEST_CASE("in space: what the plane does without is asked for") {
  const Context context = make_context();
  hs_context* c = context.get();
  const World world = make_world(c, world_def(3));
  hs_world* w = world.get();
  std::int32_t material = -1;
  require_ok(hs_world_add_material(w, 2500, &material), c);
  const hs_block block = add_solid(c, w, box_corners({0, 0, 0}, {1, 2, 3}), HS_BLOCK_RIGID);
  const Shape square = make_shape(c, box(0, 0, 1, 1));
  hs_block_def def;
  require_ok(hs_block_def_init(&def, sizeof def, square.get()), c);
  hs_block other = 77;
  double x[3] = {1, 2, 3};
  const double nan = std::nan(""), bad[3] = {0, 0, nan}, zero[3] = {0, 0, 0};
  hs_pose off = pose_at(Point3{0, 0, 0});
  off.rotation[0] = 0.1;
  check_refusals(
      c, "hs_world_add_block",
      {{"shape", "dimension 2", [&] { return hs_world_add_block(w, square.get(), &def, &other); }}});
  CHECK(other == 77);
  check_refusals(
      c, "hs_world_set_velocity",
      {{"velocity[2]", "nan", [&] { return hs_world_set_velocity(w, block, bad, zero); }},
       {"angular_velocity[2]", "nan", [&] { return hs_world_set_velocity(w, block, zero, bad); }}});
  check_refusals(c, "hs_world_set_pose",
                 {{"pose->rotation", "0.1", [&] { return hs_world_set_pose(w, block, &off); }}});
  check_refusals(c, "hs_world_get_velocities",
                 {{"velocities.z", "NULL", [&] {
                     return hs_world_get_velocities(w, {x, x, nullptr, 8, 1}, {});
                   }}});

  // Any unit quaternion is a pose, and comes back but for its sign.
  const hs_pose pose = pose_at(Point3{1, 2, 3}, {1, -2, 0.5}, 2.5);
  require_ok(hs_world_set_pose(w, block, &pose), c);
  const hs_pose back = state_of(w, block).pose;
  const double sign = back.rotation[0] * pose.rotation[0] < 0 ? -1 : 1;
  for (int k = 0; k < 4; ++k) CHECK(back.rotation[k] == Approx(sign * pose.rotation[k]).margin(4e-16));
  Points3 vertices(8);
  std::int64_t count = 0;
  require_ok(hs_world_get_block_vertices(w, block, mutable_view_of(vertices), &count), c);
  CHECK(count == 8);
  for (const Point3& v : vertices)
    CHECK(length(v - Point3{1, 2, 3}) == Approx(std::sqrt(1 + 4 + 9) / 2).epsilon(1e-15));
}

}  // namespace halfspace_test
