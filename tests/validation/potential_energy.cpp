// The force of potentials is the gradient of an energy (Zheng et al. 2020, section 3.2): no way through the
// blocks that ends where it began takes or gives any, and random polygons bounce off each other elastically.

#include <random>

#include "catch.h"
#include "validation/scene.h"

namespace {

using namespace halfspace_test;

constexpr double stiffness = 1e7;
constexpr double density = 2000;

/// Uniform numbers that are the same everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * (double(generator_() >> 11) * 0x1p-53);
  }

 private:
  std::mt19937_64 generator_;
};

/// Corners on a circle, no two of them near each other.
Points random_polygon(Random& random, double radius) {
  const int corners = 3 + int(random.uniform(0, 6));
  Points polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * (i + random.uniform(0, 0.7)) / corners;
    polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return polygon;
}

hs_world_def world_of_potentials(double time_step) {
  hs_world_def def = world_def(time_step, 0);
  def.potential_length = 1;
  return def;
}

/// A block that is led around another one, which stands still: on an ellipse, rocking.
struct Loop {
  Point center, half_axes;
  double turn, rocking;

  struct Pose {
    double x, y, angle;
  };
  Pose at(double share) const {
    const double phase = 2 * pi * share;
    return {center.x + half_axes.x * std::cos(phase), center.y + half_axes.y * std::sin(phase),
            turn + rocking * std::sin(2 * phase)};
  }
};

struct Work {
  double around;   // the whole loop
  double largest;  // of the work from the start to anywhere on it
};

/// Force and torque times the way, by the trapezoid rule.
Work work_around(const Scene& scene, hs_block moved, const Loop& loop, int steps) {
  Work work{0, 0};
  struct Push {
    double x, y, torque;
  };
  const auto push_at = [&](const Loop::Pose& p) {
    const hs_pose pose = pose_at(p.x, p.y, std::sin(p.angle / 2), std::cos(p.angle / 2));
    scene.check(hs_world_set_pose(scene.world(), moved, &pose));
    scene.check(hs_world_step(scene.world(), 0));  // evaluates forces there
    const hs_block_state state = scene.state(moved);
    return Push{state.force[0], state.force[1], state.torque[2]};
  };
  Loop::Pose from = loop.at(0);
  Push before = push_at(from);
  for (int i = 1; i <= steps; ++i) {
    const Loop::Pose to = loop.at(double(i) / steps);
    const Push after = push_at(to);
    work.around += ((before.x + after.x) * (to.x - from.x) + (before.y + after.y) * (to.y - from.y) +
                    (before.torque + after.torque) * (to.angle - from.angle)) /
                   2;
    work.largest = std::max(work.largest, std::abs(work.around));
    from = to;
    before = after;
  }
  return work;
}

/// The force is continuous, with a bounded slope that jumps where corners enter and leave: the trapezoid
/// rule's error falls with the square of the step. Many random loops average where in a step the jumps lie.
/// Penalty springs are printed beside it: their force changes with the edge it refers to.
TEST_CASE("potentials do no work around closed loops of rigid motion") {
  constexpr int loops = 100;
  for (int32_t kind : all_stiffness_kinds) {
    hs_law_def law = spring_law(stiffness);
    law.stiffness_kind = kind;
    double coarser = 0;
    for (int steps : {250, 1000, 4000}) {
      Random random(67);
      double sum = 0, sum_of_largest = 0;
      for (int i = 0; i < loops; ++i) {
        Scene scene(world_of_potentials(0), law, density);
        scene.add_at(random_polygon(random, 1), {0, 0}, 0, {HS_BLOCK_FIXED, {}, 0});
        const hs_block moved = scene.add_at(random_polygon(random, random.uniform(0.3, 1)), {5, 5}, 0);
        const Loop loop{{random.uniform(-1, 1), random.uniform(-1, 1)},
                        {random.uniform(0.2, 1), random.uniform(0.2, 1)},
                        random.uniform(0, 6),
                        random.uniform(-1, 1)};
        const Work work = work_around(scene, moved, loop, steps);
        sum += square_of(work.around);
        sum_of_largest += square_of(work.largest);
      }
      const double share = std::sqrt(sum / sum_of_largest);
      std::printf("closed loops, %s, %d steps: work %.2e of the largest on the way\n",
                  name_of_stiffness(kind), steps, share);
      REQUIRE(share > 0);
      if (kind == HS_STIFFNESS_POTENTIAL && coarser > 0) CHECK(coarser / share >= 16 - 3);
      coarser = share;
    }
  }
}

/// Two polygons that fly at each other, spinning.
struct Impact {
  Scene scene;
  hs_block blocks[2];
  double inertia[2];

  Impact(Random& random, double time_step, double gap)
      : scene(world_of_potentials(time_step), potential_law(stiffness), density) {
    const double x[] = {0, 1 + gap}, speed[] = {0.5, -0.5};
    for (int i = 0; i < 2; ++i) {
      const Points polygon = random_polygon(random, 0.5);
      const Shape shape = make_shape(scene.context(), polygon);
      const hs_shape_properties properties = properties_of(shape.get());
      inertia[i] = density * (properties.second_moment[0] + properties.second_moment[1]);
      const double y = random.uniform(-0.2, 0.2), spin = random.uniform(-1, 1);
      blocks[i] = scene.add_at(polygon, {x[i], y}, 0, {HS_BLOCK_RIGID, {speed[i], 0}, spin});
    }
  }

  /// About the origin.
  double angular_momentum() const {
    double sum = 0;
    for (int i = 0; i < 2; ++i) {
      const hs_block_state s = scene.state(blocks[i]);
      sum += s.mass * (s.pose.position[0] * s.velocity[1] - s.pose.position[1] * s.velocity[0]) +
             inertia[i] * s.angular_velocity[2];
    }
    return sum;
  }
};

/// Corners touch with no jump of the force's slope: over random impacts, whose touches lie anywhere in a
/// step, the energy's error falls at least with the square of the step (see the elastic bounces of plain
/// shapes). Forces are opposite and act on one line: a step changes momenta by rounding only.
TEST_CASE("random polygons bounce off each other with the energy they had") {
  constexpr int impacts = 200;
  double coarser = 0;
  for (double time_step : {8e-4, 4e-4, 2e-4, 1e-4}) {
    Random random(68);
    double sum = 0, momentum_error = 0;
    int met = 0;
    for (int i = 0; i < impacts; ++i) {
      Impact impact(random, time_step, 0.1 + random.uniform(0, 1) * time_step);
      const double energy = impact.scene.energy().kinetic, momentum = impact.angular_momentum();
      const std::int64_t steps = std::llround(1.5 / time_step);
      for (std::int64_t k = 0; k < steps; ++k) impact.scene.step();
      const hs_energy end = impact.scene.energy();
      const double gained = (end.kinetic + end.strain) / energy - 1;
      met += impact.scene.velocity(impact.blocks[0]).x != 0.5;
      sum += square_of(gained);
      momentum_error = std::max(momentum_error, std::abs(impact.angular_momentum() - momentum));
    }
    const double error = std::sqrt(sum / impacts);
    std::printf(
        "random impacts, step %.0e: %d of %d met, energy off by %.2e, angular momentum by %.1e kg m^2/s\n",
        time_step, met, impacts, error, momentum_error);
    CHECK(met > impacts / 2);
    if (coarser > 0) CHECK(coarser / error >= 4 - 0.75);
    // Momenta of up to m v r = 2000 kg m^2/s round in every step.
    CHECK(momentum_error <= 2000 * rounding * 1.5 / time_step);
    coarser = error;
  }
}

}  // namespace
