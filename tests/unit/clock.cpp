#include "world/motion/clock.h"

#include <limits>

#include "catch.h"

using namespace halfspace;

TEST_CASE("time gathers no rounding over a million steps") {
  Clock clock;
  REQUIRE(clock.choose(0.1));
  for (int i = 0; i < 1000000; ++i) clock.complete_step();
  CHECK(clock.time() == 1e5);  // summed step by step it is off by 1.3e-6
  CHECK(clock.steps() == 1000000);
  CHECK(clock.divided_steps() == 0);
}

TEST_CASE("a step of another length begins where time has come to, in the middle of a step too") {
  Clock clock;
  REQUIRE(clock.choose(0.25));
  for (int i = 0; i < 4; ++i) clock.complete_step();
  clock.pass_part(0.125);
  REQUIRE(clock.choose(0.25));  // as before: the step goes on
  CHECK(clock.time() == 1.125);
  CHECK(clock.rest() == 0.125);
  REQUIRE(clock.choose(0.5));
  CHECK(clock.time() == 1.125);
  CHECK(clock.rest() == 0.5);
  clock.complete_step();
  CHECK(clock.time() == 1.625);
  CHECK(clock.steps() == 5);
}

TEST_CASE("a step in parts is as long as a whole one, and counts once as divided") {
  Clock clock;
  REQUIRE(clock.choose(0.1));
  for (int step = 0; step < 1000; ++step) {
    for (int part = 1; part < 10; ++part) {
      clock.pass_part(0.01);
      CHECK(clock.time() == Approx(0.1 * step + 0.01 * part));
      CHECK(clock.rest() == Approx(0.1 - 0.01 * part));
    }
    clock.complete_step();
  }
  CHECK(clock.time() == 1000 * 0.1);
  CHECK(clock.divided_steps() == 1000);
}

TEST_CASE("what is no step is refused, and changes nothing") {
  Clock clock;
  REQUIRE(clock.choose(0.25));
  clock.complete_step();
  for (const double none :
       {0.0, -0.25, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    CHECK_FALSE(clock.choose(none));
    CHECK(clock.time_step() == 0.25);
    CHECK(clock.time() == 0.25);
  }
}
