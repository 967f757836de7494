// Steps that cannot be made, or not in a bounded time: they end, and name the blocks.

#include "capi/meshes.h"
#include "capi/refusals.h"
#include "catch.h"

using namespace halfspace_test;

namespace {

std::string hexadecimal_of(hs_block block) {
  char text[32];
  std::snprintf(text, sizeof text, "%#llx", static_cast<unsigned long long>(block));
  return text;
}

hs_law_def hard_law() {
  hs_law_def law = law_def(1, 0.5);
  law.stiffness_kind = HS_STIFFNESS_NONE;
  return law;
}

/// A tower of boxes on a fixed floor under a prescribed plate, without springs.
struct Press {
  Context context;
  World world;
  hs_block floor = 0, plate = 0;
  std::vector<hs_block> boxes;

  Press(int dimension, int count, double gap, double speed, const hs_context_def* of_context = nullptr)
      : context(make_context(of_context)) {
    hs_world_def def = world_def(dimension);
    def.time_step = 0.01;
    world = make_world(context.get(), def);
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), 2000, &material), context.get());
    const hs_law_def law = hard_law();
    require_ok(hs_world_set_default_law(world.get(), &law), context.get());
    const Shape wide = dimension == 2 ? make_shape(context.get(), box(-3, -0.5, 3, 0.5))
                                      : make_polyhedron(context.get(), cube(6));
    const double half = dimension == 2 ? 0.5 : 3;
    const Shape cube_of_1 = dimension == 2 ? make_shape(context.get(), box(-0.5, -0.5, 0.5, 0.5))
                                           : make_polyhedron(context.get(), cube(1));
    const auto add = [&](const Shape& shape, std::int32_t kind, double height) {
      hs_pose pose = pose_at(0, 0);
      pose.position[dimension - 1] = height;
      return add_block(context.get(), world.get(), shape, kind, pose);
    };
    floor = add(wide, HS_BLOCK_FIXED, -half);
    for (int i = 0; i < count; ++i) boxes.push_back(add(cube_of_1, HS_BLOCK_RIGID, 0.5 + i));
    plate = add(wide, HS_BLOCK_PRESCRIBED, count + gap + half);
    double velocity[3] = {0, 0, 0};
    const double still[3] = {0, 0, 0};
    velocity[dimension - 1] = speed;
    require_ok(hs_world_set_velocity(world.get(), plate, velocity, still), context.get());
  }
  std::string last_error() const { return hs_context_last_error(context.get()); }
};

}  // namespace

TEST_CASE("a plate that presses free blocks against a fixed one is told, and makes no energy") {
  for (const int dimension : {2, 3}) {
    for (const int count : {1, 4}) {
      for (const double gap : {0.1, 0.1 + 1e-9, 0.1005}) {  // it arrives at the end of a step, or within one
        INFO(dimension << "D, " << count << " boxes, gap " << gap);
        Press press(dimension, count, gap, -0.1);
        const hs_status status = hs_world_step(press.world.get(), 200);
        CHECK(status == HS_ERROR_UNSTABLE);
        CHECK(press.last_error().find("prescribed block " + hexadecimal_of(press.plate) + " presses") !=
              std::string::npos);
        CHECK(press.last_error().find("the force between blocks ") != std::string::npos);
        const hs_world_report report = report_of(press.world.get());
        CHECK(report.time == Approx(1).margin(0.021));
        const double mass = state_of(press.world.get(), press.boxes[0]).mass;
        CHECK(std::abs(report.energy.outer_work) <
              1e-3 * count * mass * 9.81 + 0.5 * count * mass * 0.01 + std::abs(report.energy.gravity));
        CHECK(report.impact_loss < count * mass * 0.01);
        CHECK(report.max_penetration_ratio < 2e-3);
      }
    }
  }
}

TEST_CASE("a plate that lifts or lowers blocks jams nothing") {
  for (const int dimension : {2, 3}) {
    Press lift(dimension, 3, 0.1, 0.1);
    double velocity[3] = {0, 0, 0};
    require_ok(hs_world_step(lift.world.get(), 100), lift.context.get());
    // A press that stops in time, and goes up again.
    Press press(dimension, 3, 0.1, -0.1);
    require_ok(hs_world_step(press.world.get(), 95), press.context.get());
    velocity[dimension - 1] = 0.1;
    const double still[3] = {0, 0, 0};
    require_ok(hs_world_set_velocity(press.world.get(), press.plate, velocity, still), press.context.get());
    require_ok(hs_world_step(press.world.get(), 100), press.context.get());
  }
}

/// Its impulses do not converge in the sweeps that a step has, which might be a jam. To ask changes none.
TEST_CASE("a plate that pushes a long wall makes no energy") {
  const Context context = make_context();
  hs_world_def def = world_def();
  def.time_step = 1e-3;
  const World world = make_world(context.get(), def);
  std::int32_t material = -1;
  require_ok(hs_world_add_material(world.get(), 2000, &material), context.get());
  hs_law_def law = law_def(1, std::atan(0.5));
  law.stiffness_kind = HS_STIFFNESS_NONE;
  require_ok(hs_world_set_default_law(world.get(), &law), context.get());
  add_block(context.get(), world.get(), box(-50, -1, 80, 0), HS_BLOCK_FIXED);
  const hs_block plate =
      add_block(context.get(), world.get(), box(-1.52, 0.1, -0.52, 10.1), HS_BLOCK_PRESCRIBED);
  const double velocity[] = {1, 0, 0}, spin[] = {0, 0, 0};
  require_ok(hs_world_set_velocity(world.get(), plate, velocity, spin), context.get());
  for (int course = 0; course < 3; ++course) {
    for (int i = 0; i < 60; ++i) {
      const double x = i - 0.5 + 0.5 * (course % 2);
      add_block(context.get(), world.get(), box(x, course, x + 1, course + 1), HS_BLOCK_RIGID);
    }
  }
  require_ok(hs_world_step(world.get(), 60), context.get());
  const hs_energy energy = report_of(world.get()).energy;
  CHECK(energy.residual < 0.05 * energy.kinetic);
}

TEST_CASE("a host ends a step between its parts, and the next call completes it") {
  struct Host {
    int calls = 0, allowed = 3;
  } host;
  hs_context_def def = with_threads(1);
  def.host = &host;
  def.interrupt = [](void* of) {
    Host& known = *static_cast<Host*>(of);
    return std::int32_t(++known.calls > known.allowed);
  };
  Press spun(2, 1, 5, 0, &def), free(2, 1, 5, 0);
  for (const Press* press : {&spun, &free}) {
    const double still[3] = {0, 0, 0}, spin[3] = {0, 0, 3000};  // 30 rad in a step
    require_ok(hs_world_set_velocity(press->world.get(), press->plate, still, spin), press->context.get());
  }
  CHECK(hs_world_step(spun.world.get(), 2) == HS_ERROR_INTERRUPTED);
  CHECK(spun.last_error().find("the host has interrupted step 0") != std::string::npos);
  CHECK(host.calls == 4);
  CHECK(report_of(spun.world.get()).steps == 0);
  CHECK(report_of(spun.world.get()).time > 0);
  host.allowed = 1000000;
  require_ok(hs_world_step(spun.world.get(), 2), spun.context.get());
  require_ok(hs_world_step(free.world.get(), 2), free.context.get());
  CHECK(saved(spun.world.get()) == saved(free.world.get()));
}

TEST_CASE("a step that would be divided too often ends, and names the pair with the largest force") {
  Press press(2, 2, 5, 0);
  const double still[3] = {0, 0, 0}, spin[3] = {0, 0, 1e8};
  require_ok(hs_world_step(press.world.get(), 10), press.context.get());
  require_ok(hs_world_set_velocity(press.world.get(), press.plate, still, spin), press.context.get());
  CHECK(hs_world_step(press.world.get(), 1) == HS_ERROR_UNSTABLE);
  INFO(press.last_error());
  CHECK(press.last_error().find("N, is between blocks " + hexadecimal_of(press.floor) + " and " +
                                hexadecimal_of(press.boxes[0]) + ";") != std::string::npos);
}
