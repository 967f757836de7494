// The cost of cutting a world into shares: the work of all shares over that of the plain world, copies, and
// bytes. One process does all in turn, so that the figures hold for a machine without its network.

#include <cstdio>

#include "random_polygon.h"
#include "random_polyhedron.h"
#include "shares/split_world.h"
#include "timing.h"

namespace halfspace_benchmark {
namespace {

using namespace halfspace_test;

World make_empty(hs_context* context, int dimension, double time_step) {
  hs_world_def def = world_def(dimension);
  def.time_step = time_step;
  def.local_damping = 0.3;
  World world = make_world(context, def);
  std::int32_t material = -1;
  require_ok(hs_world_add_material(world.get(), 2500, &material), context);
  hs_law_def law = law_def(1e7, 0.45);
  law.normal_damping = law.shear_damping = 0.2;
  require_ok(hs_world_set_default_law(world.get(), &law), context);
  return world;
}

/// Polygons of 3 to 8 corners on a floor between walls.
World polygons(hs_context* context, int columns, int rows) {
  constexpr double radius = 0.0115, pitch = 1.9 * radius, wall = 0.05;
  World world = make_empty(context, 2, 1e-5);
  const double width = columns * pitch, height = 4 * rows * pitch;
  add_block(context, world.get(), box(-wall, -wall, width + wall, 0), HS_BLOCK_FIXED);
  add_block(context, world.get(), box(-wall, 0, 0, height), HS_BLOCK_FIXED);
  add_block(context, world.get(), box(width, 0, width + wall, height), HS_BLOCK_FIXED);
  Random random(1);
  for (int i = 0; i < columns * rows; ++i) {
    const Shape grain = make_shape(context, random_polygon(3 + i % 6, radius, random));
    add_block(context, world.get(), grain, HS_BLOCK_RIGID,
              {{(i % columns + 0.5) * pitch, (i / columns + 0.6) * 1.1 * pitch, 0}, {0, 0, 0, 1}});
  }
  return world;
}

/// Polyhedra of 12 to 20 vertices on a floor between walls.
World polyhedra(hs_context* context, int side) {
  World world = make_empty(context, 3, 1e-4);
  const auto fixed = [&](const Triple& low, const Triple& high) {
    const Triple mid = {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2};
    Corners corners;
    for (int k = 0; k < 8; ++k)
      corners.push_back({(k & 1 ? high[0] : low[0]) - mid[0], (k & 2 ? high[1] : low[1]) - mid[1],
                         (k & 4 ? high[2] : low[2]) - mid[2]});
    add_block(context, world.get(), hull(context, corners), HS_BLOCK_FIXED,
              {{mid[0], mid[1], mid[2]}, {0, 0, 0, 1}});
  };
  const double s = side, height = 4 * s;
  fixed({-1, -1, -1}, {s + 1, s + 1, 0});
  fixed({-1, -1, 0}, {0, s + 1, height});
  fixed({s, -1, 0}, {s + 1, s + 1, height});
  fixed({0, -1, 0}, {s, 0, height});
  fixed({0, s, 0}, {s, s + 1, height});
  Random random(1);
  for (int i = 0; i < side * side * side; ++i)
    add_block(context, world.get(), hull(context, random_corners(random)), HS_BLOCK_RIGID,
              {{i % side + 0.5, i / side % side + 0.5, i / side / side * 1.02 + 0.52}, {0, 0, 0, 1}});
  return world;
}

void print_cost(const char* name, hs_context* context, const World& world, int settling, int steps,
                int passes) {
  require_ok(hs_world_step(world.get(), settling), context);
  const std::vector<unsigned char> start = saved(world.get());
  SplitWorld one(start, 1), two(start, 2);
  Passes plain, in_one, in_two;
  for (int pass = 0; pass < passes; ++pass) {
    plain.add(seconds_of([&] { require_ok(hs_world_step(world.get(), steps), context); }));
    in_one.add(seconds_of([&] {
      for (int i = 0; i < steps; ++i) one.step();
    }));
    in_two.add(seconds_of([&] {
      for (int i = 0; i < steps; ++i) two.step();
    }));
  }
  const double blocks = double(keys_with(world.get(), HS_ROLE_OWN).size()), copies = double(two.copies());
  const std::vector<std::int64_t> keys = keys_with(two.world(0), HS_ROLE_OWN);
  hs_context* const of_share = two.context();
  const double record =
      double(packed(of_share, two.world(0), keys, false).bytes.size()) / double(keys.size());
  const double with_shape =
      double(packed(of_share, two.world(0), keys, true).bytes.size()) / double(keys.size());
  const double assemblies = double(two.assemblies());
  std::printf("%-10s %8.0f %9.0f %8.2f %8.2f %9.3f %8d %8.0f %8.0f %9.1f %9.0f\n", name, blocks,
              1e9 * plain.minimum() / steps / blocks, in_one.minimum() / plain.minimum(),
              in_two.minimum() / plain.minimum(), copies / blocks, 8 * info_of(two.world(0)).load_length,
              record, with_shape, 1e9 * two.assembling() / assemblies / blocks,
              double(steps * passes) / assemblies);
  std::fflush(stdout);
}

void run(int argc, char** argv) {
  const bool quick = has_option(argc, argv, "--quick");
  pin_to_this_core();
  const char* const titles = "%-10s %8s %9s %8s %8s %9s %8s %8s %8s %9s %9s\n";
  std::printf(titles, "", "", "ns/block", "one", "two", "copies", "bytes of", "bytes of", "with", "ns/block",
              "steps per");
  std::printf(titles, "scene", "blocks", "and step", "share", "shares", "of two", "a load", "a record",
              "a shape", "assembled", "assembly");
  const Context context = make_context();
  const int passes = quick ? 1 : 5;
  const int columns = quick ? 20 : 400, side = quick ? 4 : 27;
  print_cost("polygons", context.get(), polygons(context.get(), columns, columns / 8), quick ? 100 : 8000,
             quick ? 20 : 400, passes);
  print_cost("polyhedra", context.get(), polyhedra(context.get(), side), quick ? 50 : 1500, quick ? 10 : 100,
             passes);
}

}  // namespace
}  // namespace halfspace_benchmark

int main(int argc, char** argv) {
  try {
    halfspace_benchmark::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_shares: %s\n", error.what());
    return 1;
  }
}
