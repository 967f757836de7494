// Cost of a step in settled scenes that a file holds, so that two builds of the library can be timed on the
// same state. `against` runs this in turn with each of them; README.md says how to read the figures.

#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>

#include "counting_memory.h"
#include "random_polygon.h"
#include "random_polyhedron.h"
#include "timing.h"

namespace halfspace_benchmark {
namespace {

using halfspace_test::require_ok;
using halfspace_test::Shape;

struct Block {
  std::int32_t kind;
  Corners corners;
  hs_pose pose;  ///< of the centroid
};

struct ShearForce {
  std::size_t a, b;  ///< blocks by their index
  Triple on_b;
};

struct Scene {
  std::string name;
  int dimension = 2;
  double time_step =
      0;  ///< 0 before it has settled: poses are then unknown, and blocks where their corners are
  std::vector<Block> blocks;
  std::vector<ShearForce> shear;

  void add(std::int32_t kind, const Corners& corners) { blocks.push_back({kind, corners, {}}); }
};

Corners box_of(int dimension, const Triple& lower, const Triple& upper) {
  if (dimension == 2)
    return {
        {lower[0], lower[1], 0}, {upper[0], lower[1], 0}, {upper[0], upper[1], 0}, {lower[0], upper[1], 0}};
  Corners corners;
  for (int k = 0; k < 8; ++k)
    corners.push_back(
        {k & 1 ? upper[0] : lower[0], k & 2 ? upper[1] : lower[1], k & 4 ? upper[2] : lower[2]});
  return corners;
}

/// Polygons of 3 to 8 vertices in a bin.
Scene polygons(int columns, int rows) {
  constexpr double radius = 0.0115, pitch = 2.1 * radius, wall = 0.01;
  const double width = columns * pitch, height = rows * pitch;
  Scene scene{"polygons", 2, 0, {}, {}};
  scene.add(HS_BLOCK_FIXED, box_of(2, {-wall, -wall, 0}, {width + wall, 0, 0}));
  scene.add(HS_BLOCK_FIXED, box_of(2, {-wall, 0, 0}, {0, height, 0}));
  scene.add(HS_BLOCK_FIXED, box_of(2, {width, 0, 0}, {width + wall, height, 0}));
  Random random(1);
  for (int i = 0; i < columns * rows; ++i) {
    const Point center{(i % columns + 0.5) * pitch, (i / columns + 0.5) * pitch};
    Corners corners;
    for (const Point& p : random_polygon(3 + i % 6, radius, random))
      corners.push_back({center.x + p.x, center.y + p.y, 0});
    scene.add(HS_BLOCK_RIGID, corners);
  }
  return scene;
}

/// Courses of blocks on a floor, every other one shifted by half a block.
Scene wall(const char* name, int dimension, const Triple& size, int columns, int courses) {
  const int up = dimension - 1;
  const double pitch = 1.001 * size[0];
  Scene scene{name, dimension, 0, {}, {}};
  Triple lower{-size[0], -size[1], 0}, upper{(columns + 1) * pitch, 2 * size[1], 0};
  lower[std::size_t(up)] = -1;
  upper[std::size_t(up)] = 0;
  scene.add(HS_BLOCK_FIXED, box_of(dimension, lower, upper));
  for (int i = 0; i < columns * courses; ++i) {
    const int course = i / columns;
    Triple low{(i % columns + 0.5 * (course % 2)) * pitch, 0, 0};
    low[std::size_t(up)] = course * size[std::size_t(up)];
    scene.add(HS_BLOCK_RIGID, box_of(dimension, low, {low[0] + size[0], low[1] + size[1], low[2] + size[2]}));
  }
  return scene;
}

/// Polyhedra of 12 to 20 vertices in a box without a lid.
Scene polyhedra(int side, int layers) {
  const double width = side, height = 1.2 * layers;
  Scene scene{"polyhedra", 3, 0, {}, {}};
  const auto fixed = [&](const Triple& lower, const Triple& upper) {
    scene.add(HS_BLOCK_FIXED, box_of(3, lower, upper));
  };
  fixed({-0.5, -0.5, -1}, {width + 0.5, width + 0.5, 0});
  fixed({-0.5, -0.5, 0}, {0, width + 0.5, height});
  fixed({width, -0.5, 0}, {width + 0.5, width + 0.5, height});
  fixed({0, -0.5, 0}, {width, 0, height});
  fixed({0, width, 0}, {width, width + 0.5, height});
  std::mt19937_64 random(1);
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        Corners corners = random_corners(random);
        for (Triple& p : corners) p = {p[0] + i + 0.5, p[1] + j + 0.5, p[2] + 1.05 * k + 0.55};
        scene.add(HS_BLOCK_RIGID, corners);
      }
  return scene;
}

std::vector<Scene> loose_scenes(bool quick) {
  const int n = quick ? 3 : 10;
  return {polygons(2 * n, 5 * n), wall("bricks", 2, {0.2, 0.1, 0}, 5 * n, 2 * n),
          wall("cubes", 3, {0.2, 0.2, 0.2}, 5 * n, 2 * n), polyhedra(n, n)};
}

/// A scene's world. Arguments that another release of the library may have other defaults for are given.
struct Run {
  CountingMemory memory;
  halfspace_test::Context context;
  halfspace_test::World world;
  std::vector<hs_block> ids;

  explicit Run(const Scene& scene) {
    const hs_context_def context_def = memory.definition();
    context = halfspace_test::make_context(&context_def);
    hs_world_def def{};
    check(hs_world_def_init(&def, sizeof def, scene.dimension));
    def.dimension = scene.dimension;
    def.gravity[0] = def.gravity[1] = def.gravity[2] = 0;
    def.gravity[scene.dimension - 1] = -9.81;
    def.time_step = scene.time_step;
    def.local_damping = 0.3;
    hs_world* made = nullptr;
    check(hs_world_create(context.get(), &def, &made));
    world.reset(made);
    hs_law_def law{};
    check(hs_law_def_init(&law, sizeof law));
    law.normal_stiffness = law.shear_stiffness = 1e7;
    law.friction_angle = 0.45;
    law.normal_damping = law.shear_damping = 0.2;
    check(hs_world_set_default_law(made, &law));
    std::int32_t material = 0;
    check(hs_world_add_material(made, 2500, &material));
    for (const Block& block : scene.blocks) add(block, scene);
  }

  void check(hs_status status) const { require_ok(status, context.get()); }

  void add(const Block& block, const Scene& scene) {
    hs_shape* made = nullptr;
    check(scene.dimension == 2 ? hs_polygon_create(context.get(), view_of(block.corners), &made)
                               : hs_polyhedron_create_hull(context.get(), view_of(block.corners), &made));
    const Shape shape(made);
    hs_block_def def{};
    check(hs_block_def_init(&def, sizeof def, shape.get()));
    def.kind = block.kind;
    if (scene.time_step > 0) def.pose = block.pose;
    hs_block id = 0;
    check(hs_world_add_block(world.get(), shape.get(), &def, &id));
    ids.push_back(id);
  }

  void step(std::int64_t steps) const { check(hs_world_step(world.get(), steps)); }

  hs_world_report report() const {
    hs_world_report report{};
    check(hs_world_get_report(world.get(), &report, sizeof report));
    return report;
  }
};

/// Lets a scene come to rest, and takes its state over.
void settle(Scene& scene, double time) {
  const Run run(scene);
  while (run.report().time < time) run.step(500);
  scene.time_step = run.report().time_step;
  std::map<hs_block, std::size_t> index;
  for (std::size_t i = 0; i < run.ids.size(); ++i) {
    hs_block_state state;
    run.check(hs_world_get_block_state(run.world.get(), run.ids[i], &state));
    scene.blocks[i].pose = state.pose;
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
void preload(const Run& run, const Scene& scene) {
  run.check(hs_world_detect(run.world.get(), nullptr));
  for (const ShearForce& shear : scene.shear) {
    const hs_status status =
        hs_world_set_shear_force(run.world.get(), run.ids[shear.a], run.ids[shear.b], shear.on_b.data());
    if (status != HS_ERROR_STALE_ID) run.check(status);
  }
}

void write(std::ostream& file, const Scene& scene) {
  file.precision(17);
  file << scene.name << ' ' << scene.dimension << ' ' << scene.time_step << ' ' << scene.blocks.size() << ' '
       << scene.shear.size() << '\n';
  for (const Block& block : scene.blocks) {
    file << block.kind << ' ' << block.corners.size();
    for (const Triple& p : block.corners) file << ' ' << p[0] << ' ' << p[1] << ' ' << p[2];
    for (const double x : block.pose.position) file << ' ' << x;
    for (const double x : block.pose.rotation) file << ' ' << x;
    file << '\n';
  }
  for (const ShearForce& s : scene.shear)
    file << s.a << ' ' << s.b << ' ' << s.on_b[0] << ' ' << s.on_b[1] << ' ' << s.on_b[2] << '\n';
}

/// False at the end of the file.
bool read(std::istream& file, Scene& scene) {
  std::size_t blocks = 0, shear = 0, corners = 0;
  if (!(file >> scene.name >> scene.dimension >> scene.time_step >> blocks >> shear)) return false;
  scene.blocks.resize(blocks);
  scene.shear.resize(shear);
  for (Block& block : scene.blocks) {
    file >> block.kind >> corners;
    block.corners.resize(corners);
    for (Triple& p : block.corners) file >> p[0] >> p[1] >> p[2];
    for (double& x : block.pose.position) file >> x;
    for (double& x : block.pose.rotation) file >> x;
  }
  for (ShearForce& s : scene.shear) file >> s.a >> s.b >> s.on_b[0] >> s.on_b[1] >> s.on_b[2];
  if (!file) throw std::runtime_error("a scene is cut off");
  return true;
}

/// Prints a scene's line. `against` reads it.
void time_scene(const Scene& scene, int passes, double block_steps) {
  const Run run(scene);
  preload(run, scene);
  const double blocks = double(scene.blocks.size());
  const auto steps = std::max<std::int64_t>(2, std::int64_t(block_steps / blocks));
  run.step(2 * steps);
  Passes timed;
  for (int i = 0; i < passes; ++i) timed.add(seconds_of([&] { run.step(steps); }));
  const double ns = 1e9 / (double(steps) * blocks);
  const hs_world_report report = run.report();
  std::printf("%-10s %7.0f %8.2f %8.1f %8.1f %8.0f %9.1e\n", scene.name.c_str(), blocks,
              double(report.contact_count) / blocks, ns * timed.minimum(), ns * timed.median(),
              double(run.memory.peak()) / blocks, report.largest_speed);
  std::fflush(stdout);
}

/// The scenes that a file holds, or new ones, which it holds from then on.
std::vector<Scene> settled_scenes(const std::string& path, bool quick) {
  std::vector<Scene> scenes;
  std::ifstream kept(path);
  for (Scene scene; read(kept, scene);) scenes.push_back(scene);
  if (!scenes.empty()) return scenes;
  scenes = loose_scenes(quick);
  for (Scene& scene : scenes) settle(scene, quick ? 0.1 : 4);
  if (path.empty()) return scenes;
  std::ofstream file(path);
  for (const Scene& scene : scenes) write(file, scene);
  if (!file) throw std::runtime_error("cannot write " + path);
  return scenes;
}

void run(int argc, char** argv) {
  const bool quick = has_option(argc, argv, "--quick");
  const std::string path(option_value(argc, argv, "--keep", "")),
      only(option_value(argc, argv, "--only", ""));
  const std::vector<Scene> scenes = settled_scenes(path, quick);
  std::printf("libhalfspace %s, core %d\n", hs_version(), pin_to_this_core());
  std::printf("%-10s %7s %8s %8s %8s %8s %9s\n", "", "", "contacts", "ns/blk-stp", "", "B/block", "largest");
  std::printf("%-10s %7s %8s %8s %8s %8s %9s\n", "scene", "blocks", "a block", "min", "median", "peak",
              "speed m/s");
  for (const Scene& scene : scenes) {
    if (only.empty() || only == scene.name) time_scene(scene, quick ? 1 : 8, quick ? 1e3 : 1e5);
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
