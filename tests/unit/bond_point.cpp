// One point of a bond: the tractions that it bears, and what becomes of it.

#include "block/bond/bond_point.h"

#include "catch.h"

namespace {

using namespace halfspace;

constexpr double stiffness = 1e9;

BondLaw brittle() {
  BondLaw law;
  law.normal_stiffness = law.shear_stiffness = stiffness;
  law.tensile_strength = 1e5;
  law.cohesion = 2e5;
  law.tan_friction = 0.5;
  law.residual_tan_friction = 0.25;
  return law;
}

/// A point that is moved by and by, as a bond moves it.
struct Mover {
  BondLaw law;
  BondPoint<2> point{};
  Vector<2> slid = Vector<2>::Zero();
  double lost = 0;
  double rubbed = 0;
  bool is_held = false;

  BondTraction<2> to(double opening, double slip) {
    Vector<2> yielded;
    const Vector<2> way(slip, 0);
    const BondTraction<2> traction = traction_of<2>(law, opening, way - slid, is_held, point, yielded);
    slid += yielded;
    point.normal_traction = traction.normal;
    point.shear = -traction.shear;
    lost += traction.fracture_loss;
    rubbed += traction.friction_loss;
    return traction;
  }
};

}  // namespace

TEST_CASE("a brittle point fails by tension at its strength, and loses what its springs held", "[bonds]") {
  Mover mover{brittle()};
  CHECK(mover.to(0.999e-4, 0).normal == Approx(0.999e5));
  CHECK(mover.lost == 0);
  const BondTraction<2> broken = mover.to(1.001e-4, 0);
  CHECK(broken.breaks);
  CHECK(broken.normal == 0);
  CHECK(mover.point.failure == BondFailure::tension);
  CHECK(mover.lost == Approx(0.5 * 1.001e5 * 1.001e-4));
  CHECK(mover.to(-1e-5, 0).normal == Approx(-1e4));  // pressed again
  CHECK_FALSE(mover.to(1e-5, 0).breaks);
}

TEST_CASE("a point under pressure fails by shear and lands on its residual strength", "[bonds]") {
  Mover mover{brittle()};
  const double pressure = 1e5, peak = 2e5 + 0.5 * pressure;
  CHECK(mover.to(-1e-4, 0.999 * peak / stiffness).shear.x() == Approx(0.999 * peak));
  const BondTraction<2> broken = mover.to(-1e-4, 1.001 * peak / stiffness);
  CHECK(broken.breaks);
  CHECK(mover.point.failure == BondFailure::shear);
  CHECK(broken.normal == Approx(-pressure));
  CHECK(broken.shear.x() == Approx(0.25 * pressure));
  CHECK(mover.to(-1e-4, 2e-3).shear.x() == Approx(0.25 * pressure));
  CHECK(mover.rubbed == Approx(0.25 * pressure * (2e-3 - 1.001 * peak / stiffness)).epsilon(1e-9));
  CHECK(mover.to(1e-6, 2e-3).shear.x() == 0);
}

TEST_CASE("a held point does not fail, and one that has failed is not revived by holding", "[bonds]") {
  Mover mover{brittle()};
  mover.is_held = true;
  CHECK(mover.to(5e-4, 1e-3).normal == Approx(5e5));
  CHECK_FALSE(mover.point.is_broken());
  mover.is_held = false;
  CHECK(mover.to(5e-4, 1e-3).breaks);
  mover.is_held = true;
  CHECK(mover.to(-1e-4, 1e-3).shear.norm() <= 0.25 * 1e5 * (1 + 1e-12));
  CHECK(mover.to(1e-4, 2e-3).shear.norm() == 0);
}

TEST_CASE("strength that fades comes back along the line to the origin", "[bonds]") {
  BondLaw law = brittle();
  law.tensile_fracture_energy = 40;  // opens to 1e-4 + 8e-4
  Mover mover{law};
  CHECK(mover.to(5e-4, 0).normal == Approx(0.5e5));
  CHECK(mover.point.damage == Approx(0.5));
  CHECK(mover.to(2.5e-4, 0).normal == Approx(0.25e5));
  CHECK(mover.to(5e-4, 0).normal == Approx(0.5e5));
  CHECK(mover.point.damage == Approx(0.5));
  CHECK(mover.to(9.001e-4, 0).breaks);
  law.tensile_strength = 0;
  Mover weak{law};
  CHECK(weak.to(1e-9, 0).breaks);  // no strength to fade
}
