// What a host sees when it uses a world stage by stage, and that it is what a step does.

#include <cmath>
#include <cstring>

#include "capi/world_fixture.h"
#include "catch.h"

namespace halfspace_test {
namespace {

constexpr double time_to_pile_up = 2;  // s: the highest block falls 7 m in 1.2 s

struct Forces {
  std::vector<double> force, torque;  // [n][3]
};

Forces evaluate(hs_world* world, double elapsed, std::size_t blocks) {
  Forces f{std::vector<double>(3 * blocks, -1), std::vector<double>(3 * blocks, -1)};
  const auto view = [&](std::vector<double>& v) {
    return hs_mutable_view{&v[0], &v[1], &v[2], 24, std::int64_t(blocks)};
  };
  if (hs_world_forces(world, elapsed, view(f.force), view(f.torque)) != HS_OK)
    throw std::runtime_error("no forces");
  return f;
}

}  // namespace

TEST_CASE("detect and forces find what the last step found, bit for bit") {
  const Context context = make_context();
  const Pile pile(context.get(), 60);
  run(context.get(), pile.world.get(), time_to_pile_up);
  const std::vector<hs_contact> stepped = contacts_of(pile.world.get());
  REQUIRE(stepped.size() > 60);

  // Detection at the same poses again.
  std::int64_t touching = -1;
  REQUIRE(hs_world_detect(pile.world.get(), &touching) == HS_OK);
  CHECK(touching == std::int64_t(stepped.size()));
  const std::vector<hs_contact> detected = contacts_of(pile.world.get());
  REQUIRE(detected.size() == stepped.size());
  for (std::size_t i = 0; i < detected.size(); ++i) {
    CHECK(detected[i].block_a == stepped[i].block_a);
    CHECK(detected[i].block_b == stepped[i].block_b);
    CHECK(detected[i].gap == stepped[i].gap);
    CHECK(std::memcmp(detected[i].points, stepped[i].points, sizeof stepped[i].points) == 0);
  }
}

TEST_CASE("forces sum to nothing over a pair, and each is what its contacts say") {
  const Context context = make_context();
  const Pile pile(context.get(), 40);
  run(context.get(), pile.world.get(), time_to_pile_up);
  REQUIRE(hs_world_detect(pile.world.get(), nullptr) == HS_OK);
  const Forces got = evaluate(pile.world.get(), 0, pile.blocks.size());
  std::vector<double> expected(3 * pile.blocks.size(), 0.0);
  double largest = 0;
  const auto index = [&](hs_block id) {
    return std::size_t(std::find(pile.blocks.begin(), pile.blocks.end(), id) - pile.blocks.begin());
  };
  for (const hs_contact& c : contacts_of(pile.world.get())) {
    REQUIRE(index(c.block_a) < index(c.block_b));  // sorted, a before b
    for (int k = 0; k < 2; ++k) {
      expected[3 * index(c.block_a) + std::size_t(k)] -= c.force[k];
      expected[3 * index(c.block_b) + std::size_t(k)] += c.force[k];
      largest = std::max(largest, std::abs(c.force[k]));
    }
    // Normal and shear force are the force's components. Unit normals and four products: 16 roundings.
    const double normal = c.force[0] * c.normal[0] + c.force[1] * c.normal[1];
    const double shear = -c.force[0] * c.normal[1] + c.force[1] * c.normal[0];
    const double given = shear_along_tangent(c);
    const double bound = 16 * 0x1p-53 * (std::abs(c.normal_force) + std::abs(given));
    CHECK(std::abs(normal - c.normal_force) <= bound);
    CHECK(std::abs(shear - given) <= bound);
    CHECK(std::abs(given) <= std::tan(0.4) * c.normal_force * (1 + 8 * 0x1p-53));
  }
  REQUIRE(largest > 0);
  // Sums of at most 40 terms, in another order.
  for (std::size_t i = 0; i < expected.size(); ++i)
    CHECK(std::abs(got.force[i] - expected[i]) <= 40 * 40 * 0x1p-53 * largest);
  for (std::size_t i = 0; i < pile.blocks.size(); ++i) {
    CHECK(got.force[3 * i + 2] == 0);
    CHECK(got.torque[3 * i] == 0);
    CHECK(got.torque[3 * i + 1] == 0);
  }
}

TEST_CASE("a host that integrates by itself follows the world's own steps") {
  constexpr double dt = 2e-5;
  constexpr int steps = 2000;
  hs_world_def def = world_def();
  def.time_step = dt;
  TwoBoxes own(0.5, def), hosted(0.5, def);
  const double push[3] = {3, -1, 0}, spin[3] = {0, 0, 2};
  for (TwoBoxes* s : {&own, &hosted}) {
    REQUIRE(hs_world_set_velocity(s->world.get(), s->box_on_floor, push, spin) == HS_OK);
    REQUIRE(hs_world_set_velocity(s->world.get(), s->box_away, push, spin) == HS_OK);
  }
  REQUIRE(hs_world_step(own.world.get(), steps) == HS_OK);

  // Velocity Verlet in the host's own arrays.
  hs_world* w = hosted.world.get();
  const hs_block bodies[2] = {hosted.box_on_floor, hosted.box_away};
  const double mass = state_of(w, bodies[0]).mass;
  const double inertia = mass / 6;  // of a unit square
  double x[2][2], v[2][2], angle[2] = {0, 0}, omega[2];
  for (int b = 0; b < 2; ++b) {
    const hs_block_state state = state_of(w, bodies[b]);
    for (int k = 0; k < 2; ++k) x[b][k] = state.pose.position[k], v[b][k] = state.velocity[k];
    omega[b] = state.angular_velocity[2];
  }
  REQUIRE(hs_world_detect(w, nullptr) == HS_OK);
  Forces f = evaluate(w, 0, 3);
  const auto kick = [&] {
    for (std::size_t b = 0; b < 2; ++b) {
      v[b][0] += 0.5 * dt * f.force[3 * (b + 1)] / mass;
      v[b][1] += 0.5 * dt * (f.force[3 * (b + 1) + 1] / mass - 9.81);
      omega[b] += 0.5 * dt * f.torque[3 * (b + 1) + 2] / inertia;
    }
  };
  for (int i = 0; i < steps; ++i) {
    kick();
    for (int b = 0; b < 2; ++b) {
      for (int k = 0; k < 2; ++k) x[b][k] += dt * v[b][k];
      angle[b] += dt * omega[b];
      const hs_pose pose = pose_at(x[b][0], x[b][1], std::sin(angle[b] / 2), std::cos(angle[b] / 2));
      const double velocity[3] = {v[b][0], v[b][1], 0}, turning[3] = {0, 0, omega[b]};
      REQUIRE(hs_world_set_pose(w, bodies[b], &pose) == HS_OK);
      REQUIRE(hs_world_set_velocity(w, bodies[b], velocity, turning) == HS_OK);
    }
    REQUIRE(hs_world_detect(w, nullptr) == HS_OK);
    f = evaluate(w, dt, 3);
    kick();
  }
  // Per step the two differ by rounding, of positions and of the quaternion: 8 * 2^-53 m at stiffness 1e8 N/m
  // is a force of 9e-8 N, a velocity of 9e-16 m/s; a bounce amplifies linearly, so that over 2000 steps
  // nothing exceeds 2000^2 of these.
  const double bound = double(steps) * steps * 8 * 0x1p-53;
  double worst = 0;
  for (int b = 0; b < 2; ++b) {
    const hs_block_state state = state_of(own.world.get(), b == 0 ? own.box_on_floor : own.box_away);
    for (int k = 0; k < 2; ++k) {
      worst = std::max(worst, std::abs(state.pose.position[k] - x[b][k]));
      CHECK(std::abs(state.pose.position[k] - x[b][k]) <= bound);
    }
    CHECK(std::abs(state.angle - angle[b]) <= bound);
  }
  std::printf("host's integrator against hs_world_step after %d steps: %.3g m, bound %.3g m\n", steps, worst,
              bound);
}

TEST_CASE("a shear spring can be preloaded from either side") {
  for (bool swapped : {false, true}) {
    TwoBoxes s;
    hs_world* w = s.world.get();
    REQUIRE(hs_world_detect(w, nullptr) == HS_OK);
    const double preload = 1234.5;
    const hs_block a = swapped ? s.box_on_floor : s.floor, b = swapped ? s.floor : s.box_on_floor;
    // Along the tangent (-n.y, n.x) of the normal from a to b, up or down.
    const double along_tangent[3] = {swapped ? preload : -preload, 0, 0};
    REQUIRE(hs_world_set_shear_force(w, a, b, along_tangent) == HS_OK);
    const Forces f = evaluate(w, 0, 3);
    const std::vector<hs_contact> contacts = contacts_of(w);
    REQUIRE(contacts.size() == 1);
    const hs_contact& c = contacts[0];
    // Turned into a vector and back, along the unit tangent twice: two products, a sum and the length's
    // own 2 roundings each time.
    CHECK(std::abs(shear_along_tangent(c) - preload) <= 8 * 0x1p-53 * preload);
    // Normal up from the floor to the box, tangent (-n.y, n.x) = (-1, 0): the box is pushed to the left.
    CHECK(c.normal[1] == Approx(1));
    CHECK(f.force[3] == Approx(-preload).epsilon(1e-12));
    CHECK(f.force[0] == Approx(preload).epsilon(1e-12));
    CHECK(c.normal_force ==
          Approx(2000 * 9.81).epsilon(1e-7));  // overlap 2e-4 of coordinates near 1: 1e-16/2e-4, with room
  }
}

TEST_CASE(
    "a time step that is far too large ends as unstable, at finite numbers, and the world can still be "
    "used") {
  // The bound on the stable step is a safe one: twice too large may still be stable, 30 times is not.
  for (double times_stable : {30.0, 100.0, 1000.0}) {
    const Context context = make_context();
    hs_world_def def = world_def();
    double stable = 0;
    {
      const Pile probe(context.get(), 30);
      stable = report_of(probe.world.get()).stable_time_step;
      REQUIRE(stable > 0);
    }
    def.time_step = times_stable * stable;
    const Pile pile(context.get(), 30, def);
    hs_world* w = pile.world.get();
    hs_status status = HS_OK;
    std::int64_t good_steps = 0;
    for (int i = 0; i < 4000 && status == HS_OK; ++i) {
      good_steps = report_of(w).steps;
      status = hs_world_step(w, 1);
      for (const hs_pose& p : poses_of(w)) {
        const bool finite =
            std::isfinite(p.position[0]) && std::isfinite(p.position[1]) && std::isfinite(p.rotation[2]);
        REQUIRE(finite);
      }
    }
    INFO(times_stable << " times the stable step: " << hs_status_string(status) << " after " << good_steps
                      << " steps");
    CHECK(status == HS_ERROR_UNSTABLE);
    const std::string text = hs_context_last_error(context.get());
    CHECK(text.find("hs_world_step") == 0);
    CHECK(text.find("time step") != std::string::npos);
    CHECK(report_of(w).steps == good_steps);
    CHECK(std::isfinite(report_of(w).energy.kinetic));
    const std::vector<unsigned char> bytes = saved(w);
    hs_world* restored = nullptr;
    CHECK(hs_world_restore(context.get(), bytes.data(), bytes.size(), &restored) == HS_OK);
    hs_world_destroy(restored);
  }
}

TEST_CASE("poses, velocities, forces and vertices pass in and out in the order of the blocks") {
  TwoBoxes s;
  hs_world* w = s.world.get();
  const hs_block expected[3] = {s.floor, s.box_on_floor, s.box_away};
  hs_block ids[3] = {};
  std::int64_t count = 0;
  CHECK(hs_world_get_blocks(w, ids, 2, &count) == HS_NOTE_TRUNCATED);
  CHECK(count == 3);
  CHECK(ids[2] == 0);
  REQUIRE(hs_world_get_blocks(w, ids, 3, &count) == HS_OK);
  CHECK(std::equal(ids, ids + 3, expected));

  std::vector<hs_pose> poses = poses_of(w);
  poses[2].position[0] = 7;
  REQUIRE(hs_world_set_poses(w, poses.data(), 3) == HS_OK);
  CHECK(state_of(w, s.box_away).pose.position[0] == 7);
  Points vertices(4);
  REQUIRE(hs_world_get_block_vertices(w, s.box_away, mutable_view_of(vertices), &count) == HS_OK);
  CHECK(count == 4);
  double sum = 0;
  for (const Point& p : vertices) sum += p.x;
  CHECK(sum == Approx(28));

  // Fortran's v(n,3), with turns in a plain array of z.
  const double v[9] = {1, 2, 3, 4, 5, 6, 0, 0, 0};
  const double turns[3] = {0.1, 0.2, 0.3};
  REQUIRE(hs_world_set_velocities(w, {v, v + 3, v + 6, 8, 3}, {turns, turns, turns, 8, 3}) == HS_OK);
  CHECK(state_of(w, s.floor).velocity[0] == 0);  // fixed: ignored
  CHECK(state_of(w, s.box_on_floor).velocity[0] == 2);
  CHECK(state_of(w, s.box_away).velocity[1] == 6);
  CHECK(state_of(w, s.box_away).angular_velocity[2] == 0.3);
  double out[9], out_turns[9];
  REQUIRE(hs_world_get_velocities(w, {out, out + 1, out + 2, 24, 3},
                                  {out_turns, out_turns + 1, out_turns + 2, 24, 3}) == HS_OK);
  const double rows[9] = {0, 0, 0, 2, 5, 0, 3, 6, 0}, turn_rows[9] = {0, 0, 0, 0, 0, 0.2, 0, 0, 0.3};
  CHECK(std::equal(out, out + 9, rows));
  CHECK(std::equal(out_turns, out_turns + 9, turn_rows));
}

TEST_CASE("forces on all blocks are those on each, and so are states") {
  TwoBoxes all, each;
  const double forces[9] = {9, 9, 9, 1, 2, 0, 3, 4, 0}, torques[9] = {9, 9, 9, 0, 0, 5, 0, 0, 6};
  const hs_view force_view{forces, forces + 1, forces + 2, 24, 3};
  const hs_view torque_view{torques, torques + 1, torques + 2, 24, 3};
  REQUIRE(hs_world_set_applied_forces(all.world.get(), force_view, torque_view) == HS_OK);  // fixed: ignored
  REQUIRE(hs_world_set_applied_force(each.world.get(), each.box_on_floor, forces + 3, torques + 3) == HS_OK);
  REQUIRE(hs_world_set_applied_force(each.world.get(), each.box_away, forces + 6, torques + 6) == HS_OK);
  CHECK(saved(all.world.get()) == saved(each.world.get()));

  REQUIRE(hs_world_set_applied_forces(all.world.get(), force_view, {}) == HS_OK);
  const double none[3] = {};
  REQUIRE(hs_world_set_applied_force(each.world.get(), each.box_on_floor, forces + 3, none) == HS_OK);
  REQUIRE(hs_world_set_applied_force(each.world.get(), each.box_away, forces + 6, none) == HS_OK);
  REQUIRE(hs_world_step(all.world.get(), 100) == HS_OK);
  REQUIRE(hs_world_step(each.world.get(), 100) == HS_OK);
  CHECK(saved(all.world.get()) == saved(each.world.get()));

  hs_block_state states[3] = {};
  std::int64_t count = 0;
  CHECK(hs_world_get_block_states(all.world.get(), states, 2, &count) == HS_NOTE_TRUNCATED);
  CHECK(count == 3);
  CHECK(states[2].mass == 0);
  REQUIRE(hs_world_get_block_states(all.world.get(), states, 3, nullptr) == HS_OK);
  const hs_block blocks[3] = {each.floor, each.box_on_floor, each.box_away};
  for (int i = 0; i < 3; ++i) {
    const hs_block_state state = state_of(each.world.get(), blocks[i]);
    CHECK(std::memcmp(&states[i], &state, sizeof state) == 0);
  }
}

}  // namespace halfspace_test
