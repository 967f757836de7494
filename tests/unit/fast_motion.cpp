#include <cmath>

#include "catch.h"
#include "world/motion/continuous_collision.h"
#include "world_parts.h"

using namespace halfspace;
using namespace halfspace::test;

namespace {

constexpr double time_step = 0x1p-7, thickness = 0x1p-5, distance = 0.25;

/// A bar at a distance from a fixed plate as thin. It flies towards the plate, unless another direction is
/// given, by so many thicknesses a step. The motion of a step is predicted.
template <int D>
struct Flight : WorldParts<D> {
  double speed;

  explicit Flight(double thicknesses, const Vector<D>& direction = at<D>(-1, 0), double gap = distance)
      : WorldParts<D>(normal_spring(1)), speed(thicknesses * thickness / time_step) {
    Vector<D> sides = Vector<D>::Ones();
    sides[0] = thickness;
    this->add(cuboid<D>(sides), BlockKind::fixed, at<D>(0, 0));
    this->add(cuboid<D>(sides), BlockKind::rigid, at<D>(thickness + gap, 0), speed * direction);
    REQUIRE(this->clock.choose(time_step));
    this->list_neighbors();
    double noise = 0;
    this->fast_motion.note_speeds(this->integrator.begin(time_step, noise));
    REQUIRE(this->integrator.predict(time_step));
    if (this->neighbors.needs_rebuild()) this->list_neighbors();
    this->find_contacts();
  }
};

}  // namespace

TEMPLATE_TEST_CASE_SIG(
    "a bar is fast that may cross a plate in a step; one that cannot, or has none in its way, is not", "",
    ((int D), D), 2, 3) {
  for (const double thicknesses : {10.0, 100.0, 1e4}) CHECK(Flight<D>(thicknesses).fast_motion.any());
  CHECK_FALSE(Flight<D>(0.1).fast_motion.any());
  CHECK_FALSE(Flight<D>(1).fast_motion.any());  // the plate is too far for the list

  WorldParts<D> alone(normal_spring(1));
  alone.add(cube<D>(), BlockKind::rigid, at<D>(0, 0), at<D>(1e6, 0));
  REQUIRE(alone.clock.choose(time_step));
  alone.list_neighbors();
  double noise = 0;
  alone.fast_motion.note_speeds(alone.integrator.begin(time_step, noise));
  REQUIRE(alone.integrator.predict(time_step));
  CHECK_FALSE(alone.fast_motion.any());
}

TEMPLATE_TEST_CASE_SIG("a motion goes on until just before the first touch", "", ((int D), D), 2, 3) {
  for (const double thicknesses : {10.0, 100.0, 1e4}) {
    Flight<D> flight(thicknesses);
    const double motion = thicknesses * thickness;
    // An eighth of the thickness before: half of what is calm, so that the next part does not end beyond.
    CHECK(flight.fast_motion.safe_fraction() * motion == Approx(distance - thickness / 8));
    const FastPair& pair = flight.fast_motion.pair();
    CHECK(pair.a == 0);
    CHECK(pair.b == 1);
    CHECK(pair.speed == Approx(flight.speed));
    CHECK(pair.thickness == Approx(thickness));
    CHECK(pair.time_step == Approx(thickness / 4 / flight.speed));
  }
}

TEMPLATE_TEST_CASE_SIG("a motion past a plate, or away from it, is made at once however fast it is", "",
                       ((int D), D), 2, 3) {
  for (const Vector<D>& direction : {at<D>(1, 0), at<D>(0, 1)}) {
    Flight<D> flight(100, direction, thickness);
    CHECK(flight.fast_motion.any());
    CHECK(flight.fast_motion.safe_fraction() == 1);
    CHECK(flight.spring_stop.deepest() == 0);
  }
}

TEMPLATE_TEST_CASE_SIG(
    "the calm step is that in which the nearest pair closes by a quarter of the thinner one", "",
    ((int D), D), 2, 3) {
  Flight<D> flight(100);
  CHECK(flight.fast_motion.safe_time_step() == Approx(thickness / 4 / flight.speed));
  Flight<D> at_rest(0);
  CHECK(at_rest.fast_motion.safe_time_step() == HUGE_VAL);
}
