// A Box2D world with the half-space narrow phase against the same world with Box2D's own: steps, single pairs
// and wrong verdicts. README.md says what is timed and how to read the figures.

#include <box2d/box2d.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <halfspace/box2d.hpp>
#include <memory>

#include "box2d/world_fixture.h"
#include "box2d_scenes.h"
#include "timing.h"

namespace halfspace_benchmark {
namespace {

using halfspace::box2d::NarrowPhase;

/// A scene, with the half-space narrow phase or without.
class Contestant {
 public:
  Contestant(void (*build)(b2World&), bool by_halfspaces) : world_(new b2World({0, -10})) {
    if (by_halfspaces) narrow_phase_ = std::make_unique<NarrowPhase>(*world_);
    build(*world_);
    world_->SetAllowSleeping(false);
  }

  int contacts() const { return world_->GetContactCount(); }
  void step() { world_->Step(1 / 60.f, 8, 3); }

  void time_steps(int count) {
    steps_.add(seconds_of([&] {
                 for (int i = 0; i < count; ++i) step();
               }) /
               count);
  }

  /// After every step, which moves what moves, asks all contacts once.
  void time_pairs(int count) {
    double seconds = 0;
    long asked = 0;
    for (int i = 0; i < count; ++i) {
      step();
      seconds += seconds_of([&] { ask_all(); });
      asked += contacts();
    }
    pairs_.add(seconds / double(asked));
    step();  // the next to be timed finds everything moved again
  }

  const Passes& steps() const { return steps_; }
  const Passes& pairs() const { return pairs_; }

 private:
  void ask_all() {
    b2Manifold manifold;
    for (b2Contact* c = world_->GetContactList(); c; c = c->GetNext()) {
      if (c->GetFixtureA()->GetType() != b2Shape::e_polygon) continue;
      c->Evaluate(&manifold, c->GetFixtureA()->GetBody()->GetTransform(),
                  c->GetFixtureB()->GetBody()->GetTransform());
    }
  }

  std::unique_ptr<b2World> world_;
  std::unique_ptr<NarrowPhase> narrow_phase_;  // ends before its world
  Passes steps_;
  Passes pairs_;
};

void print_row(const char* name, double unit, const Passes& halfspace, const Passes& box2d) {
  std::printf("  %-22s %9.1f %9.1f %9.1f %9.1f %7.2f %7.2f\n", name, unit * halfspace.minimum(),
              unit * halfspace.median(), unit * box2d.minimum(), unit * box2d.median(),
              halfspace.minimum() / box2d.minimum(), halfspace.median() / box2d.median());
}

struct Scene {
  const char* name;
  void (*build)(b2World&);
};

void run(const Scene& scene, bool quick) {
  Contestant halfspace(scene.build, true), box2d(scene.build, false);
  const int settling = quick ? 10 : 300, passes = quick ? 2 : 40;
  for (int i = 0; i < settling; ++i) {
    halfspace.step();
    box2d.step();
  }
  for (int pass = 0; pass < passes; ++pass) {
    halfspace.time_steps(10);
    box2d.time_steps(10);
    halfspace.time_pairs(10);
    box2d.time_pairs(10);
  }
  std::printf("%s: %d and %d contacts\n", scene.name, halfspace.contacts(), box2d.contacts());
  print_row("world step, us", 1e6, halfspace.steps(), box2d.steps());
  print_row("narrow phase, ns/pair", 1e9, halfspace.pairs(), box2d.pairs());
}

/// Verdicts on pairs about the reach of their skins, off by 1e-9 to 1e-2 m to either side.
void count_wrong_verdicts(double from_origin, int pair_count) {
  using namespace halfspace_test;
  constexpr long double sure = 1e-13L;  // far above the rounding of the truth, far below that of floats
  Random random(1);
  int judged = 0, wrong = 0, wrong_of_box2d = 0;
  while (judged < pair_count) {
    const double off = std::pow(10, uniform(random, -9, -2));
    const PosedPolygons pair = draw_polygons(from_origin, radii + (judged % 2 ? off : -off), random);
    const FaceGap best = largest(face_gaps(pair));
    // Past the end of its face the manifold may be empty though no gap is.
    if (std::abs(best.gap - radii) < sure || best.beyond > 0) continue;
    const bool touching = best.gap <= radii;
    ++judged;
    wrong += touching != (manifold_of(pair, true).pointCount > 0);
    wrong_of_box2d += touching != (manifold_of(pair, false).pointCount > 0);
  }
  std::printf("  %8g m %9d %9d %9d\n", from_origin, judged, wrong, wrong_of_box2d);
}

void run_all(bool quick) {
  std::printf("%-24s %19s %19s %15s\n", "", "half-spaces", "Box2D", "ratio");
  std::printf("%-24s %9s %9s %9s %9s %7s %7s\n", "", "min", "median", "min", "median", "min", "median");
  for (const Scene& scene :
       {Scene{"pyramid of 20 rows, at rest", add_pyramid}, Scene{"drum of 300 polygons, tumbling", add_drum}})
    run(scene, quick);
  std::printf("wrong verdicts about the reach of the skins\n  %10s %9s %9s %9s\n", "at", "pairs", "halfsp.",
              "Box2D");
  for (const double from_origin : {0.0, 1e2, 1e3, 1e4})
    count_wrong_verdicts(from_origin, quick ? 100 : 10000);
}

}  // namespace
}  // namespace halfspace_benchmark

int main(int argc, char** argv) {
  using namespace halfspace_benchmark;
  std::printf("libhalfspace %s, Box2D " BOX2D_VERSION ", core %d\n", hs_version(), pin_to_this_core());
  try {
    run_all(has_option(argc, argv, "--quick"));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_box2d: %s\n", error.what());
    return 1;
  }
}
