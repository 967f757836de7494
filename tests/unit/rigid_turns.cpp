#include <cmath>

#include "catch.h"
#include "rotations.h"
#include "world_parts.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

constexpr double stiffness = 48, depth = 0.125, shear = 3;

ContactLaw law_of(StiffnessKind kind) {
  ContactLaw law;
  law.stiffness_kind = kind;
  law.normal_stiffness = law.shear_stiffness = stiffness;
  law.tan_friction = 10;
  return law;
}

/// Two cubes that overlap by the depth in x, pressed and sheared. One is tilted a little: of two flush faces
/// the contact face would depend on rounding.
template <int D>
struct Pressed : WorldParts<D> {
  Pressed(const ContactLaw& law, BlockKind of_first, BlockKind of_second) : WorldParts<D>(law) {
    this->add(cube<D>(), of_first, at<D>(3, 2));
    this->add(cube<D>(), of_second, at<D>(3 + 1 - depth, 2.25));
    Angular<D> tilt = Angular<D>::Zero();
    tilt[tilt.size() - 1] = 0.005;
    this->blocks.place(1, this->blocks.position[1], Rotation<D>().turned_by(tilt));
    this->list_neighbors();
    this->find_contacts();
    REQUIRE(this->contacts.count() == 1);
    const Vector<D> along = shear * Vector<D>::Unit(1);
    this->neighbors.shear()[0].force = shear_of(along, Vector<D>(Vector<D>::Unit(0)));
    this->neighbors.shear()[0].stiffness = preloaded;
    if constexpr (D == 3) this->neighbors.shear()[0].normal = Vector<3>::Unit(0);
  }

  /// Turns a block about a place, as a motion of the integrator does.
  void turn(std::size_t i, const Rotation<D>& by, const Angular<D>& angle, const Vector<D>& about,
            double duration) {
    Blocks<D>& blocks = this->blocks;
    const Vector<D> way = by * (blocks.position[i] - about) + about - blocks.position[i];
    blocks.set_motion(std::int32_t(i), way / duration, angle / duration);
    if (!blocks.is_affine(i)) return blocks.drift(std::int32_t(i), way, by * blocks.rotation[i], duration);
    Deformation<D>& deformation = blocks.deformation(i);
    deformation.rate = (by.tensor() * deformation.gradient - deformation.gradient) / duration;
    blocks.drift_affine(std::int32_t(i), way, duration);
  }
};

template <int D>
Angular<D> random_turn_by(double angle, Random& random) {
  if constexpr (D == 2) return Angular<2>(random.uniform(0, 1) < 0.5 ? angle : -angle);
  if constexpr (D == 3) return angle * random_direction(random);
}

template <int D>
void check_turn(StiffnessKind law, BlockKind first, BlockKind second, double angle, Random& random) {
  INFO("law " << int(law) << ", kinds " << int(first) << " " << int(second) << ", angle " << angle);
  Pressed<D> parts(law_of(law), first, second);
  parts.load_blocks();
  const Vector<D> force = parts.blocks.force[1];
  const Angular<D> torque = parts.blocks.torque[1];
  REQUIRE(parts.neighbors.shear()[0].force.norm() > 0.9 * shear);
  const double duration = 0.01;
  const Angular<D> turn = random_turn_by<D>(angle, random);
  const Rotation<D> by = Rotation<D>().turned_by(turn);
  for (const std::size_t i : {0, 1}) parts.turn(i, by, turn, at<D>(-5, 20), duration);
  parts.find_contacts();
  const ContactEnergy energy = parts.load_blocks(duration);
  const double rounding = 1e-11 * force.norm();
  CHECK((parts.blocks.force[1] - by * force).norm() <= rounding);
  if constexpr (D == 2) CHECK((parts.blocks.torque[1] - torque).norm() <= rounding);
  if constexpr (D == 3) CHECK((parts.blocks.torque[1] - by * torque).norm() <= rounding);
  CHECK(std::abs(energy.friction_loss) <= rounding);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("two blocks that turn as one have no relative motion", "", ((int D), D), 2, 3) {
  Random random(81);
  for (const StiffnessKind law :
       {StiffnessKind::per_contact, StiffnessKind::per_area, StiffnessKind::potential}) {
    for (const BlockKind first : {BlockKind::rigid, BlockKind::prescribed, BlockKind::affine}) {
      for (const BlockKind second : {BlockKind::rigid, BlockKind::affine}) {
        for (const double angle : {1e-6, 1e-2, 1.0}) check_turn<D>(law, first, second, angle, random);
      }
    }
  }
}
