// The stable time step: what is reported never exceeds what an eigenvalue analysis allows, and that is what
// it allows.

#include <Eigen/Dense>
#include <map>

#include "catch.h"
#include "validation/scene.h"

namespace {

using namespace halfspace_test;

/// Stiffness, damping and mass of all rigid blocks' motion (x, y, turn) about where they are, from the
/// contacts of the world: each point of a region has its half of the normal stiffness, the region's middle
/// the shear stiffness.
struct LinearWorld {
  Eigen::MatrixXd stiffness;
  Eigen::MatrixXd damping;
  Eigen::VectorXd mass;

  LinearWorld(const Scene& scene, const hs_law_def& law, const std::map<hs_block, double>& inertia_of) {
    scene.check(hs_world_detect(scene.world(), nullptr));
    std::map<hs_block, int> first;
    for (auto [block, inertia] : inertia_of) first.emplace(block, 3 * int(first.size()));
    const int n = 3 * int(first.size());
    stiffness = damping = Eigen::MatrixXd::Zero(n, n);
    mass.resize(n);
    for (auto [block, inertia] : inertia_of) {
      const double m = scene.state(block).mass;
      mass.segment<3>(first[block]) << m, m, inertia;
    }
    for (const hs_contact& c : scene.contacts()) {
      const auto rate_at = [&](double x, double y, double nx, double ny) {
        Eigen::VectorXd row = Eigen::VectorXd::Zero(n);
        const auto add = [&](hs_block block, double sign) {
          if (!first.count(block)) return;
          const Point p = scene.position(block);
          row.segment<3>(first[block]) << sign * nx, sign * ny, sign * ((x - p.x) * ny - (y - p.y) * nx);
        };
        add(c.block_a, -1);
        add(c.block_b, 1);
        return row;
      };
      const auto inverse_mass = [&](hs_block block) {
        return first.count(block) ? 1 / scene.state(block).mass : 0;
      };
      const double reduced = 1 / (inverse_mass(c.block_a) + inverse_mass(c.block_b));
      double mid_x = 0, mid_y = 0;
      for (int i = 0; i < c.point_count; ++i) {
        const Eigen::VectorXd row = rate_at(c.points[i][0], c.points[i][1], c.normal[0], c.normal[1]);
        const double share = 1.0 / c.point_count;
        stiffness += share * law.normal_stiffness * row * row.transpose();
        damping += share * 2 * law.normal_damping * std::sqrt(law.normal_stiffness * reduced) * row *
                   row.transpose();
        mid_x += share * c.points[i][0];
        mid_y += share * c.points[i][1];
      }
      if (law.friction_angle == 0) continue;
      const Eigen::VectorXd row = rate_at(mid_x, mid_y, -c.normal[1], c.normal[0]);
      stiffness += law.shear_stiffness * row * row.transpose();
      damping += 2 * law.shear_damping * std::sqrt(law.shear_stiffness * reduced) * row * row.transpose();
    }
  }

  /// Leapfrog without damping: 2 / omega of the fastest mode.
  double critical_step() const {
    const Eigen::VectorXd scale = mass.cwiseSqrt().cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(scale.asDiagonal() * stiffness *
                                                               scale.asDiagonal());
    return 2 / std::sqrt(modes.eigenvalues().maxCoeff());
  }

  /// Growth per step of v' = v - dt M^-1 (K x + C v), x' = x + dt v': dashpots read the velocity of half a
  /// step before.
  double growth(double dt) const {
    const Eigen::Index n = mass.size();
    const Eigen::MatrixXd inverse = mass.cwiseInverse().asDiagonal();
    const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(n, n);
    Eigen::MatrixXd step(2 * n, 2 * n);
    const Eigen::MatrixXd vx = -dt * inverse * stiffness, vv = one - dt * inverse * damping;
    step << one + dt * vx, dt * vv, vx, vv;
    return step.eigenvalues().cwiseAbs().maxCoeff();
  }

  /// With damping: where growth passes 1. The free modes' growth is 1 to the root of rounding (a double
  /// eigenvalue).
  double damped_critical_step() const {
    double low = 0, high = critical_step();
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      (growth(middle) <= 1 + 1e-6 ? low : high) = middle;
    }
    return low;
  }
};

double inertia_of_box(double mass, double width, double height) {
  return mass * (width * width + height * height) / 12;
}

/// Blocks of one width on top of one another, each pressed into the one below by the weight above.
struct Stack {
  Scene scene;
  std::map<hs_block, double> inertia;

  Stack(const hs_law_def& law, int count, double width, double height) : scene(world_def(0), law) {
    scene.add(box(-10, -1, 10, 0), {HS_BLOCK_FIXED, {}, 0});
    const double mass = 2000 * width * height;
    double y = 0;
    for (int i = 0; i < count; ++i) {
      y -= mass * 9.81 * (count - i) / law.normal_stiffness;
      inertia[scene.add(box(-width / 2, y, width / 2, y + height))] = inertia_of_box(mass, width, height);
      y += height;
    }
  }
};

/// A beam on many narrow supports.
struct Beam {
  Scene scene;
  std::map<hs_block, double> inertia;

  Beam(const hs_law_def& law, int supports) : scene(world_def(0), law) {
    const double length = 2 * supports, mass = 2000 * length;
    const double sunk = mass * 9.81 / law.normal_stiffness / supports;
    for (int i = 0; i < supports; ++i) {
      const double x = 2 * i - length / 2 + 0.5;
      scene.add(box(x, -1, x + 1, 0), {HS_BLOCK_FIXED, {}, 0});
    }
    inertia[scene.add(box(-length / 2, -sunk, length / 2, 1 - sunk))] = inertia_of_box(mass, length, 1);
  }
};

/// A sheet in free space, with many little blocks pressed against it.
struct Sheet {
  static constexpr double little_mass = 500, mass = 10 * little_mass;
  Scene scene;
  std::map<hs_block, double> inertia;

  Sheet(const hs_law_def& law, int count) : scene(world_def(0, 0), law) {
    const double length = count, height = mass / 2000 / length, little = 0.5;
    inertia[scene.add(box(-length / 2, -height, length / 2, 0))] = inertia_of_box(mass, length, height);
    for (int i = 0; i < count; ++i) {
      const double x = i - length / 2 + 0.25;
      inertia[scene.add(box(x, -1e-4, x + little, little - 1e-4))] =
          inertia_of_box(little_mass, little, little);
    }
  }
};

template <class Group>
void check_reported(const char* name, const Group& group, const hs_law_def& law) {
  const LinearWorld linear(group.scene, law, group.inertia);
  const double reported = group.scene.report().stable_time_step;
  const double critical = law.normal_damping > 0 ? linear.damped_critical_step() : linear.critical_step();
  std::printf(
      "stable step, %s, friction %s, damping ratio %.1f: reported %.3e s, critical %.3e s: %.2f of it\n",
      name, law.friction_angle > 0 ? "yes" : "no", law.normal_damping, reported, critical,
      reported / critical);
  CHECK(reported > 0);
  CHECK(reported <= critical);
}

TEST_CASE("the stable time step reported is never above the critical one of the eigenvalue analysis") {
  for (double friction : {0.0, 30.0}) {
    for (double damping : {0.0, 0.2, 1.0}) {
      hs_law_def law = spring_law(1e8, friction * degree);
      law.normal_damping = law.shear_damping = damping;
      check_reported("two blocks", Stack(law, 1, 1, 1), law);
      check_reported("stack of 8", Stack(law, 8, 1, 1), law);
      check_reported("stack of 8 slabs", Stack(law, 8, 2, 0.1), law);
      check_reported("beam on 12 supports", Beam(law, 12), law);
    }
  }
}

/// A dashpot between a big block and a little one is one for the mass that both move together. All contacts
/// have the same here, so that damping is proportional to stiffness and each mode has its own critical step.
/// Where springs are counted as omega^2 times so much too stiff, dashpots may be too viscous by as much, no
/// more.
TEST_CASE("of little blocks on a big one the stable time step counts dashpots no worse than springs") {
  hs_law_def law = spring_law(1e8, 30 * degree);
  const Sheet undamped(law, 160);
  const double omega = 2 / LinearWorld(undamped.scene, law, undamped.inertia).critical_step();
  const double counted = 2 / undamped.scene.report().stable_time_step;
  const double excess = counted * counted / (omega * omega);
  for (double damping : {0.2, 1.0}) {
    law.normal_damping = law.shear_damping = damping;
    const double reduced = Sheet::mass * Sheet::little_mass / (Sheet::mass + Sheet::little_mass);
    const double gamma = 2 * damping * std::sqrt(reduced / law.normal_stiffness) * omega * omega;
    const double critical = 4 / (gamma + std::sqrt(gamma * gamma + 4 * omega * omega));
    const double reported = Sheet(law, 160).scene.report().stable_time_step;
    std::printf(
        "stable step, 160 little blocks on a sheet, damping ratio %.1f: %.2f of the critical one, "
        "without dashpots %.2f\n",
        damping, reported / critical, omega / counted);
    CHECK(reported <= critical);
    CHECK(reported * excess >= critical);
  }
}

/// One block on one spring, bonded so that it pulls as well as pushes: the step's own limit, 2 sqrt(m / K).
/// Rocking is slower for a slender block: (w/2)^2 / I = 3 w^2 / (m (w^2 + h^2)) < 1 / m.
TEST_CASE("a block on a spring stays bounded at 0.99 of the critical step and not at 1.01") {
  constexpr double stiffness = 1e8, width = 0.5, height = 2, mass = 2000;
  hs_law_def law = spring_law(stiffness);
  law.shear_stiffness = 0;
  law.tensile_strength = 1e12;
  const double critical = 2 * std::sqrt(mass / stiffness);
  // Leapfrog at the share q of its limit keeps (1 - q^2) omega^2 x^2 + v^2: no place is farther than 1 /
  // sqrt(1 - q^2) of the first.
  constexpr double start = 1e-6;
  const auto largest = [&](double share) {
    Scene scene(world_def(share * critical, 0), law);
    scene.add(box(-2, -1, 2, 0), {HS_BLOCK_FIXED, {}, 0});
    const hs_block block =
        scene.add(box(-width / 2, 0, width / 2, height), {HS_BLOCK_RIGID, {0, start * 2 / critical}, 0});
    double largest = 0;
    for (int i = 0; i < 10000; ++i) {
      if (hs_world_step(scene.world(), 1) != HS_OK) return HUGE_VAL;
      largest = std::max(largest, std::abs(scene.position(block).y - height / 2));
    }
    return largest / start;
  };
  const double below = largest(0.99), above = largest(1.01);
  std::printf(
      "one spring: largest place %.3f of the amplitude at 0.99 of the critical step (bound %.3f), %.1e at "
      "1.01\n",
      below, 1 / std::sqrt(1 - 0.99 * 0.99), above);
  CHECK(below <= 1 / std::sqrt(1 - 0.99 * 0.99) * (1 + 1e-6));
  CHECK(above > 1e3);
}

}  // namespace
