// The stable time step where blocks lie on one another askew. All second derivatives of the energy are taken
// by differences of the forces.

#include <Eigen/Dense>

#include "catch.h"
#include "validation/solid_scene.h"

namespace {

using namespace halfspace_test;

/// A unit box that has sunk into the ground, and may be moved and turned a little.
struct SunkenBox {
  SolidScene scene;
  hs_block block;
  double depth;
  Eigen::VectorXd mass;  // of x, y and turn; in space of x, y, z and three turns

  static hs_world_def def(int dimension, double parallel_angle) {
    hs_world_def def = solid_world_def(0, {0, 0, 0});
    def.dimension = dimension;
    def.parallel_angle = parallel_angle;
    return def;
  }

  SunkenBox(int dimension, double parallel_angle, double sunk, const hs_law_def& law)
      : scene(def(dimension, parallel_angle), law), depth(sunk) {
    if (dimension == 2) {
      scene.add(box(-3, -1, 3, 0), {HS_BLOCK_FIXED, {}, 0});
      block = scene.add(box(-0.5, 0, 0.5, 1));
    } else {
      scene.add_hull(cuboid({6, 6, 1}), {{0, 0, -0.5}, {0, 0, 0, 1}, HS_BLOCK_FIXED, {}, {}});
      block = scene.add_hull(cuboid({1, 1, 1}), {});
    }
    const double m = 2000;
    mass.resize(dimension == 2 ? 3 : 6);
    mass.setConstant(m / 6);
    mass.head(dimension).setConstant(m);
  }

  void move(const Eigen::VectorXd& way) {
    const auto plane = mass.size() == 3;
    hs_pose pose{{way[0], way[1], 0}, {0, 0, 0, 1}};
    if (plane) {
      pose.position[1] += 0.5 - depth;
      pose.rotation[2] = std::sin(0.5 * way[2]);
      pose.rotation[3] = std::cos(0.5 * way[2]);
    } else {
      pose.position[2] = way[2] + 0.5 - depth;
      const Triple axis = {way[3], way[4], way[5]};
      if (length(axis) > 0) {
        const Quaternion q = turn_about(axis, length(axis));
        std::copy(q.begin(), q.end(), pose.rotation);
      }
    }
    scene.check(hs_world_set_pose(scene.world(), block, &pose));
  }

  /// On the box: the ground is the first of both blocks.
  Eigen::VectorXd force_at(const Eigen::VectorXd& way) {
    move(way);
    Triple force[2], torque[2];
    const auto view = [](Triple* v) {
      return hs_mutable_view{&v[0][0], &v[0][1], &v[0][2], sizeof(Triple), 2};
    };
    scene.check(hs_world_detect(scene.world(), nullptr));
    scene.check(hs_world_forces(scene.world(), 0, view(force), view(torque)));
    Eigen::VectorXd all(mass.size());
    if (mass.size() == 3) {
      all << force[1][0], force[1][1], torque[1][2];
    } else {
      all << force[1][0], force[1][1], force[1][2], torque[1][0], torque[1][1], torque[1][2];
    }
    return all;
  }

  /// Of the fastest mode about a place.
  double critical_step(const Eigen::VectorXd& place, double difference) {
    const Eigen::Index n = mass.size();
    Eigen::MatrixXd stiffness(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::VectorXd way = difference * Eigen::VectorXd::Unit(n, i);
      stiffness.col(i) = (force_at(place - way) - force_at(place + way)) / (2 * difference);
    }
    const Eigen::VectorXd scale = mass.cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd symmetric = 0.5 * (stiffness + stiffness.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(scale.asDiagonal() * symmetric *
                                                               scale.asDiagonal());
    return 2 / std::sqrt(modes.eigenvalues().maxCoeff());
  }
};

TEST_CASE("the stable time step is safe for regions that tilt, up to where they become edges and points") {
  for (const int dimension : {2, 3}) {
    double worst = 0, widest = HUGE_VAL;
    for (const double angle : {0.003, 0.01, 0.1}) {
      for (const double depth : {1e-4, 1e-3, 1e-2, 0.05}) {
        hs_law_def law = spring_law(1e8);
        law.shear_stiffness = 0;
        SunkenBox sunken(dimension, angle, depth, law);
        double least = HUGE_VAL, reported = HUGE_VAL;
        for (double tilt = 0.01; tilt < 1; tilt += 0.02) {
          Eigen::VectorXd place = Eigen::VectorXd::Zero(sunken.mass.size());
          place[dimension == 2 ? 2 : 3] = tilt * angle;
          if (dimension == 3) place[4] = 0.3 * tilt * angle;
          least = std::min(least, sunken.critical_step(place, 1e-4 * angle));
          sunken.move(place);
          reported = std::min(reported, sunken.scene.report().stable_time_step);
        }
        CHECK(reported <= least);
        worst = std::max(worst, reported / least);
        widest = std::min(widest, reported / least);
      }
    }
    std::printf("stable step, box sunk askew in %dD: %.2f to %.2f of the critical one\n", dimension, widest,
                worst);
  }
}

}  // namespace
