// Actions of halfspace/action.h beside each other: what ends with a block or a body, what stays, and which
// one replaces which.

#include <limits>

#include "capi/action_world.h"
#include "capi/snapshot_worlds.h"
#include "catch.h"

namespace halfspace_test {
namespace {

/// The table is (3, -2, 1), the density 1000, and the blocks have the size 1.
constexpr double force_x = 3, mass = 1000;

hs_action_def along_x(std::int32_t kind, double factor = 1) {
  hs_action_def def = action_def(kind);
  def.scale[0] = factor;
  def.scale[1] = def.scale[2] = 0;
  return def;
}

/// The index of a block or a body in the world's arrays: its id without the count of those that have had it.
std::int32_t place_of(std::uint64_t id) { return std::int32_t(std::uint32_t(id)) - 1; }

}  // namespace

TEST_CASE("a removed block ends its actions, and no other's") {
  for (const int dimension : {2, 3}) {
    INFO(dimension << "D");
    ActionWorld s(dimension);
    const hs_block other = s.add(HS_BLOCK_RIGID, -3);
    for (const hs_block block : {s.rigid, other, s.affine}) s.act(block, action_def(HS_ACTION_FORCE));
    s.act(s.prescribed, action_def(HS_ACTION_VELOCITY));
    require_ok(hs_world_hold_block(s.world.get(), s.rigid, HS_AXIS_Y), s.context.get());
    s.step(10);
    for (const hs_block block : {s.rigid, s.prescribed})
      require_ok(hs_world_remove_block(s.world.get(), block), s.context.get());
    s.step(10);
    // The places of the removed blocks are taken in the order in which they became free, the last one first.
    const hs_block still = s.add(HS_BLOCK_PRESCRIBED, 2), free = s.add(HS_BLOCK_RIGID, 4);
    CHECK(place_of(still) == place_of(s.prescribed));
    CHECK(place_of(free) == place_of(s.rigid));
    s.step(10);
    for (const hs_block block : {still, free})
      for (int k = 0; k < dimension; ++k) CHECK(s.velocity_of(block, k) == 0);
    for (const hs_block block : {other, s.affine})
      CHECK(s.velocity_of(block) == Approx(force_x / mass * 0.03).epsilon(1e-12));
    // It is not held either.
    s.act(free, action_def(HS_ACTION_FORCE));
    s.step(10);
    CHECK(s.velocity_of(free, 1) == Approx(-2 / mass * 0.01).epsilon(1e-12));
  }
}

TEST_CASE("a removed body ends its actions, and those of other bodies stay with their nodes") {
  for (const int dimension : {2, 3}) {
    INFO(dimension << "D");
    ActionWorld s(dimension);
    const std::vector<hs_body> bodies = {s.body, s.add_bar(4), s.add_bar(8), s.add_bar(12)};
    const hs_action_def force = action_def(HS_ACTION_FORCE);
    for (std::size_t i = 0; i < 3; ++i) {
      const double factor = double(i + 1);
      s.act_on_nodes(bodies[i], {0, 4}, Points3(2, {factor, 0, 0}), force);
      s.act_on_nodes(bodies[i], {1, 2, 3}, Points3(3, {0, factor, 0}), force);
    }
    const std::vector<std::int32_t> ends = {0, 3};
    const double still[3] = {};
    require_ok(hs_world_hold_nodes(s.world.get(), bodies[3], ends.data(), 2, HS_AXIS_X, still),
               s.context.get());
    s.act_on_nodes(bodies[3], ends, Points3(2, {1, 1, 1}), action_def(HS_ACTION_VELOCITY));
    s.step(10);
    require_ok(hs_world_remove_body(s.world.get(), bodies[1]), s.context.get());
    s.step(10);
    const hs_body later = s.add_bar(4);
    s.step(10);
    const auto check_momentum = [&](hs_body body, double factor) {
      const hs_body_state state = state_of_body(s.world.get(), body);
      CHECK(state.momentum[0] == Approx(2 * 3 * factor * 0.03).epsilon(1e-10).margin(1e-12));
      CHECK(state.momentum[1] == Approx(3 * -2 * factor * 0.03).epsilon(1e-10).margin(1e-12));
    };
    check_momentum(bodies[0], 1);
    check_momentum(bodies[2], 3);
    check_momentum(later, 0);
    const Points3 velocities = of_nodes(hs_world_get_node_velocities, s.world.get(), bodies[3]);
    for (const std::int32_t node : ends) CHECK(velocities[std::size_t(node)].x == force_x);

    require_ok(hs_world_end_node_actions(s.world.get(), bodies[0]), s.context.get());
    s.step(10);
    check_momentum(bodies[0], 1);
    CHECK(state_of_body(s.world.get(), bodies[2]).momentum[0] == Approx(2 * 9 * 0.04).epsilon(1e-10));
  }
}

TEST_CASE("nodes that have lost their cells bear no load") {
  ActionWorld s(2);
  s.act_on_nodes(s.body, {0, 2}, Points3(2, {1, 0, 0}), action_def(HS_ACTION_FORCE));
  const std::int32_t cell = 1;  // the only one of node 2
  Points3 released(6);
  require_ok(hs_world_remove_cells(s.world.get(), s.body, &cell, 1, mutable_view_of(released)),
             s.context.get());
  s.step(10);
  CHECK(state_of_body(s.world.get(), s.body).momentum[0] == Approx(force_x * 0.01).epsilon(1e-10));
}

TEST_CASE("loads add up, and motions of axes and of rotations are apart") {
  ActionWorld s(2);
  for (const double factor : {1.0, 2.0}) s.act(s.rigid, along_x(HS_ACTION_FORCE, factor));
  s.act(s.prescribed, action_def(HS_ACTION_VELOCITY));
  s.act(s.prescribed, action_def(HS_ACTION_ANGULAR_VELOCITY));
  s.act(s.prescribed, along_x(HS_ACTION_ACCELERATION, 2));
  s.step(10);
  CHECK(s.velocity_of(s.rigid) == Approx(3 * force_x / mass * 0.01).epsilon(1e-12));
  CHECK(s.velocity_of(s.prescribed) == Approx(2 * force_x * 0.01).epsilon(1e-12));
  CHECK(s.velocity_of(s.prescribed, 1) == -2);  // by the first motion, along the other axis
  CHECK(state_of(s.world.get(), s.prescribed).angular_velocity[2] == 1);
}

TEST_CASE("motions along different axes act together, and a motion ends those along its own") {
  ActionWorld s(2);
  const auto along = [](std::int32_t kind, double x, double y) {
    hs_action_def def = action_def(kind);
    def.scale[0] = x;
    def.scale[1] = y;
    def.max_speed = 2;
    return def;
  };
  const auto velocity = [&](int axis) { return s.velocity_of(s.prescribed, axis); };
  s.act(s.prescribed, along(HS_ACTION_VELOCITY, 1, 0));
  s.act(s.prescribed, along(HS_ACTION_SERVO, 0, 1));
  s.step();
  CHECK(velocity(0) == force_x);
  CHECK(velocity(1) == -2);  // the max speed, without contacts, towards the force of the table
  SECTION("the order does not count") {
    ActionWorld other(2);
    other.act(other.prescribed, along(HS_ACTION_SERVO, 0, 1));
    other.act(other.prescribed, along(HS_ACTION_VELOCITY, 1, 0));
    other.step();
    for (const int axis : {0, 1}) CHECK(other.velocity_of(other.prescribed, axis) == velocity(axis));
  }
  SECTION("one along x leaves the servo along y") {
    s.act(s.prescribed, along(HS_ACTION_VELOCITY, 3, 0));
    s.step();
    CHECK(velocity(0) == 3 * force_x);
    CHECK(velocity(1) == -2);
  }
  SECTION("one along both axes ends both") {
    s.act(s.prescribed, along(HS_ACTION_VELOCITY, 2, 2));
    s.step();
    CHECK(velocity(0) == 2 * force_x);
    CHECK(velocity(1) == -4);
  }
  SECTION("an oblique servo ends as a whole") {
    s.act(s.prescribed, along(HS_ACTION_SERVO, 1, 1));
    s.step();
    CHECK(velocity(0) + velocity(1) == Approx(2 * std::sqrt(2.0)));
    s.act(s.prescribed, along(HS_ACTION_VELOCITY, 1, 0));
    const double before = velocity(1);
    s.step();
    CHECK(velocity(0) == force_x);
    CHECK(velocity(1) == before);
  }
  SECTION("two servos keep velocities of their own") {
    s.act(s.prescribed, along(HS_ACTION_SERVO, 1, 0));
    s.step(3);
    CHECK(velocity(0) == 2);
    CHECK(velocity(1) == -2);
  }
}

TEST_CASE("the acceleration of all blocks and the actions on blocks end by themselves") {
  ActionWorld s(2);
  s.act(0, action_def(HS_ACTION_ACCELERATION));
  s.act(s.rigid, action_def(HS_ACTION_FORCE));
  s.step(10);
  const double of_all = force_x * 0.01, of_force = force_x / mass * 0.01;
  CHECK(s.velocity_of(s.affine) == Approx(of_all).epsilon(1e-12));
  CHECK(s.velocity_of(s.rigid) == Approx(of_all + of_force).epsilon(1e-12));
  CHECK(s.velocity_of(s.prescribed) == 0);
  CHECK(state_of_body(s.world.get(), s.body).momentum[0] ==
        Approx(of_all * state_of_body(s.world.get(), s.body).mass).epsilon(1e-10));
  require_ok(hs_world_end_actions(s.world.get(), s.rigid), s.context.get());
  s.step(10);
  CHECK(s.velocity_of(s.rigid) == Approx(2 * of_all + of_force).epsilon(1e-12));
  s.act(s.rigid, action_def(HS_ACTION_FORCE));
  require_ok(hs_world_end_actions(s.world.get(), 0), s.context.get());
  s.step(10);
  CHECK(s.velocity_of(s.rigid) == Approx(2 * of_all + 2 * of_force).epsilon(1e-12));
  CHECK(s.velocity_of(s.affine) == Approx(2 * of_all).epsilon(1e-12));
}

TEST_CASE("a motion along held axes rests while they are free") {
  for (const std::int32_t kind : {HS_ACTION_VELOCITY, HS_ACTION_ACCELERATION, HS_ACTION_SERVO}) {
    INFO("kind " << kind);
    ActionWorld s(2);
    hs_action_def def = along_x(kind);
    def.max_speed = 2;  // at which a servo without contacts moves
    require_ok(hs_world_hold_block(s.world.get(), s.rigid, HS_AXIS_X), s.context.get());
    s.act(s.rigid, def);
    s.step();
    const double moving = s.velocity_of(s.rigid);
    CHECK(moving > 0);
    require_ok(hs_world_hold_block(s.world.get(), s.rigid, 0), s.context.get());
    s.act(s.rigid, along_x(HS_ACTION_FORCE, 100));
    s.step();
    CHECK(s.velocity_of(s.rigid) == Approx(moving + 100 * force_x / mass * 1e-3).epsilon(1e-12));
    require_ok(hs_world_hold_block(s.world.get(), s.rigid, HS_AXIS_X), s.context.get());
    s.step();
    CHECK(s.velocity_of(s.rigid) != Approx(moving + 200 * force_x / mass * 1e-3).epsilon(1e-6));
  }
}

TEST_CASE("a block that is prescribed between steps keeps its velocity unless it follows a table") {
  ActionWorld s(2);
  const hs_block follower = s.add(HS_BLOCK_PRESCRIBED, -3);
  s.act(follower, along_x(HS_ACTION_VELOCITY));
  const hs_block both[] = {s.prescribed, follower};
  const Points3 velocities(2, {5, 7, 0});
  require_ok(hs_world_prescribe_velocities(s.world.get(), both, view_of(velocities), {}), s.context.get());
  s.step(3);
  CHECK(s.velocity_of(s.prescribed) == 5);
  CHECK(s.velocity_of(follower) == force_x);
  for (const hs_block block : both) CHECK(s.velocity_of(block, 1) == 7);
}

namespace {

/// The place of the only number of this value in a snapshot.
std::size_t place_in(const std::vector<unsigned char>& bytes, double value) {
  std::vector<std::size_t> places;
  for (std::size_t i = snapshot_header; i + sizeof value <= bytes.size(); ++i)
    if (at<double>(bytes, i) == value) places.push_back(i);
  REQUIRE(places.size() == 1);
  return places[0];
}

/// A snapshot, and the refusal of copies with one number changed.
struct Damaged {
  explicit Damaged(const ActionWorld& scene) : good(saved(scene.world.get())) {}

  template <class T>
  void check_refused(std::size_t place, T value, const char* name) const {
    std::vector<unsigned char> bytes = good;
    put(bytes, place, value);
    mend_header(bytes);
    const Context context = make_context();
    hs_world* world = nullptr;
    INFO(name << " = " << value);
    CHECK(hs_world_restore(context.get(), bytes.data(), bytes.size(), &world) == HS_ERROR_FORMAT);
    CHECK(world == nullptr);
    hs_world_destroy(world);
  }

  std::vector<unsigned char> good;
};

}  // namespace

TEST_CASE("a snapshot with damaged tables or actions is refused") {
  for (const int dimension : {2, 3}) {
    INFO(dimension << "D");
    constexpr double first_time = 0.0123, first_value = 45.678, start = 1234.5, start_on_nodes = 4321.5;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    ActionWorld s(dimension);
    s.add_table({first_time, 2, 2, 5}, {{first_value, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
    hs_action_def def = action_def(HS_ACTION_FORCE);
    def.place = HS_PLACE_CARRIED;
    def.start = start;
    s.act(s.rigid, def);
    def.start = start_on_nodes;
    s.act_on_nodes(s.body, {0, 3}, Points3(2, {1, 2, 3}), def);
    s.step(2);
    const Damaged damaged(s);
    REQUIRE(restored(s.context.get(), damaged.good));

    const std::size_t times = place_in(damaged.good, first_time);
    damaged.check_refused(times, nan, "a time");
    damaged.check_refused(times, 3.0, "a time after the next");
    damaged.check_refused(times, 2.0, "a third equal time");
    damaged.check_refused(place_in(damaged.good, first_value), nan, "a value");

    const std::size_t action = place_in(damaged.good, start) - 4 * sizeof(std::int32_t);
    for (const hs_block block : {s.fixed, s.gone})
      damaged.check_refused(action, place_of(block), "the slot of a block that cannot follow");
    for (const std::int32_t slot : {-2, 1 << 20}) damaged.check_refused(action, slot, "a slot");
    for (const std::int32_t kind : {-1, 99}) damaged.check_refused(action + 4, kind, "a kind");
    for (const std::int32_t table : {-1, 2}) damaged.check_refused(action + 8, table, "a table");
    for (const std::int32_t place : {-1, 3}) damaged.check_refused(action + 12, place, "a place");
    damaged.check_refused(action + 16, nan, "a start");
    damaged.check_refused(action + 24, -1.0, "a largest speed");
    for (std::size_t k = 0; k < 3; ++k) {
      damaged.check_refused(action + 32 + 8 * k, nan, "a scale");
      damaged.check_refused(action + 56 + 8 * k, nan, "a point");
    }

    const std::size_t on_nodes = place_in(damaged.good, start_on_nodes) - 4 * sizeof(std::int32_t);
    for (const std::int32_t body : {-1, 1 << 20}) damaged.check_refused(on_nodes, body, "a body");
    damaged.check_refused(on_nodes, place_of(s.gone_body), "a body that is gone");
    for (const int kind : {-1, int(HS_ACTION_ANGULAR_VELOCITY), int(HS_ACTION_TORQUE), int(HS_ACTION_SERVO)})
      damaged.check_refused(on_nodes + 4, kind, "a kind of nodes");
    for (const std::int32_t table : {-1, 2}) damaged.check_refused(on_nodes + 8, table, "a table of nodes");
    damaged.check_refused(on_nodes + 16, nan, "a start of nodes");
    for (const std::int64_t end : {std::int64_t(-1), std::int64_t(1), std::int64_t(3), std::int64_t(1) << 40})
      damaged.check_refused(on_nodes + 24, end, "an end");
    // Behind the action are the count of nodes, and the nodes.
    for (const std::int32_t node : {-1, 1 << 20}) damaged.check_refused(on_nodes + 40, node, "a node");
  }
}

}  // namespace halfspace_test
