// The angle of repose of Wang et al. 2021, section 4.4, at full size: block-steps per second in the box,
// while the baffles rise and in the heap at rest. README.md says what is timed and how to read the figures.

#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "counting_memory.h"
#include "timing.h"
#include "triangle_mesh.h"

namespace halfspace_benchmark {
namespace {

using halfspace_test::Context;
using halfspace_test::require_ok;
using halfspace_test::Shape;
using halfspace_test::World;

struct Extent {
  double width, height;          ///< of the material, m
  int columns, rows, quartered;  ///< of its mesh
  double plate_length;
  double time_in_box, time_of_rise, time_to_rest;  ///< simulated, s
  double rise_speed;                               ///< of the baffles, m/s
  int timed_steps;                                 ///< in each of the passes
};

// 49 x 59 cells halved and three of them quartered are the paper's 5788 triangles. Plate and baffles have the
// length of its 440 squares of 0.05 m: (8.6 + 2 x 1.2) x 0.1 m^2. The baffles rise ten times as fast as the
// paper's.
constexpr Extent full_extent{1.0, 1.2, 49, 59, 3, 8.6, 0.05, 1.3, 1.5, 1.0, 200};
constexpr Extent quick_extent{0.2, 0.24, 10, 12, 0, 1.7, 0.002, 0.004, 0.002, 1.0, 20};

constexpr double wall = 0.1;
constexpr double time_step =
    10e-6;  // the paper gives 10 and 20 us; with the latter the packed box is unstable
constexpr double stiffness = 1e8;
constexpr double friction_angle = 25 * pi / 180;
constexpr double density = 2500;
constexpr double local_damping = 0.1;  // ours: the paper names none, and without any the box rings on
constexpr int passes = 5;

enum Material { grain_material, plate_material, baffle_material };

World make_world(hs_context* context) {
  hs_world_def def;
  hs_world_def_init(&def, sizeof def, 2);
  def.time_step = time_step;
  def.local_damping = local_damping;
  hs_world* world = nullptr;
  require_ok(hs_world_create(context, &def, &world), context);
  World owned(world);
  for (int i = 0; i < 3; ++i) {
    std::int32_t material = 0;
    require_ok(hs_world_add_material(world, density, &material), context);
  }
  hs_law_def law;
  hs_law_def_init(&law, sizeof law);
  law.normal_stiffness = law.shear_stiffness = stiffness;
  law.friction_angle = friction_angle;
  law.normal_damping = law.shear_damping = 0;
  require_ok(hs_world_set_default_law(world, &law), context);
  law.friction_angle = 0;
  require_ok(hs_world_set_law(world, grain_material, baffle_material, &law), context);
  return owned;
}

hs_block add_block(hs_context* context, hs_world* world, const Points& vertices, int kind,
                   Material material) {
  const Shape shape = halfspace_test::make_shape(context, vertices);
  hs_block_def def;
  hs_block_def_init(&def, sizeof def, shape.get());
  def.kind = kind;
  def.material = material;
  hs_block block = 0;
  require_ok(hs_world_add_block(world, shape.get(), &def, &block), context);
  return block;
}

class Repose {
 public:
  Repose(const Extent& extent, hs_context* context) : context_(context), world_(make_world(context)) {
    const double middle = extent.width / 2;
    add(halfspace_test::box(middle - extent.plate_length / 2, -wall, middle + extent.plate_length / 2, 0),
        HS_BLOCK_FIXED, plate_material);
    baffles_[0] = add(halfspace_test::box(-wall, 0, 0, extent.height), HS_BLOCK_PRESCRIBED, baffle_material);
    baffles_[1] = add(halfspace_test::box(extent.width, 0, extent.width + wall, extent.height),
                      HS_BLOCK_PRESCRIBED, baffle_material);
    Random random(1);
    for (const Points& triangle :
         mesh_rectangle(extent.width, extent.height, extent.columns, extent.rows, extent.quartered, random)) {
      add(triangle, HS_BLOCK_RIGID, grain_material);
    }
  }

  Repose(hs_context* context, const std::string& saved) : context_(context) {
    hs_world* world = nullptr;
    require_ok(hs_world_restore(context, saved.data(), saved.size(), &world), context);
    world_.reset(world);
  }

  std::string save() const {
    std::size_t size = 0;
    (void)hs_world_save(world_.get(), nullptr, 0, &size);  // which tells the size
    std::string bytes(size, '\0');
    require_ok(hs_world_save(world_.get(), bytes.data(), size, &size), context_);
    return bytes;
  }

  void set_rise_speed(double speed) {
    const double velocity[3] = {0, speed, 0}, spin[3] = {0, 0, 0};
    for (const hs_block baffle : baffles_)
      require_ok(hs_world_set_velocity(world_.get(), baffle, velocity, spin), context_);
  }

  void step(int steps) { require_ok(hs_world_step(world_.get(), steps), context_); }
  void pass_time(double time) { step(int(time / time_step)); }

  hs_world_report report() const {
    hs_world_report report;
    require_ok(hs_world_get_report(world_.get(), &report, sizeof report), context_);
    return report;
  }

 private:
  hs_block add(const Points& vertices, int kind, Material material) {
    return add_block(context_, world_.get(), vertices, kind, material);
  }

  hs_context* context_;
  World world_;
  hs_block baffles_[2] = {0, 0};
};

void print_header() {
  std::printf("%-12s %8s %8s %9s %9s %9s %9s %9s %7s %7s %10s\n", "", "", "contacts", "candid.", "ns/blk-st",
              "", "1e6 blk-", "bytes per", "", "list", "largest");
  std::printf("%-12s %8s %8s %9s %9s %9s %9s %9s %7s %7s %10s\n", "stage", "time, s", "a block", "a block",
              "min", "median", "steps/s", "block", "allocs", "builds", "speed m/s");
}

/// Times some steps from where the world stands.
void measure(const char* stage, Repose& repose, const Extent& extent, const CountingMemory& memory) {
  repose.step(1);
  const hs_world_report before = repose.report();
  const std::int64_t allocations = memory.allocations();
  Passes timed;
  for (int i = 0; i < passes; ++i) timed.add(seconds_of([&] { repose.step(extent.timed_steps); }));
  const hs_world_report after = repose.report();
  const double blocks = double(after.block_count);
  const auto ns = [&](double seconds) { return 1e9 * seconds / (extent.timed_steps * blocks); };
  std::printf("%-12s %8.3f %8.2f %9.2f %9.1f %9.1f %9.2f %9.0f %7lld %7lld %10.1e\n", stage, after.time,
              double(after.contact_count) / blocks, double(after.candidate_count) / blocks,
              ns(timed.minimum()), ns(timed.median()), 1e3 / ns(timed.minimum()),
              double(memory.live()) / blocks, static_cast<long long>(memory.allocations() - allocations),
              static_cast<long long>(after.list_builds - before.list_builds), after.largest_speed);
  std::fflush(stdout);
}

std::string read_all(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_all(const std::string& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary);
  if (!file.write(bytes.data(), std::streamsize(bytes.size())))
    throw std::runtime_error("cannot write " + path);
}

/// From the full box to the heap at rest, timed on the way; the heap is kept in `path` if one is given.
void form_heap(const Extent& extent, const std::string& path) {
  CountingMemory memory;
  const hs_context_def def = memory.definition();
  const Context context = halfspace_test::make_context(&def);
  Repose repose(extent, context.get());
  repose.pass_time(extent.time_in_box);
  measure("in the box", repose, extent, memory);
  repose.set_rise_speed(extent.rise_speed);
  repose.pass_time(extent.time_of_rise / 2);
  measure("baffles rise", repose, extent, memory);
  repose.pass_time(extent.time_of_rise / 2);
  repose.set_rise_speed(0);
  repose.pass_time(extent.time_to_rest);
  measure("heap", repose, extent, memory);
  if (!path.empty()) write_all(path, repose.save());
}

void measure_kept_heap(const Extent& extent, const std::string& saved) {
  CountingMemory memory;
  const hs_context_def def = memory.definition();
  const Context context = halfspace_test::make_context(&def);
  Repose repose(context.get(), saved);
  measure("kept heap", repose, extent, memory);
}

}  // namespace
}  // namespace halfspace_benchmark

int main(int argc, char** argv) {
  using namespace halfspace_benchmark;
  const Extent& extent = has_option(argc, argv, "--quick") ? quick_extent : full_extent;
  const std::string path(option_value(argc, argv, "--keep", ""));
  std::printf("libhalfspace %s, core %d, %d triangles\n", hs_version(), pin_to_this_core(),
              2 * (extent.columns * extent.rows + extent.quartered));
  print_header();
  try {
    if (const std::string saved = read_all(path); !saved.empty()) {
      measure_kept_heap(extent, saved);
    } else {
      form_heap(extent, path);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_repose: %s\n", error.what());
    return 1;
  }
}
