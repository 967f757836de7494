// Cost of a step in settled scenes that a file holds, so that two builds of the library can be timed on the
// same state. `against` runs this in turn with each of them; README.md says how to read the figures.

#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "counting_memory.h"
#include "settled_scenes.h"
#include "timing.h"

namespace halfspace_benchmark {
namespace {

using halfspace_test::require_ok;

struct ShearForce {
  std::size_t a, b;  ///< blocks by their index
  Triple on_b;
};

/// A scene at rest.
struct Settled {
  Scene scene;
  double time_step = 0;        ///< 0 before it has settled
  std::vector<hs_pose> poses;  ///< of the centroids; none before it has settled
  std::vector<ShearForce> shear;
};

std::vector<Settled> loose_scenes(bool quick) {
  const int n = quick ? 3 : 10;
  std::vector<Settled> scenes;
  for (Scene& scene : std::vector{polygons(2 * n, 5 * n), bricks(5 * n, 2 * n, 0.5), cubes(5 * n, 2 * n, 0.5),
                                  polyhedra(n, n)})
    scenes.push_back({std::move(scene), 0, {}, {}});
  return scenes;
}

/// A scene's world.
struct Run {
  CountingMemory memory;
  halfspace_test::Context context;
  halfspace_test::World world;
  std::vector<hs_block> ids;

  explicit Run(const Settled& settled) {
    const hs_context_def context_def = memory.definition();
    context = halfspace_test::make_context(&context_def);
    const Scene& scene = settled.scene;
    world =
        make_world(context.get(), scene.dimension, settled.time_step, law_of(HS_STIFFNESS_PER_CONTACT, 1e7));
    for (std::size_t i = 0; i < scene.blocks.size(); ++i)
      ids.push_back(add_block(context.get(), world.get(), scene.dimension, scene.blocks[i],
                              settled.poses.empty() ? nullptr : &settled.poses[i]));
  }

  void check(hs_status status) const { require_ok(status, context.get()); }

  void step(std::int64_t steps) const { check(hs_world_step(world.get(), steps)); }

  hs_world_report report() const {
    hs_world_report report{};
    check(hs_world_get_report(world.get(), &report, sizeof report));
    return report;
  }
};

/// Lets a scene come to rest, and takes its state over.
void settle(Settled& scene, double time) {
  const Run run(scene);
  while (run.report().time < time) run.step(500);
  scene.time_step = run.report().time_step;
  std::map<hs_block, std::size_t> index;
  for (std::size_t i = 0; i < run.ids.size(); ++i) {
    hs_block_state state;
    run.check(hs_world_get_block_state(run.world.get(), run.ids[i], &state));
    scene.poses.push_back(state.pose);
    index[run.ids[i]] = i;
  }
  std::int64_t count = 0;
  (void)hs_world_get_contacts(run.world.get(), nullptr, 0, &count);  // which tells how many there are
  std::vector<hs_contact> contacts(static_cast<std::size_t>(count));
  run.check(hs_world_get_contacts(run.world.get(), contacts.data(), count, nullptr));
  for (const hs_contact& c : contacts)
    scene.shear.push_back(
        {index.at(c.block_a), index.at(c.block_b), {c.shear_force[0], c.shear_force[1], c.shear_force[2]}});
}

/// Puts shear forces back. A contact at the edge of touching may be gone; its spring bears nothing then.
void preload(const Run& run, const Settled& scene) {
  run.check(hs_world_detect(run.world.get(), nullptr));
  for (const ShearForce& shear : scene.shear) {
    const hs_status status =
        hs_world_set_shear_force(run.world.get(), run.ids[shear.a], run.ids[shear.b], shear.on_b.data());
    if (status != HS_ERROR_STALE_ID) run.check(status);
  }
}

void write(std::ostream& file, const Settled& settled) {
  const Scene& scene = settled.scene;
  file.precision(17);
  file << scene.name << ' ' << scene.dimension << ' ' << settled.time_step << ' ' << scene.blocks.size()
       << ' ' << settled.shear.size() << '\n';
  for (std::size_t i = 0; i < scene.blocks.size(); ++i) {
    const Block& block = scene.blocks[i];
    file << block.kind << ' ' << block.corners.size();
    for (const Triple& p : block.corners) file << ' ' << p[0] << ' ' << p[1] << ' ' << p[2];
    for (const double x : settled.poses[i].position) file << ' ' << x;
    for (const double x : settled.poses[i].rotation) file << ' ' << x;
    file << '\n';
  }
  for (const ShearForce& s : settled.shear)
    file << s.a << ' ' << s.b << ' ' << s.on_b[0] << ' ' << s.on_b[1] << ' ' << s.on_b[2] << '\n';
}

/// False at the end of the file.
bool read(std::istream& file, Settled& settled) {
  Scene& scene = settled.scene;
  std::size_t blocks = 0, shear = 0, corners = 0;
  if (!(file >> scene.name >> scene.dimension >> settled.time_step >> blocks >> shear)) return false;
  scene.blocks.resize(blocks);
  settled.poses.resize(blocks);
  settled.shear.resize(shear);
  for (std::size_t i = 0; i < blocks; ++i) {
    Block& block = scene.blocks[i];
    file >> block.kind >> corners;
    block.corners.resize(corners);
    for (Triple& p : block.corners) file >> p[0] >> p[1] >> p[2];
    for (double& x : settled.poses[i].position) file >> x;
    for (double& x : settled.poses[i].rotation) file >> x;
  }
  for (ShearForce& s : settled.shear) file >> s.a >> s.b >> s.on_b[0] >> s.on_b[1] >> s.on_b[2];
  if (!file) throw std::runtime_error("a scene is cut off");
  return true;
}

/// Prints a scene's line. `against` reads it.
void time_scene(const Settled& scene, int passes, double block_steps) {
  const Run run(scene);
  preload(run, scene);
  const double blocks = double(scene.poses.size());
  const auto steps = std::max<std::int64_t>(2, std::int64_t(block_steps / blocks));
  run.step(2 * steps);
  Passes timed;
  for (int i = 0; i < passes; ++i) timed.add(seconds_of([&] { run.step(steps); }));
  const double ns = 1e9 / (double(steps) * blocks);
  const hs_world_report report = run.report();
  std::printf("%-10s %7.0f %8.2f %8.1f %8.1f %8.0f %9.1e\n", scene.scene.name.c_str(), blocks,
              double(report.contact_count) / blocks, ns * timed.minimum(), ns * timed.median(),
              double(run.memory.peak()) / blocks, report.largest_speed);
  std::fflush(stdout);
}

/// The scenes that a file holds, or new ones, which it holds from then on.
std::vector<Settled> settled_scenes(const std::string& path, bool quick) {
  std::vector<Settled> scenes;
  std::ifstream kept(path);
  for (Settled scene; read(kept, scene);) scenes.push_back(scene);
  if (!scenes.empty()) return scenes;
  scenes = loose_scenes(quick);
  for (Settled& scene : scenes) settle(scene, quick ? 0.1 : 4);
  if (path.empty()) return scenes;
  std::ofstream file(path);
  for (const Settled& scene : scenes) write(file, scene);
  if (!file) throw std::runtime_error("cannot write " + path);
  return scenes;
}

void run(int argc, char** argv) {
  const bool quick = has_option(argc, argv, "--quick");
  const std::string path(option_value(argc, argv, "--keep", "")),
      only(option_value(argc, argv, "--only", ""));
  const std::vector<Settled> scenes = settled_scenes(path, quick);
  std::printf("libhalfspace %s, core %d\n", hs_version(), pin_to_this_core());
  std::printf("%-10s %7s %8s %8s %8s %8s %9s\n", "", "", "contacts", "ns/blk-stp", "", "B/block", "largest");
  std::printf("%-10s %7s %8s %8s %8s %8s %9s\n", "scene", "blocks", "a block", "min", "median", "peak",
              "speed m/s");
  for (const Settled& scene : scenes) {
    if (only.empty() || only == scene.scene.name) time_scene(scene, quick ? 1 : 8, quick ? 1e3 : 1e5);
  }
}

}  // namespace
}  // namespace halfspace_benchmark

int main(int argc, char** argv) {
  try {
    halfspace_benchmark::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_settled: %s\n", error.what());
    return 1;
  }
}
