// Slip is the change of the relative position of two blocks: a common rotation is none.

#include <array>
#include <cmath>

#include "capi/snapshot_worlds.h"
#include "catch.h"

namespace halfspace_test {
namespace {

constexpr double pi = 3.14159265358979323846;

/// A block, and beside half of its upper face another one or a compound of two, joined by cohesion. They spin
/// as one.
struct SpinningPair {
  Context context = make_context();
  World world;
  hs_block first = 0, second = 0;

  SpinningPair(int dimension, std::int32_t stiffness_kind, bool has_compound, double spin) {
    hs_world_def def = world_def(dimension);
    def.gravity[0] = def.gravity[1] = def.gravity[2] = 0;
    world = make_world(context.get(), def);
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), 2000, &material), context.get());
    hs_law_def law = law_def(1e10, 0.5);
    law.stiffness_kind = stiffness_kind;
    law.cohesion = law.tensile_strength = 1e9;
    law.normal_damping = law.shear_damping = 0.3;
    require_ok(hs_world_set_default_law(world.get(), &law), context.get());
    const Shape shape = shape_of_box(context.get(), dimension);
    first = add_block(context.get(), world.get(), shape, HS_BLOCK_RIGID, pose_at(0, 0));
    if (has_compound) {
      const hs_shape* shapes[] = {shape.get(), shape.get()};
      const hs_pose poses[] = {pose_at(0.25, 0.5), pose_at(0.75, 0.5)};
      hs_block_def compound;
      require_ok(hs_compound_def_init(&compound, sizeof compound, shapes, poses, 2), context.get());
      require_ok(hs_world_add_compound(world.get(), shapes, poses, 2, &compound, &second), context.get());
    } else {
      second = add_block(context.get(), world.get(), shape, HS_BLOCK_RIGID, pose_at(0.25, 0.5));
    }
    for (const hs_block block : {first, second}) {
      const hs_pose pose = state_of(world.get(), block).pose;
      const double* at = pose.position;
      const double velocity[] = {-spin * (at[1] - 0.25), spin * (at[0] - 0.25), 0}, about_z[] = {0, 0, spin};
      require_ok(hs_world_set_velocity(world.get(), block, velocity, about_z), context.get());
    }
  }

  /// From the first to the second, in the frame of the first.
  std::array<double, 2> offset() const {
    const hs_pose from = state_of(world.get(), first).pose, to = state_of(world.get(), second).pose;
    const double angle = 2 * std::atan2(from.rotation[2], from.rotation[3]), c = std::cos(angle),
                 s = std::sin(angle);
    const double x = to.position[0] - from.position[0], y = to.position[1] - from.position[1];
    return {c * x + s * y, c * y - s * x};
  }
};

}  // namespace

TEST_CASE("joined blocks that spin as one keep their places and their energy") {
  const int dimension = GENERATE(2, 3);
  const std::int32_t kind = GENERATE(int(HS_STIFFNESS_PER_CONTACT), int(HS_STIFFNESS_PER_AREA));
  const bool has_compound = GENERATE(false, true);
  const double spin = GENERATE(10.0, 30.0);
  CAPTURE(dimension, kind, has_compound, spin);
  SpinningPair pair(dimension, kind, has_compound, spin);
  run(pair.context.get(), pair.world.get(), 1);  // vibrations by the jump of the speed end
  const std::array<double, 2> before = pair.offset();
  const hs_energy energy_before = report_of(pair.world.get()).energy;
  const int turns = 4;
  run(pair.context.get(), pair.world.get(), turns * 2 * pi / spin);
  const std::array<double, 2> after = pair.offset();
  const hs_energy energy_after = report_of(pair.world.get()).energy;
  for (int k = 0; k < 2; ++k) CHECK(std::abs(after[k] - before[k]) <= 1e-9 * turns);
  CHECK(energy_after.kinetic == Approx(energy_before.kinetic).epsilon(1e-9));
  CHECK(energy_after.contact_damping_loss - energy_before.contact_damping_loss <=
        1e-9 * energy_before.kinetic);
  CHECK(std::abs(energy_after.residual - energy_before.residual) <= 1e-9 * energy_before.kinetic);
}

}  // namespace halfspace_test
