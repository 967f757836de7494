// The program of one engine on walls and heaps of many blocks at steps of 1/60 s: `list` names its cases,
// `run N` prints the costs of one, how far the farthest block has moved, and how deep blocks overlap at the
// end. `walls_and_heaps` runs all and writes the tables.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "assembly.h"
#include "list_or_run.h"
#include "overlap.h"
#include "trial.h"

namespace halfspace_trade {
namespace {

constexpr double frame = 1.0 / 60;      // s
constexpr double enough_to_repeat = 3;  // s of processor time; longer passes are not repeated
constexpr int max_passes = 3;

struct Case {
  Assembly assembly;
  Setting setting;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Assembly& assembly : assemblies()) {
    if (!knows_dimension(assembly.scene.dimension) || (has_hulls(assembly) && !knows_hulls())) continue;
    for (const Setting& setting : settings())
      if (setting.indentation == 0 && setting.step == frame) all.push_back({assembly, setting});
  }
  return all;
}

void print_name(const Case& c) {
  std::printf("%s|%d|%s|%s", c.assembly.name.c_str(), c.assembly.scene.dimension, engine_name(),
              c.setting.way.c_str());
}

double distance(const Vector& p, const Vector& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

std::vector<Body> bodies_at(const Trial::Run& run, const Scene& scene) {
  std::vector<Body> bodies = scene.bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].is_fixed) continue;
    const State state = run.state(i);
    bodies[i].position = state.position;
    bodies[i].rotation = state.rotation;
  }
  return bodies;
}

double farthest_moved(const std::vector<Body>& from, const std::vector<Body>& to) {
  double farthest = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double moved = distance(from[i].position, to[i].position);
    if (!std::isfinite(moved)) return moved;
    farthest = std::max(farthest, moved);
  }
  return farthest;
}

void run(const Case& c) {
  const Scene& scene = c.assembly.scene;
  double before = HUGE_VAL, after = HUGE_VAL, spent = 0;  // s
  std::vector<Body> at_end;
  for (int pass = 0; pass < max_passes && spent < enough_to_repeat; ++pass) {
    Trial trial(c.setting);
    Trial::Run run = trial.start(scene);
    run.step(std::lround(c.assembly.divide / frame));
    const double until_divide = trial.cpu_seconds();
    run.finish();
    spent += trial.cpu_seconds();
    before = std::min(before, until_divide);
    after = std::min(after, trial.cpu_seconds() - until_divide);
    if (pass == 0) at_end = bodies_at(run, scene);
  }
  double blocks = 0;
  for (const Body& body : scene.bodies) blocks += !body.is_fixed;
  const auto per_block_and_step = [&](double seconds, double simulated) {
    return 1e6 * seconds * frame / simulated / blocks;
  };
  print_name(c);
  std::printf("|%.3g|%.3g|%.2g|%.2g\n", per_block_and_step(before, c.assembly.divide),
              per_block_and_step(after, scene.duration - c.assembly.divide),
              farthest_moved(scene.bodies, at_end), mean_overlap(at_end, scene.dimension));
}

}  // namespace
}  // namespace halfspace_trade

int main(int argc, char** argv) {
  using namespace halfspace_trade;
  return list_or_run(argc, argv, cases, print_name, run);
}
