#include "force/spring/spring.h"

#include <numbers>

#include "bare_law.h"
#include "catch.h"

using namespace halfspace;

namespace {

/// Block b, 2 wide, lies on block a with an overlap: an edge-edge contact with its normal up.
struct OnTop {
  Contact<2> contact;
  PairMotion<2> motion{{0, 0}, {0, 2}, Angular<2>(0), Angular<2>(0)};
  ShearSpring<2> shear;
  std::int32_t bonded = false;
  ContactEnergy energy;

  explicit OnTop(double overlap) {
    contact.type = ContactType::edge_edge;
    contact.normal = {0, 1};
    contact.gap = -overlap;
    contact.length = 2;
    contact.point_count = 2;
    contact.points[0] = {-1, 1};
    contact.points[1] = {1, 1};
    contact.gaps[0] = contact.gaps[1] = -overlap;
  }

  PairLoad<2> press(const ContactLaw& law, double elapsed) {
    energy = {};
    return Spring<2>{law, 1, elapsed}.evaluate(contact, PointSprings<2>{{0.5, 0.5}}, motion, shear, bonded,
                                               energy);
  }
};

ContactLaw stiff() {
  ContactLaw law = test::bare_law();
  law.normal_stiffness = 1000;
  law.shear_stiffness = 100;
  return law;
}

}  // namespace

TEST_CASE("the stiffness of a contact is shared over its points") {
  OnTop block(0.01);
  const PairLoad<2> load = block.press(stiff(), 0);
  CHECK(load.contact.force.y() == Approx(10));
  CHECK(load.contact.force.isApprox(Vector<2>(0, 10)));
  CHECK(load.contact.point.isApprox(Vector<2>(0, 1)));
  CHECK(block.energy.strain == Approx(0.5 * 1000 * 0.01 * 0.01));
}

TEST_CASE("shear grows with slip, up to Mohr-Coulomb, and sliding loses force times slip") {
  ContactLaw law = stiff();
  law.tan_friction = 0.5;
  OnTop block(0.01);
  block.motion.velocity = {1, 0};  // b slips to the right; the tangent of an upward normal points left
  CHECK(-block.press(law, 0.01).contact.force.x() == Approx(100 * 0.01));
  CHECK(block.energy.friction_loss == Approx(0).margin(1e-15));
  CHECK(block.press(law, 0.01).contact.force.x() == Approx(-2));
  const PairLoad<2> sliding = block.press(law, 1.0);
  CHECK(-sliding.contact.force.x() == Approx(5));
  CHECK(sliding.contact.force.isApprox(Vector<2>(-5, 10)));
  // From 2 to 5 the spring took 0.03 of the slip at a mean of 3.5; the rest slid.
  block.press(law, 1.0);
  CHECK(block.energy.friction_loss == Approx(5 * 1.0));
}

TEST_CASE("an intact contact holds cohesion and tension until it fails, then friction only") {
  ContactLaw law = stiff();
  law.tan_friction = 0.5;
  law.cohesion = 3;           // times a length of 2: 6
  law.tensile_strength = 10;  // 20
  SECTION("shear") {
    OnTop block(0.01);
    block.bonded = true;
    block.motion.velocity = {1, 0};
    CHECK(-block.press(law, 0.10).contact.force.x() == Approx(10));  // below 5 + 6
    CHECK(block.bonded);
    CHECK(-block.press(law, 0.02).contact.force.x() == Approx(5));
    CHECK_FALSE(block.bonded);
  }
  SECTION("tension") {
    OnTop held(-0.019);
    held.bonded = true;
    CHECK(held.press(law, 0).contact.force.y() == Approx(-19));
    CHECK(held.bonded);
    OnTop torn(-0.021);
    torn.bonded = true;
    CHECK(torn.press(law, 0).contact.force.y() == 0);
    CHECK_FALSE(torn.bonded);
    CHECK(torn.energy.friction_loss == Approx(0.5 * 1000 * 0.021 * 0.021));
  }
}

TEST_CASE("viscous damping brakes and never pulls") {
  ContactLaw law = stiff();
  law.normal_damping = 0.5;
  OnTop block(0.001);
  block.motion.velocity = {0, -1};
  const double viscosity = 2 * 0.5 * std::sqrt(1000.0);
  const PairLoad<2> load = block.press(law, 0.001);
  CHECK(load.contact.force.y() == Approx(1 + viscosity));
  CHECK(load.viscous.force.y() == Approx(viscosity));
  block.motion.velocity = {0, 1};
  CHECK(block.press(law, 0.001).contact.force.y() == 0);
}

TEST_CASE("action and reaction: the torques about any one point cancel") {
  ContactLaw law = stiff();
  law.tan_friction = 0.5;
  OnTop block(0.01);
  block.contact.gaps[1] = -0.02;
  block.motion.velocity = {0.001, 0};
  const PairLoad<2> f = block.press(law, 1);
  const Vector<2>& to_b = block.motion.to_b;
  CHECK((f.contact.torque_on_a() + f.contact.torque_on_b(to_b) + moment(to_b, f.contact.force))[0] ==
        Approx(0).margin(1e-15));
  CHECK(f.contact.point.x() == Approx((-1 * 5 + 1 * 10) / 15.0));
}
