// Whole worlds where no answer is known: the mirrored world, the renumbered one and the moving one must do
// the same.

#include <algorithm>
#include <numeric>

#include "catch.h"
#include "validation/scene.h"

namespace {

using namespace halfspace_test;

constexpr double time_step = 1e-4;
constexpr int steps = 8000;

/// A heap of blocks of all sorts falls into a trough.
struct Change {
  bool mirrored = false;
  std::vector<int> order;  // of adding; empty as given
  Point drift{};           // of everything
  double disturbance = 0;  // of the first falling block's place
};

struct Placed {
  Points vertices;
  int32_t kind;
};

std::vector<Placed> heap(double disturbance) {
  const auto regular = [](int corners, double x, double y, double r, double turn) {
    Points p;
    for (int k = 0; k < corners; ++k) {
      const double angle = turn + 2 * pi * k / corners;
      p.push_back({x + r * std::cos(angle), y + r * std::sin(angle)});
    }
    return p;
  };
  std::vector<Placed> blocks{{{{-3, -0.5}, {3, -0.5}, {3, 0}, {-3, 0}}, HS_BLOCK_FIXED},
                             {{{-3, 0}, {-2, 0}, {-3, 2}}, HS_BLOCK_FIXED},
                             {{{3, 0}, {3, 2}, {2, 0}}, HS_BLOCK_FIXED}};
  for (int i = 0; i < 12; ++i) {
    const double x = -1.2 + 0.8 * (i % 4) + 0.11 * (i / 4) + (i == 0 ? disturbance : 0);
    blocks.push_back(
        {regular(3 + i % 5, x, 0.42 + 0.75 * (i / 4), 0.33 + 0.01 * (i % 3), 0.3 * i), HS_BLOCK_RIGID});
  }
  return blocks;
}

struct Outcome {
  std::vector<double> values;  // places, turns and velocities at the end, changes undone
  hs_energy energy;
  std::int64_t contacts;
};

Outcome run(const Change& change, int32_t stiffness_kind) {
  hs_law_def law = spring_law(2e7, 20 * degree);
  law.stiffness_kind = stiffness_kind;
  law.normal_damping = 0.5;
  law.shear_damping = 0.5;
  Scene scene(world_def(time_step), law);
  const std::vector<Placed> blocks = heap(change.disturbance);
  std::vector<int> order = change.order;
  if (order.empty()) {
    order.resize(blocks.size());
    std::iota(order.begin(), order.end(), 0);
  }
  const double sign = change.mirrored ? -1 : 1;
  const bool drifts = change.drift.x != 0 || change.drift.y != 0;
  std::vector<hs_block> ids(blocks.size());
  for (int i : order) {
    Points vertices = blocks[std::size_t(i)].vertices;
    for (Point& p : vertices) p.x *= sign;
    int32_t kind = blocks[std::size_t(i)].kind;
    if (drifts && kind == HS_BLOCK_FIXED) kind = HS_BLOCK_PRESCRIBED;
    ids[std::size_t(i)] = scene.add(vertices, {kind, kind == HS_BLOCK_FIXED ? Point{} : change.drift, 0});
  }
  scene.step(steps);
  const double time = scene.report().time;
  Outcome outcome{{}, scene.energy(), scene.report().contact_count};
  for (hs_block id : ids) {
    const hs_block_state s = scene.state(id);
    if (s.kind != HS_BLOCK_RIGID) continue;
    outcome.values.insert(
        outcome.values.end(),
        {sign * (s.pose.position[0] - change.drift.x * time), s.pose.position[1] - change.drift.y * time,
         sign * s.angle, sign * (s.velocity[0] - change.drift.x), s.velocity[1] - change.drift.y,
         sign * s.angular_velocity[2]});
  }
  return outcome;
}

double difference(const Outcome& a, const Outcome& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    largest = std::max(largest, std::abs(a.values[i] - b.values[i]));
  return largest;
}

/// Nothing but rounding may differ: each step rounds places of some 4 m (4e-16; in the moving world as many
/// times more as it is farther), and the collisions enlarge that as they enlarge any disturbance. By how much
/// is found by a disturbance of 1e-10 m; one disturbance may happen to grow less than another: a factor 10.
TEST_CASE("a world mirrored, renumbered or in steady motion does the same") {
  constexpr double shift = 1e-10;
  for (int32_t kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA}) {
    const char* name = kind == HS_STIFFNESS_PER_AREA ? "per area" : "per contact";
    const Outcome plain = run({}, kind);
    const double growth = std::max(1.0, difference(run({false, {}, {}, shift}, kind), plain) / shift);
    const double expected = 10 * growth * steps * 4 * rounding;

    std::vector<int> reversed(heap(0).size());
    std::iota(reversed.rbegin(), reversed.rend(), 0);
    constexpr double speed = 16;
    const double mirror = difference(run({true, {}, {}, 0}, kind), plain);
    const double order = difference(run({false, reversed, {}, 0}, kind), plain);
    const Outcome boosted = run({false, {}, {speed, 0}, 0}, kind);
    const double boost = difference(boosted, plain);
    std::printf(
        "whole world, %s: %lld contacts, a disturbance grows by %.1e; mirrored differs by %.1e, renumbered "
        "by %.1e, at 16 m/s by %.1e (rounding explains %.1e)\n",
        name, (long long)plain.contacts, growth, mirror, order, boost, expected);
    std::printf(
        "whole world, %s: kinetic %.3f J, friction loss %.3f J, damping loss %.3f J, ledger residual %.2e J "
        "(%.1e of the losses)\n",
        name, plain.energy.kinetic, plain.energy.friction_loss, plain.energy.contact_damping_loss,
        plain.energy.residual,
        plain.energy.residual / (plain.energy.friction_loss + plain.energy.contact_damping_loss));
    CHECK(plain.contacts >= 12);
    CHECK(expected < 1e-3);  // else the test would say nothing
    CHECK(mirror <= expected);
    CHECK(order <= expected);
    CHECK(boost <= expected * (1 + speed * steps * time_step / 4));
    CHECK(boosted.contacts == plain.contacts);
  }
}

}  // namespace
