#include "world/model/model.h"

#include "catch.h"
#include "world_parts.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

ContactLaw potential_law() {
  ContactLaw law;
  law.stiffness_kind = StiffnessKind::potential;
  return law;
}

/// Sides of 1, 3 and, in space, 5: their mean is 2, or 3.
template <int D>
Shape<D> brick() {
  if constexpr (D == 2) return cuboid<2>({1, 3});
  if constexpr (D == 3) return cuboid<3>({1, 3, 5});
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("H is the mean length of all edges when forces were first used", "", ((int D), D), 2,
                       3) {
  WorldParts<D> parts(potential_law());
  parts.add(brick<D>(), BlockKind::rigid, Vector<D>::Zero());
  CHECK(parts.model.potential_length() == Approx(D));
  const std::int32_t large = parts.add(cuboid<D>(Vector<D>::Constant(3 * D)), BlockKind::fixed, at<D>(50, 0));
  CHECK(parts.model.potential_length() == Approx(2 * D));
  parts.blocks.remove(large);
  CHECK(parts.model.potential_length() == Approx(D));
  parts.model.fix_potential_length();
  parts.add(cuboid<D>(Vector<D>::Constant(3 * D)), BlockKind::fixed, at<D>(50, 0));
  CHECK(parts.model.potential_length() == Approx(D));
}

TEST_CASE("a given H is taken, and without potentials none is fixed") {
  WorldSettings<2> settings;
  settings.potential_length = 7;
  WorldParts<2> given(potential_law(), settings), none{ContactLaw()};
  given.add(brick<2>(), BlockKind::rigid, {0, 0});
  CHECK(given.model.potential_length() == 7);
  none.add(brick<2>(), BlockKind::rigid, {0, 0});
  none.model.fix_potential_length();
  none.add(cuboid<2>({6, 6}), BlockKind::rigid, {50, 0});
  CHECK(none.model.potential_length() == Approx(4));
}

TEST_CASE("the law of two blocks is that of their materials") {
  WorldParts<2> parts{ContactLaw()};
  ContactLaw own;
  own.normal_stiffness = 5;
  parts.model.materials.add(1);
  parts.model.materials.laws().set(0, 1, own);
  for (const double x : {0, 2, 4}) parts.add(cube<2>(), BlockKind::rigid, {x, 0});
  parts.blocks.material[1] = 1;
  CHECK(parts.model.law_between(0, 1).normal_stiffness == 5);
  CHECK(parts.model.law_between(1, 2).normal_stiffness == 5);
  CHECK(parts.model.law_between(0, 2).normal_stiffness == ContactLaw().normal_stiffness);
}
