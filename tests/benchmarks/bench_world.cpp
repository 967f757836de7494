// Cost of a step in a settled heap from 1e3 to 1e6 blocks of the same packing: time and memory per block.
// README.md says what is timed and how to read the figures.

#include <cstdio>
#include <stdexcept>

#include "box2d_heap.h"
#include "counting_memory.h"
#include "timing.h"

namespace halfspace_benchmark {
namespace {

using halfspace_test::require_ok;

constexpr int passes = 5;

struct Extent {
  int columns, rows;        ///< grains of a bin
  std::vector<int> bins;    ///< in each world
  double most_time;         ///< for settling the bin, s
  double block_steps;       ///< of each world in a pass
  int most_blocks_of_peer;  ///< Box2D's floats do not reach further
  int steps_of_peer;
  Order order;
};

Extent full_extent(Order order) { return {20, 50, {1, 10, 100, 1000}, 3, 4e6, 100000, 20, order}; }
Extent quick_extent(Order order) { return {10, 10, {1, 10}, 1, 1e4, 1000, 2, order}; }

const char* name_of(Order order) {
  static const char* const names[] = {"bin by bin", "in random order", "along a curve"};
  return names[int(order)];
}

hs_world_report report_of(hs_world* world, hs_context* context) {
  hs_world_report report;
  require_ok(hs_world_get_report(world, &report, sizeof report), context);
  return report;
}

/// Prints one world's row; returns its ns per block-step.
double run(const Bin& bin, int bins, const Extent& extent, Random& random) {
  CountingMemory memory;
  const hs_context_def def = memory.definition();
  const halfspace_test::Context context = halfspace_test::make_context(&def);
  halfspace_test::World world;
  const double build = seconds_of([&] { world = make_heap(context.get(), bin, bins, extent.order, random); });

  const double blocks = double(bins) * double(bin.grains.size());
  const int steps = std::max(2, int(extent.block_steps / blocks));
  const auto pass = [&] { require_ok(hs_world_step(world.get(), steps), context.get()); };
  pass();  // the first step finds the time step, fills the lists and grows what must grow

  const hs_world_report before = report_of(world.get(), context.get());
  const std::int64_t allocations_before = memory.allocations();
  Passes timed;
  for (int i = 0; i < passes; ++i) timed.add(seconds_of(pass));
  const std::int64_t allocations = memory.allocations() - allocations_before;
  const hs_world_report after = report_of(world.get(), context.get());

  const double least = 1e9 * timed.minimum() / (steps * blocks);
  std::printf("%8.0f %6d %8.2f %9.2f %8.1f %8.1f %9.2f %9.0f %9.0f %7lld %7lld %9.1e %7.1f", blocks, steps,
              double(after.contact_count) / blocks, double(after.candidate_count) / blocks, least,
              1e9 * timed.median() / (steps * blocks), 1e3 / least, double(memory.live()) / blocks,
              double(memory.peak()) / blocks, static_cast<long long>(allocations),
              static_cast<long long>(after.list_builds - before.list_builds), after.largest_speed, build);
  if (blocks <= extent.most_blocks_of_peer) {
    std::printf(" %9.1f\n", 1e9 * box2d_step_seconds(bin, bins, extent.steps_of_peer) / blocks);
  } else {
    std::printf(" %9s\n", "-");
  }
  std::fflush(stdout);
  return least;
}

/// The same world on one thread and on several.
struct ThreadedHeap {
  halfspace_test::Context context;
  halfspace_test::World world;

  ThreadedHeap(int threads, const Bin& bin, int bins, const Extent& extent) {
    hs_context_def def;
    hs_context_def_init(&def, sizeof def);
    def.threads = threads;
    context = halfspace_test::make_context(&def);
    Random random(2);
    world = make_heap(context.get(), bin, bins, extent.order, random);
  }
  void step(int steps) const { require_ok(hs_world_step(world.get(), steps), context.get()); }
};

void run_threads(const Extent& extent, int threads) {
  Random random(1);
  const Bin bin = settle_bin(extent.columns, extent.rows, extent.most_time, random);
  for (const int bins : extent.bins) {
    const ThreadedHeap one(1, bin, bins, extent), several(threads, bin, bins, extent);
    const double blocks = double(bins) * double(bin.grains.size());
    const int steps = std::max(2, int(extent.block_steps / blocks));
    one.step(steps);
    several.step(steps);
    print_speed_up(
        blocks, "blocks", threads, passes, [&] { one.step(steps); }, [&] { several.step(steps); });
  }
}

void run_all(const Extent& extent) {
  Random random(1);
  const Bin bin = settle_bin(extent.columns, extent.rows, extent.most_time, random);
  std::printf("bin of %d triangles settled for %.2f s, left with at most %.1e m/s; blocks %s\n",
              extent.columns * extent.rows, bin.settling_time, bin.largest_speed, name_of(extent.order));
  std::printf("%8s %6s %8s %9s %8s %8s %9s %9s %9s %7s %7s %9s %7s %9s\n", "", "steps", "per block", "",
              "ns/blk-stp", "", "1e6 block", "B/block", "", "steady", "list", "largest", "build", "Box2D");
  std::printf("%8s %6s %8s %9s %8s %8s %9s %9s %9s %7s %7s %9s %7s %9s\n", "blocks", "a pass", "contacts",
              "candid.", "min", "median", "steps/s", "held", "peak", "allocs", "builds", "speed m/s", "s",
              "ns/blk-st");
  std::vector<double> costs;
  for (const int bins : extent.bins) costs.push_back(run(bin, bins, extent, random));
  std::printf("cost of the largest world over that of the second: %.2f\n", costs.back() / costs[1]);
}

}  // namespace
}  // namespace halfspace_benchmark

int main(int argc, char** argv) {
  using namespace halfspace_benchmark;
  const Order order = has_option(argc, argv, "--random-order")  ? Order::random
                      : has_option(argc, argv, "--along-curve") ? Order::along_curve
                                                                : Order::bin_by_bin;
  const Extent extent = has_option(argc, argv, "--quick") ? quick_extent(order) : full_extent(order);
  const int threads = threads_option(argc, argv);
  std::printf("libhalfspace %s, Box2D " BOX2D_VERSION ", core %d\n", hs_version(),
              threads > 0 ? -1 : pin_to_this_core());
  try {
    if (threads > 0) {
      run_threads(extent, threads);
    } else {
      run_all(extent);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_world: %s\n", error.what());
    return 1;
  }
}
