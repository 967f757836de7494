#include "world/contacts/force_pass.h"

#include <cmath>

#include "catch.h"
#include "world_parts.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

constexpr double stiffness = 48, depth = 0.125, offset = 0.5;

/// Two blocks of sides 1 that overlap by the depth in x, and beside that by a half in y.
template <int D>
struct Overlapping : WorldParts<D> {
  explicit Overlapping(const ContactLaw& law) : WorldParts<D>(law) {
    this->add(cube<D>(), BlockKind::rigid, at<D>(3, 2));
    this->add(cube<D>(), BlockKind::rigid, at<D>(3 + 1 - depth, 2 + offset));
    this->list_neighbors();
    this->find_contacts();
    REQUIRE(this->contacts.count() == 1);
  }

  /// `force` acts along x in the middle of the face that both share, a quarter from either centroid; `across`
  /// along y, on the side of b within a, at a third of its depth.
  void check_loads(double force, double across = 0) {
    const Blocks<D>& blocks = this->blocks;
    CHECK((blocks.force[1] - at<D>(force, across)).norm() <= 1e-14 * force);
    CHECK(blocks.force[0] == -blocks.force[1]);
    const auto turning = [&](double arm) {
      Angular<D> torque = Angular<D>::Zero();
      torque[torque.size() - 1] = force * offset / 2 - across * arm;
      return torque;
    };
    CHECK((blocks.torque[0] - turning(0.5 - 2 * depth / 3)).norm() <= 1e-14 * force);
    CHECK((blocks.torque[1] - turning(0.5 - depth / 3)).norm() <= 1e-14 * force);
    const Angular<D> about_origin = blocks.torque[0] + blocks.torque[1] +
                                    moment(blocks.position[0], blocks.force[0]) +
                                    moment(blocks.position[1], blocks.force[1]);
    CHECK(about_origin.norm() <= 1e-13 * force);
    REQUIRE(this->forces.are_known());
    CHECK(this->forces.of_contact(0).force == blocks.force[1]);
  }
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("a spring presses overlapping blocks apart by its stiffness times the depth", "",
                       ((int D), D), 2, 3) {
  Overlapping<D> parts(normal_spring(stiffness));
  for (int time = 0; time < 2; ++time) {  // what was loaded before is gone
    const ContactEnergy energy = parts.load_blocks();
    CHECK(energy.strain == Approx(0.5 * stiffness * depth * depth));
    CHECK(energy.friction_loss == 0);
    parts.check_loads(stiffness * depth);
  }
}

TEMPLATE_TEST_CASE_SIG(
    "a spring per area presses by the area that both share, and on the side within the other", "",
    ((int D), D), 2, 3) {
  ContactLaw law = normal_spring(stiffness);
  law.stiffness_kind = StiffnessKind::per_area;
  Overlapping<D> parts(law);
  CHECK(parts.load_blocks().strain == Approx(0.5 * stiffness * offset * depth * depth));
  parts.check_loads(stiffness * offset * depth, 0.5 * stiffness * depth * depth);
}

TEMPLATE_TEST_CASE_SIG("loads of several contacts add up", "", ((int D), D), 2, 3) {
  WorldParts<D> parts(normal_spring(stiffness));
  for (const double x : {0.0, 0.875, 1.6875}) parts.add(cube<D>(), BlockKind::rigid, at<D>(x, 0));
  parts.list_neighbors();
  parts.find_contacts();
  const ContactEnergy energy = parts.load_blocks();
  CHECK(energy.strain == Approx(0.5 * stiffness * (0.125 * 0.125 + 0.1875 * 0.1875)));
  CHECK(parts.blocks.force[0].x() == Approx(-stiffness * 0.125));
  CHECK(parts.blocks.force[1].x() == Approx(-stiffness * 0.0625));
  CHECK(parts.blocks.force[2].x() == Approx(stiffness * 0.1875));
}

TEMPLATE_TEST_CASE_SIG("a dashpot takes c v^2, c its share of twice the root of k m", "", ((int D), D), 2,
                       3) {
  ContactLaw law = normal_spring(stiffness);
  law.normal_damping = 0.25;
  WorldParts<D> parts(law, {}, 3);
  parts.add(cube<D>(), BlockKind::rigid, at<D>(0, 0), at<D>(0.5, 0));
  parts.add(cube<D>(), BlockKind::rigid, at<D>(1 - depth, 0), at<D>(-1.5, 0));
  parts.list_neighbors();
  parts.find_contacts();
  parts.load_blocks();
  const double reduced_mass = 1.5, speed = 2;
  const double viscosity = 0.25 * 2 * std::sqrt(stiffness * reduced_mass);
  CHECK(parts.blocks.force[1].x() == Approx(stiffness * depth + viscosity * speed));
  CHECK(parts.forces.dashpot_power(0) == Approx(viscosity * speed * 0.5));
  CHECK(parts.forces.dashpot_power(1) == Approx(viscosity * speed * 1.5));
}
