// Cost of a step of bodies of finite elements, by kind of cell: time, memory, and what their contacts add.
// README.md says what is timed and how to read the figures.

#include <cmath>
#include <cstdio>
#include <random>
#include <stdexcept>

#include "capi/mesh_words.h"
#include "counting_memory.h"
#include "timing.h"

namespace halfspace_benchmark {
namespace {

using halfspace_test::brick;
using halfspace_test::MeshWords;
using halfspace_test::Node;
using halfspace_test::Nodes;
using halfspace_test::view_of;

constexpr int passes = 7;
constexpr double density = 2500, young = 1e9, gravity = 9.81;
constexpr double contact_stiffness = 1e11;  // Pa/m

struct Extent {
  double small, large;  // cells of a body
  int columns_2d;       // of a body that lies on another, along each side
  int columns_3d;
  double cell_steps;  // of each world in a pass
};

constexpr Extent full_extent{2e3, 1e5, 2000, 40, 2e6};
constexpr Extent quick_extent{200, 2e3, 50, 6, 1e4};

class MeshWorld {
 public:
  explicit MeshWorld(int dimension, int32_t stiffness_kind = HS_STIFFNESS_PER_AREA, int threads = 1)
      : dimension_(dimension) {
    hs_context_def context_def = memory_.definition();
    context_def.threads = threads;
    context_ = halfspace_test::make_context(&context_def);
    hs_world_def def;
    hs_world_def_init(&def, sizeof def, dimension);
    hs_world* made = nullptr;
    check(hs_world_create(context_.get(), &def, &made));
    world_.reset(made);
    hs_law_def law;
    hs_law_def_init(&law, sizeof law);
    law.stiffness_kind = stiffness_kind;
    law.normal_stiffness = law.shear_stiffness = contact_stiffness;
    law.friction_angle = 0.5;
    check(hs_world_set_default_law(made, &law));
    int32_t material = 0;
    check(hs_world_add_material(made, density, &material));
    hs_elasticity_def elasticity;
    check(hs_elasticity_def_init(&elasticity, sizeof elasticity));
    elasticity.young_modulus = young;
    elasticity.poisson_ratio = 0.25;
    check(hs_world_set_elasticity(made, material, &elasticity));
  }

  /// Moved along the last axis. Nodes that are given there or below are held.
  hs_body add(const MeshWords& words, double height, double held_up_to) {
    hs_body_def def;
    check(hs_body_def_init(&def, sizeof def));
    def.pose.position[dimension_ - 1] = height;
    hs_body body = 0;
    check(hs_world_add_mesh(world_.get(), halfspace_test::make_mesh(context_.get(), words).get(), &def,
                            nullptr, &body));
    shake(body, words.nodes.size());
    hold(body, words, dimension_ - 1, held_up_to);
    cells_ += double(words.kinds.size());
    return body;
  }

  /// A body that is clamped at its left.
  void add_cantilever(const MeshWords& words) { hold(add(words, 0, -1), words, 0, 0); }

  /// A fixed block with its top at 0, which reaches beyond a body of this size by as much again.
  void add_floor(double size) {
    hs_shape* made = nullptr;
    if (dimension_ == 2) {
      check(hs_polygon_create(context_.get(), view_of(halfspace_test::box(-size, -1, 2 * size, 0)), &made));
    } else {
      Nodes corners;
      for (int k = 0; k < 8; ++k)
        corners.emplace_back(k & 1 ? -size : 2 * size, k & 2 ? -size : 2 * size, k & 4 ? -1 : 0);
      check(hs_polyhedron_create_hull(context_.get(), view_of(corners), &made));
    }
    const halfspace_test::Shape shape(made);
    hs_block_def def;
    check(hs_block_def_init(&def, sizeof def, made));
    def.kind = HS_BLOCK_FIXED;
    hs_block block = 0;
    check(hs_world_add_block(world_.get(), made, &def, &block));
  }

  double cells() const { return cells_; }
  const CountingMemory& memory() const { return memory_; }
  void step(int steps) const { check(hs_world_step(world_.get(), steps)); }

  hs_world_report report() const {
    hs_world_report report;
    check(hs_world_get_report(world_.get(), &report, sizeof report));
    return report;
  }

 private:
  void check(hs_status status) const { halfspace_test::require_ok(status, context_.get()); }

  /// Nodes start at random: waves that are about to reach a body at rest are denormal numbers, which cost
  /// more.
  void shake(hs_body body, std::size_t nodes) const {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> speed(-1e-4, 1e-4);
    Nodes velocities(nodes);
    for (Node& velocity : velocities) velocity = {speed(random), speed(random), speed(random)};
    check(hs_world_set_node_velocities(world_.get(), body, view_of(velocities)));
  }

  void hold(hs_body body, const MeshWords& words, int axis, double up_to) const {
    std::vector<int32_t> held;
    for (std::size_t i = 0; i < words.nodes.size(); ++i)
      if (words.nodes[i][axis] <= up_to) held.push_back(int32_t(i));
    const double still[3] = {};
    const int32_t axes = HS_AXIS_X + HS_AXIS_Y + (dimension_ == 3 ? HS_AXIS_Z : 0);
    check(hs_world_hold_nodes(world_.get(), body, held.data(), std::int64_t(held.size()), axes, still));
  }

  int dimension_;
  double cells_ = 0;
  CountingMemory memory_;
  halfspace_test::Context context_;
  halfspace_test::World world_;
};

int cells_of_a_brick(int32_t kind) {
  return kind == HS_CELL_TETRAHEDRON ? 6 : kind == HS_CELL_TRIANGLE || kind == HS_CELL_PRISM ? 2 : 1;
}

/// A body of 1 m along each side.
MeshWords cube_of(int32_t kind, double wanted_cells) {
  const int dimension = halfspace_test::dimension_of(kind);
  const int n = int(std::lround(std::pow(wanted_cells / cells_of_a_brick(kind), 1. / dimension)));
  return brick(dimension, {1, 1, 1}, {n, n, n}, [&](int) { return kind; });
}

void time_cantilever(int32_t kind, double wanted_cells, const Extent& extent) {
  const int dimension = halfspace_test::dimension_of(kind);
  const MeshWords words = cube_of(kind, wanted_cells);
  MeshWorld world(dimension);
  const std::int64_t empty = world.memory().live();
  world.add_cantilever(words);
  const int steps = std::max(2, int(extent.cell_steps / world.cells()));
  world.step(steps);  // the first one finds the time step and fills the lists
  const std::int64_t allocations_before = world.memory().allocations();
  Passes timed;
  for (int i = 0; i < passes; ++i) timed.add(seconds_of([&] { world.step(steps); }));
  const std::int64_t allocations = world.memory().allocations() - allocations_before;
  const double cell_steps = steps * world.cells(), held = double(world.memory().live() - empty);
  std::printf("%-10s %7.0f %7zu %8lld %8.2f %8.2f %8.1f %8.0f %8.0f %7lld\n",
              halfspace_test::name_of_cell(kind), world.cells(), words.nodes.size(),
              static_cast<long long>(world.report().block_count), 1e-6 * cell_steps / timed.minimum(),
              1e-6 * cell_steps / timed.median(), 1e9 * timed.minimum() / cell_steps, held / world.cells(),
              held / double(words.nodes.size()), static_cast<long long>(allocations));
  std::fflush(stdout);
}

/// A flat body on a fixed block or on its like, pressed on it by its weight, and the same two apart: what the
/// steps of the former take longer is the cost of contacts. Without springs each corner at a face is one.
void time_contacts(int32_t kind, bool on_its_like, int32_t law, const Extent& extent) {
  const int dimension = halfspace_test::dimension_of(kind);
  const int n = dimension == 2 ? extent.columns_2d : extent.columns_3d;
  const double cell = 0.01, size = n * cell, height = 2 * cell;
  const MeshWords words = dimension == 2
                              ? brick(2, {size, height, 0}, {n, 2, 0}, [&](int) { return kind; })
                              : brick(3, {size, size, height}, {n, n, 2}, [&](int) { return kind; });
  const auto fill = [&](MeshWorld& world, double gap) {
    if (on_its_like) {
      world.add(words, -height, 0);
    } else {
      world.add_floor(size);
    }
    world.add(words, gap, -1);
  };
  const bool has_spring = law != HS_STIFFNESS_NONE;
  MeshWorld touching(dimension, law), apart(dimension, law);
  fill(touching, has_spring ? -density * gravity * height / contact_stiffness : 0);
  fill(apart, 1);
  // A cell at the surface costs some times as much as one inside.
  const int steps = std::max(2, int(extent.cell_steps / 8 / touching.cells()));
  touching.step(steps);
  apart.step(steps);
  Passes of_touching, of_apart;
  for (int i = 0; i < passes; ++i) {
    of_touching.add(seconds_of([&] { touching.step(steps); }));
    of_apart.add(seconds_of([&] { apart.step(steps); }));
  }
  const hs_world_report report = touching.report();
  const double of_cell = of_apart.minimum() / (steps * apart.cells()),
               of_contact =
                   (of_touching.minimum() - of_apart.minimum()) / (steps * double(report.contact_count));
  std::printf("%-10s %-8s %-8s %7.0f %8lld %8lld %10lld %8.1f %8.1f %8.1f %8.1f\n",
              halfspace_test::name_of_cell(kind), on_its_like ? "its like" : "a block",
              has_spring ? "per area" : "none", touching.cells(), static_cast<long long>(report.block_count),
              static_cast<long long>(report.contact_count), static_cast<long long>(report.candidate_count),
              1e9 * of_cell, 1e9 * of_contact, of_contact / of_cell,
              0.5 * double(report.iteration_count) / double(report.steps));
  std::fflush(stdout);
}

void run_threads(const Extent& extent, int threads) {
  for (const int32_t kind : halfspace_test::all_cell_kinds) {
    const MeshWords words = cube_of(kind, extent.large);
    const int dimension = halfspace_test::dimension_of(kind);
    MeshWorld one(dimension), several(dimension, HS_STIFFNESS_PER_AREA, threads);
    for (MeshWorld* world : {&one, &several}) {
      world->add_cantilever(words);
      world->step(2);
    }
    const int steps = std::max(2, int(extent.cell_steps / one.cells()));
    std::printf("%-10s ", halfspace_test::name_of_cell(kind));
    print_speed_up(
        one.cells(), "cells", threads, passes, [&] { one.step(steps); }, [&] { several.step(steps); });
  }
}

void run_all(const Extent& extent) {
  std::printf("%-10s %7s %7s %8s %8s %8s %8s %8s %8s %7s\n", "a body of", "", "", "surface", "1e6 cell", "",
              "ns/cell-", "B/cell", "B/node", "steady");
  std::printf("%-10s %7s %7s %8s %8s %8s %8s %8s %8s %7s\n", "", "cells", "nodes", "blocks", "steps/s",
              "median", "step", "held", "held", "allocs");
  for (const double cells : {extent.small, extent.large})
    for (const int32_t kind : halfspace_test::all_cell_kinds) time_cantilever(kind, cells, extent);
  std::printf("\n%-10s %-8s %-8s %7s %8s %8s %10s %8s %8s %8s %8s\n", "a body of", "lies on", "stiffn.",
              "cells", "blocks", "contacts", "candidates", "ns/cell", "ns/cont.", "ratio", "rounds");
  for (const int32_t law : {HS_STIFFNESS_PER_AREA, HS_STIFFNESS_NONE})
    for (const bool on_its_like : {false, true})
      for (const int32_t kind : halfspace_test::all_cell_kinds) time_contacts(kind, on_its_like, law, extent);
}

}  // namespace
}  // namespace halfspace_benchmark

int main(int argc, char** argv) {
  using namespace halfspace_benchmark;
  const Extent extent = has_option(argc, argv, "--quick") ? quick_extent : full_extent;
  const int threads = threads_option(argc, argv);
  std::printf("libhalfspace %s, core %d\n", hs_version(), threads > 0 ? -1 : pin_to_this_core());
  try {
    if (threads > 0) {
      run_threads(extent, threads);
    } else {
      run_all(extent);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_mesh: %s\n", error.what());
    return 1;
  }
}
