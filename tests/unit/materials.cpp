#include "world/model/materials.h"

#include "catch.h"

using namespace halfspace;

TEST_CASE("two materials have the law that was set for them, in either order, and others the default") {
  Materials materials(std::pmr::get_default_resource());
  for (const double density : {1000, 2000, 3000}) materials.add(density);
  ContactLaw own, common;
  own.normal_stiffness = 5;
  common.normal_stiffness = 7;
  materials.laws().set(2, 1, own);
  materials.laws().set_default(common);
  CHECK(materials.add(4000) == 3);  // with the default law, also against those before
  REQUIRE(materials.count() == 4);
  for (std::int32_t a = 0; a < 4; ++a) {
    CHECK(materials.density(a) == 1000 * (a + 1));
    for (std::int32_t b = 0; b < 4; ++b) {
      const bool is_set = (a == 1 && b == 2) || (a == 2 && b == 1);
      CHECK(materials.laws().between(a, b).normal_stiffness == (is_set ? 5 : 7));
    }
  }
}

TEST_CASE("a material is as elastic as it was made, and no other with it") {
  Materials materials(std::pmr::get_default_resource());
  materials.add(1);
  materials.add(1);
  Elasticity stiff;
  stiff.shear_modulus = 3;
  materials.set_elasticity(1, stiff);
  CHECK(materials.elasticity(0).shear_modulus == Elasticity().shear_modulus);
  CHECK(materials.elasticity(1).shear_modulus == 3);
}

TEST_CASE("materials of which a density is no positive number are found out") {
  for (const double density : {0.0, -1.0, HUGE_VAL}) {
    Materials materials(std::pmr::get_default_resource());
    materials.add(1);
    CHECK(materials.is_consistent());
    materials.add(density);
    CHECK_FALSE(materials.is_consistent());
  }
}
