#include <cmath>

#include "catch.h"
#include "world/motion/penetration_bound.h"
#include "world_parts.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

constexpr double stiffness = 2000, density = 3, thickness = 0.25, length = 2, speed = 0.5;

/// A thick fixed plate across x, and a thinner one of an area of its own that flies at it from `x`.
template <int D>
struct FlyingPlate : WorldParts<D> {
  double area = std::pow(length, D - 1);
  double mass = density * thickness * area;

  explicit FlyingPlate(const ContactLaw& law, double x = 1, double velocity = -speed,
                       BlockKind of_target = BlockKind::fixed)
      : WorldParts<D>(law, settings(), density) {
    Vector<D> sides = Vector<D>::Constant(length);
    sides[0] = 2 * thickness;
    this->add(cuboid<D>(sides), of_target, at<D>(-thickness, 0));
    sides[0] = thickness;
    this->add(cuboid<D>(sides), BlockKind::rigid, at<D>(thickness / 2 + x, 0), at<D>(velocity, 0));
    this->list_neighbors();
    this->find_contacts();
    REQUIRE(this->neighbors.pairs().size() == 1);
  }
  static WorldSettings<D> settings() {
    WorldSettings<D> settings;
    settings.skin = 1;
    settings.potential_length = 0.5;
    return settings;
  }
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("springs stop a block in v sqrt(m / k), told over the thickness of the thinner one",
                       "", ((int D), D), 2, 3) {
  ContactLaw law = normal_spring(stiffness);
  FlyingPlate<D> per_contact(law);
  CHECK(per_contact.spring_stop.deepest() ==
        Approx(speed * std::sqrt(per_contact.mass / stiffness) / thickness));
  law.stiffness_kind = StiffnessKind::per_area;
  FlyingPlate<D> per_area(law);
  CHECK(per_area.spring_stop.deepest() ==
        Approx(speed * std::sqrt(density * thickness / stiffness) / thickness));
  law.stiffness_kind = StiffnessKind::potential;  // 2 k / H an area
  FlyingPlate<D> potential(law);
  CHECK(potential.spring_stop.deepest() ==
        Approx(speed * std::sqrt(density * thickness / (2 * stiffness / 0.5)) / thickness));
}

TEMPLATE_TEST_CASE_SIG("two free blocks are stopped with their reduced mass", "", ((int D), D), 2, 3) {
  FlyingPlate<D> parts(normal_spring(stiffness), 1, -speed, BlockKind::rigid);
  const double reduced_mass = parts.mass * 2 / 3;  // against one twice as heavy
  CHECK(parts.spring_stop.deepest() == Approx(speed * std::sqrt(reduced_mass / stiffness) / thickness));
}

TEMPLATE_TEST_CASE_SIG("a depth that is there adds to it as energies do", "", ((int D), D), 2, 3) {
  const double depth = 0x1p-6;
  FlyingPlate<D> parts(normal_spring(stiffness), -depth);
  const double way = speed * std::sqrt(parts.mass / stiffness);
  CHECK(parts.spring_stop.deepest() == Approx(std::sqrt(depth * depth + way * way) / thickness));
}

TEMPLATE_TEST_CASE_SIG("a block that flies away is stopped by nothing, but what was noted stays", "",
                       ((int D), D), 2, 3) {
  FlyingPlate<D> away(normal_spring(stiffness), 1, speed);
  CHECK(away.spring_stop.deepest() == 0);
  FlyingPlate<D> noted(normal_spring(stiffness));
  const double before = noted.spring_stop.deepest();
  noted.spring_stop.note(noted.spring_stop.of_meeting(noted.neighbors.pairs()[0]));
  noted.blocks.set_motion(1, at<D>(speed, 0), Angular<D>::Zero());
  CHECK(noted.spring_stop.deepest() == before);
}
