// Cost of a step of settled random polyhedra of 12 to 20 vertices, in one bin and in bins side by side.
// README.md says what is timed and how to read the figures; yade_polyhedra.py times YADE on the same bin.

#include <cstdio>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>

#include "capi/handles.h"
#include "counting_memory.h"
#include "random_polyhedron.h"
#include "timing.h"

namespace halfspace_benchmark {
namespace {

using halfspace_test::require_ok;

constexpr int passes = 5;
constexpr double density = 2500;
constexpr double pitch = 1;  // of the grid that they are dropped from: their diameter

struct Extent {
  int columns, rows, layers;  // of the grid
  double settling_time;       // s
  int bins;                   // in the large world
  double block_steps;         // of each world in a pass
};

Corners cuboid(const Triple& lower, const Triple& upper) {
  Corners corners;
  for (int k = 0; k < 8; ++k)
    corners.push_back(
        {k & 1 ? upper[0] : lower[0], k & 2 ? upper[1] : lower[1], k & 4 ? upper[2] : lower[2]});
  return corners;
}

/// Polyhedra in a box without a lid that stands on z = 0, one corner of its floor at the origin.
struct Bin {
  double width, depth, height;
  std::vector<Corners> grains;
  std::vector<hs_pose> poses;
};

struct Heap {
  CountingMemory memory;
  halfspace_test::Context context;
  halfspace_test::World world;
  std::vector<hs_block> grains;

  explicit Heap(double time_step, int threads = 1) {
    hs_context_def context_def = memory.definition();
    context_def.threads = threads;
    context = halfspace_test::make_context(&context_def);
    hs_world_def def;
    hs_world_def_init(&def, sizeof def, 3);
    def.time_step = time_step;
    def.local_damping = 0.2;
    hs_world* made = nullptr;
    check(hs_world_create(context.get(), &def, &made));
    world.reset(made);
    hs_law_def law;
    hs_law_def_init(&law, sizeof law);
    law.normal_stiffness = law.shear_stiffness = 1e7;
    law.friction_angle = 0.5;
    law.normal_damping = 0.2;
    law.shear_damping = 0;
    check(hs_world_set_default_law(made, &law));
    int32_t material = 0;
    check(hs_world_add_material(made, density, &material));
  }

  void check(hs_status status) const { require_ok(status, context.get()); }

  hs_block add(const Corners& corners, int32_t kind, const hs_pose* pose) {
    const halfspace_test::Shape shape = hull(context.get(), corners);
    hs_block_def def;
    check(hs_block_def_init(&def, sizeof def, shape.get()));
    def.kind = kind;
    if (pose) def.pose = *pose;
    hs_block block = 0;
    check(hs_world_add_block(world.get(), shape.get(), &def, &block));
    return block;
  }

  /// A bin moved along x.
  void add_bin(const Bin& bin, double x) {
    const double w = bin.width, d = bin.depth, h = bin.height;
    const auto wall = [&](const Triple& lower, const Triple& upper) {
      add(cuboid({x + lower[0], lower[1], lower[2]}, {x + upper[0], upper[1], upper[2]}), HS_BLOCK_FIXED,
          nullptr);
    };
    wall({-0.5, -0.5, -1}, {w + 0.5, d + 0.5, 0});
    wall({-0.5, -0.5, 0}, {0, d + 0.5, h});
    wall({w, -0.5, 0}, {w + 0.5, d + 0.5, h});
    wall({0, -0.5, 0}, {w, 0, h});
    wall({0, d, 0}, {w, d + 0.5, h});
    for (std::size_t i = 0; i < bin.grains.size(); ++i) {
      hs_pose pose = bin.poses[i];
      pose.position[0] += x;
      grains.push_back(add(bin.grains[i], HS_BLOCK_RIGID, &pose));
    }
  }

  void step(std::int64_t steps) const { check(hs_world_step(world.get(), steps)); }

  /// Contacts are described and loaded once more.
  void evaluate_forces() const {
    const hs_status status = hs_world_forces(world.get(), 0, {}, {});
    if (status != HS_NOTE_TRUNCATED) check(status);
  }

  hs_world_report report() const {
    hs_world_report report;
    check(hs_world_get_report(world.get(), &report, sizeof report));
    return report;
  }
};

Bin settled_bin(const Extent& extent) {
  std::mt19937_64 random(1);
  Bin bin{extent.columns * pitch, extent.rows * pitch, 1.2 * extent.layers * pitch, {}, {}};
  for (int k = 0; k < extent.layers; ++k)
    for (int j = 0; j < extent.rows; ++j)
      for (int i = 0; i < extent.columns; ++i) {
        bin.grains.push_back(random_corners(random));
        bin.poses.push_back(
            {{(i + 0.5) * pitch, (j + 0.5) * pitch, (1.05 * k + 0.55) * pitch}, {0, 0, 0, 1}});
      }
  Heap heap(0);
  heap.add_bin(bin, 0);
  while (heap.report().time < extent.settling_time) heap.step(500);
  for (std::size_t i = 0; i < bin.grains.size(); ++i) {
    hs_block_state state;
    heap.check(hs_world_get_block_state(heap.world.get(), heap.grains[i], &state));
    bin.poses[i] = state.pose;
  }
  std::printf("%zu polyhedra settled for %.1f s, left with at most %.1e m/s\n", bin.grains.size(),
              heap.report().time, heap.report().largest_speed);
  return bin;
}

/// The bin as text: width, depth and height, then a line for each polyhedron: the corners where they are.
void write(const Bin& bin, const std::string& path) {
  std::ofstream file(path);
  file.precision(17);
  file << bin.width << ' ' << bin.depth << ' ' << bin.height << '\n';
  Heap heap(0);
  heap.add_bin(bin, 0);
  for (const hs_block grain : heap.grains) {
    Corners corners(64);
    std::int64_t count = 0;
    heap.check(hs_world_get_block_vertices(
        heap.world.get(), grain, {&corners[0][0], &corners[0][1], &corners[0][2], sizeof(Triple), 64},
        &count));
    for (std::int64_t i = 0; i < count; ++i)
      for (const double x : corners[std::size_t(i)]) file << x << ' ';
    file << '\n';
  }
  if (!file) throw std::runtime_error("cannot write " + path);
}

void compare_threads(const Bin& bin, int bins, const Extent& extent, int threads) {
  Heap one(0), several(0, threads);
  for (Heap* heap : {&one, &several})
    for (int i = 0; i < bins; ++i) heap->add_bin(bin, i * (bin.width + 2));
  const double blocks = double(one.grains.size());
  const int steps = std::max(2, int(extent.block_steps / blocks));
  one.step(std::max(steps, 200));
  several.step(std::max(steps, 200));
  print_speed_up(
      blocks, "blocks", threads, passes, [&] { one.step(steps); }, [&] { several.step(steps); });
}

void time_steps(const Bin& bin, int bins, const Extent& extent) {
  Heap heap(0);
  for (int i = 0; i < bins; ++i) heap.add_bin(bin, i * (bin.width + 2));
  const double blocks = double(heap.grains.size());
  const int steps = std::max(2, int(extent.block_steps / blocks));
  heap.step(std::max(steps, 200));
  const hs_world_report before = heap.report();
  const std::int64_t allocations_before = heap.memory.allocations();
  Passes timed;
  for (int i = 0; i < passes; ++i) timed.add(seconds_of([&] { heap.step(steps); }));
  const std::int64_t allocations = heap.memory.allocations() - allocations_before;
  const hs_world_report after = heap.report();
  Passes forces;
  for (int i = 0; i < passes; ++i) forces.add(seconds_of([&] { heap.evaluate_forces(); }));
  const double least = 1e9 * timed.minimum() / (steps * blocks);
  std::printf(
      "%8.0f blocks: %8.1f ns a block-step (median %.1f), %.3f million block-steps/s; contacts %.2f and "
      "candidates %.2f a block, %.0f B held a block, %lld allocations, %lld list builds, largest speed "
      "%.1e m/s\n",
      blocks, least, 1e9 * timed.median() / (steps * blocks), 1e3 / least,
      double(after.contact_count) / blocks, double(after.candidate_count) / blocks,
      double(heap.memory.live()) / blocks, static_cast<long long>(allocations),
      static_cast<long long>(after.list_builds - before.list_builds), after.largest_speed);
  std::printf("%8.0f blocks: %8.1f ns a contact, described and loaded (median %.1f)\n", blocks,
              1e9 * forces.minimum() / double(after.contact_count),
              1e9 * forces.median() / double(after.contact_count));
  std::fflush(stdout);
}

}  // namespace
}  // namespace halfspace_benchmark

int main(int argc, char** argv) {
  using namespace halfspace_benchmark;
  const bool quick = has_option(argc, argv, "--quick"), for_peer = has_option(argc, argv, "--write");
  const Extent extent = quick      ? Extent{2, 2, 3, 0.2, 2, 1e3}
                        : for_peer ? Extent{4, 5, 5, 4, 10, 4e5}
                                   : Extent{10, 10, 10, 4, 10, 1e6};
  const int threads = threads_option(argc, argv);
  std::printf("libhalfspace %s, core %d\n", hs_version(), threads > 0 ? -1 : pin_to_this_core());
  try {
    const Bin bin = settled_bin(extent);
    if (for_peer) write(bin, std::string(option_value(argc, argv, "--write", "bin.txt")));
    for (const int bins : {1, extent.bins}) {
      if (threads > 0) {
        compare_threads(bin, bins, extent, threads);
      } else {
        time_steps(bin, bins, extent);
      }
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_polyhedra: %s\n", error.what());
    return 1;
  }
}
