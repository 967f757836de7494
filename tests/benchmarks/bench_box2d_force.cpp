// Force mode in a Box2D world against Box2D's own solver: errors against closed forms, and the time of a
// step. README.md says what is measured and how to read the figures.

#include <box2d/box2d.h>

#include <cmath>
#include <cstdio>
#include <exception>

#include "box2d/force_scenes.h"
#include "box2d_comparison/forces.h"
#include "box2d_scenes.h"
#include "timing.h"

namespace halfspace_benchmark {
namespace {

using namespace halfspace_test;

constexpr double stiffnesses[] = {1e5, 1e6, 1e7};

/// The end of a headline.
void print_stiffnesses() {
  for (const double stiffness : stiffnesses) std::printf("  %7.0e N/m", stiffness);
  std::printf("\n");
}

void print_slides() {
  std::printf("slide of 1 s, relative error\n  %10s %11s", "slope", "Box2D");
  print_stiffnesses();
  for (const double degrees : {15., 30., 45.}) {
    const double slope = degrees * pi / 180, friction = 0.2;
    const auto print_error = [&](const std::optional<hs_law_def>& law) {
      const Slide slide = slide_down(law, slope, friction);
      std::printf(" %11.1e", slide.distance / slide.expected - 1);
    };
    std::printf("  %6.0f deg", degrees);
    print_error({});
    for (const double stiffness : stiffnesses) print_error(law_of(stiffness, 1));
    std::printf("\n");
  }
}

constexpr float creep_slope = float(pi / 6);

using Creep = double(const std::optional<hs_law_def>& law, int height, float slope, float friction);

void print_creep(const char* begin, Creep& creep, float over_slope) {
  const float friction = over_slope * std::tan(creep_slope);
  for (const int height : {1, 3, 5}) {
    std::printf("  %-10s %6d %20g %11.1e", begin, height, over_slope,
                creep({}, height, creep_slope, friction));
    for (const double stiffness : stiffnesses)
      std::printf("  %11.1e",
                  creep(box2d_comparison::law_of_forces(stiffness), height, creep_slope, friction));
    std::printf("\n");
  }
}

void print_creep() {
  std::printf("creep in 5 s, m\n  %-10s %6s %20s %11s", "", "boxes", "friction over slope", "Box2D");
  print_stiffnesses();
  print_creep("let go", creep_let_go, 1);
  print_creep("let go", creep_let_go, 1.01f);
  print_creep("settled", creep_settled, 1);
}

void print_bounces() {
  std::printf("speed after an undamped bounce at 1 m/s\n");
  for (const int over : {1, 2, 4, 8}) {
    const Bounce bounce = bounce_head_on(1e5, over, false);
    std::printf("  omega h %6.4f %9.6f\n", bounce.omega_h, bounce.speed);
  }
}

/// A sub-step of force mode against a step of Box2D's, of the pyramid as it comes to rest.
void print_times(bool quick) {
  ForceWorld by_forces(law_of(1e6, 0.3)), by_box2d({});
  Passes sub_steps, steps;
  for (ForceWorld* arena : {&by_forces, &by_box2d}) {
    add_pyramid(arena->world);
    arena->world.SetAllowSleeping(false);
    arena->step(quick ? 1 : 30);
  }
  const int count = by_forces.sub_steps();
  for (int pass = 0; pass < (quick ? 2 : 20); ++pass) {
    sub_steps.add(seconds_of([&] { by_forces.step(); }) / count);
    steps.add(seconds_of([&] { by_box2d.step(10); }) / 10);
  }
  std::printf("pyramid of 20 rows, %d sub-steps a step\n", count);
  std::printf("  sub-step %.1f us, Box2D's step %.1f us, ratio %.2f (minima)\n", 1e6 * sub_steps.minimum(),
              1e6 * steps.minimum(), sub_steps.minimum() / steps.minimum());
}

}  // namespace
}  // namespace halfspace_benchmark

int main(int argc, char** argv) {
  using namespace halfspace_benchmark;
  std::printf("libhalfspace %s, Box2D " BOX2D_VERSION ", core %d\n", hs_version(), pin_to_this_core());
  try {
    const bool quick = has_option(argc, argv, "--quick");
    print_times(quick);
    print_bounces();
    if (quick) return 0;
    print_slides();
    print_creep();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_box2d_force: %s\n", error.what());
    return 1;
  }
}
