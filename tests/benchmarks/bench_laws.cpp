// Cost of contact laws and of kinds of blocks, on the same blocks in the same places. README.md says what is
// timed and how to read the figures.

#include <cmath>
#include <cstdio>
#include <random>
#include <stdexcept>

#include "capi/handles.h"
#include "random_polyhedron.h"
#include "timing.h"

namespace halfspace_benchmark {
namespace {

using halfspace_test::require_ok;

constexpr int passes = 15;
constexpr double too_short_to_move = 1e-9;  // while it is timed

/// Blocks on a grid, each turned a little, that overlap with their neighbours.
struct Packing {
  const char* name;
  int dimension;
  std::vector<Corners> blocks;
  std::vector<hs_pose> poses;
};

/// By up to `tilt` about each axis, in the plane about z.
hs_pose pose_of(const Packing& packing, const Triple& place, double tilt, std::mt19937_64& random) {
  std::uniform_real_distribution<double> angle(-tilt, tilt);
  hs_pose pose{{place[0], place[1], place[2]}, {0, 0, 0, 1}};
  for (int axis = packing.dimension == 2 ? 2 : 0; axis < 3; ++axis)
    pose.rotation[axis] = std::sin(angle(random) / 2);
  const double* q = pose.rotation;
  pose.rotation[3] = std::sqrt(1 - q[0] * q[0] - q[1] * q[1] - q[2] * q[2]);
  return pose;
}

Corners brick(double x, double y, double z) {
  Corners corners;
  for (int k = 0; k < (z > 0 ? 8 : 4); ++k) {
    const bool right = (k & 1) != ((k >> 1) & 1), far = k & 2;  // counter-clockwise
    corners.push_back({right ? x / 2 : -x / 2, far ? y / 2 : -y / 2, k & 4 ? z / 2 : -z / 2});
  }
  return corners;
}

/// Every other row is shifted by half a brick. Overlaps are about a thousandth of a brick.
Packing bricks(int dimension, int columns, int rows, int layers) {
  Packing packing{dimension == 2 ? "bricks in the plane" : "bricks in space", dimension, {}, {}};
  std::mt19937_64 random(1);
  for (int layer = 0; layer < layers; ++layer)
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        packing.blocks.push_back(brick(1, 0.5, dimension == 2 ? 0 : 1));
        packing.poses.push_back(pose_of(
            packing, {0.999 * (column + 0.5 * (row % 2)), 0.4995 * row, 0.999 * layer}, 1e-3, random));
      }
  return packing;
}

/// Hulls of 12 to 20 points on a sphere, that dip into their neighbours by some hundredths.
Packing polyhedra(int count) {
  Packing packing{"polyhedra", 3, {}, {}};
  std::mt19937_64 random(2);
  for (int i = 0; i < count * count * count; ++i) {
    packing.blocks.push_back(random_corners(random));
    packing.poses.push_back(pose_of(
        packing, {0.85 * (i % count), 0.85 * (i / count % count), 0.85 * (i / count / count)}, 1, random));
  }
  return packing;
}

/// Puts b where it is so deep in a, off in some direction.
void bring_together(const Corners& a, const hs_pose& pose_a, const Corners& b, hs_pose& pose_b,
                    const Triple& direction, double depth) {
  const halfspace_test::Context context = halfspace_test::make_context();
  const halfspace_test::Shape shape_a = hull(context.get(), a), shape_b = hull(context.get(), b);
  double deeper = 0, farther = 2;
  for (int halvings = 0; halvings < 60; ++halvings) {
    const double distance = 0.5 * (deeper + farther);
    for (int axis = 0; axis < 3; ++axis)
      pose_b.position[axis] = pose_a.position[axis] + distance * direction[std::size_t(axis)];
    hs_contact contact;
    require_ok(hs_pair_detect(shape_a.get(), &pose_a, shape_b.get(), &pose_b, nullptr, nullptr, &contact),
               context.get());
    (contact.gap > -depth ? farther : deeper) = distance;
  }
}

/// The same hulls two and two, far from the next two, with one depth of overlap for all.
Packing couples(const char* name, int count, double depth) {
  Packing packing{name, 3, {}, {}};
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> along(-1, 1);
  for (int i = 0; i < count; ++i) {
    const Corners a = random_corners(random), b = random_corners(random);
    const hs_pose pose_a = pose_of(packing, {4.0 * i, 0, 0}, 1, random);
    hs_pose pose_b = pose_of(packing, {0, 0, 0}, 1, random);
    const double z = along(random), angle = 3.14159265358979323846 * along(random), r = std::sqrt(1 - z * z);
    bring_together(a, pose_a, b, pose_b, {r * std::cos(angle), r * std::sin(angle), z}, depth);
    packing.blocks.insert(packing.blocks.end(), {a, b});
    packing.poses.insert(packing.poses.end(), {pose_a, pose_b});
  }
  return packing;
}

/// A packing under one law, of blocks of one kind.
class Scene {
 public:
  /// With a time step of 0, that which the library finds.
  Scene(const Packing& packing, int32_t stiffness_kind, int32_t kind, double time_step)
      : context_(halfspace_test::make_context()) {
    hs_world_def def;
    check(hs_world_def_init(&def, sizeof def, packing.dimension));
    def.gravity[packing.dimension - 1] = 0;
    def.time_step = time_step;
    hs_world* made = nullptr;
    check(hs_world_create(context_.get(), &def, &made));
    world_.reset(made);
    hs_law_def law;
    check(hs_law_def_init(&law, sizeof law));
    law.stiffness_kind = stiffness_kind;
    law.friction_angle = 0.5;
    law.normal_damping = law.shear_damping = 0;
    check(hs_world_set_default_law(made, &law));
    int32_t material = 0;
    check(hs_world_add_material(made, 2500, &material));
    hs_elasticity_def elasticity;
    check(hs_elasticity_def_init(&elasticity, sizeof elasticity));
    check(hs_world_set_elasticity(made, material, &elasticity));
    for (std::size_t i = 0; i < packing.blocks.size(); ++i) add(packing, i, kind);
  }

  void check(hs_status status) const { require_ok(status, context_.get()); }

  void step(int steps) const { check(hs_world_step(world_.get(), steps)); }
  /// Without asking for them: they stay in the world.
  void evaluate_forces() const {
    const hs_status status = hs_world_forces(world_.get(), 0, {}, {});
    if (status != HS_NOTE_TRUNCATED) check(status);
  }
  hs_world_report report() const {
    hs_world_report report;
    check(hs_world_get_report(world_.get(), &report, sizeof report));
    return report;
  }

 private:
  void add(const Packing& packing, std::size_t i, int32_t kind) {
    const Corners& corners = packing.blocks[i];
    const halfspace_test::Shape shape =
        packing.dimension == 2 ? polygon(corners) : hull(context_.get(), corners);
    hs_block_def def;
    check(hs_block_def_init(&def, sizeof def, shape.get()));
    def.kind = kind;
    def.pose = packing.poses[i];
    hs_block block = 0;
    check(hs_world_add_block(world_.get(), shape.get(), &def, &block));
  }

  halfspace_test::Shape polygon(const Corners& corners) const {
    hs_shape* made = nullptr;
    check(hs_polygon_create(context_.get(), view_of(corners), &made));
    return halfspace_test::Shape(made);
  }

  halfspace_test::Context context_;
  halfspace_test::World world_;
};

struct Cost {
  double forces;  // s for each contact, described and loaded
  double step;    // s for each block
};

Cost cost_of(const Packing& packing, int32_t stiffness_kind, int32_t kind, double block_steps) {
  const Scene scene(packing, stiffness_kind, kind, too_short_to_move);
  const double blocks = double(packing.blocks.size());
  const int steps = std::max(2, int(block_steps / blocks));
  scene.step(2);
  const double contacts = double(scene.report().contact_count);
  Passes forces, stepped;
  for (int i = 0; i < passes; ++i) {
    stepped.add(seconds_of([&] { scene.step(steps); }));
    forces.add(seconds_of([&] {
      for (int k = 0; k < steps; ++k) scene.evaluate_forces();
    }));
    scene.step(1);
  }
  const double step = stepped.minimum() / (steps * blocks), force = forces.minimum() / (steps * contacts);
  std::printf(
      "%8.1f (median %8.1f) ns a contact, %8.1f (median %8.1f) ns a block-step; contacts %.2f a block",
      1e9 * force, 1e9 * forces.median() / (steps * contacts), 1e9 * step,
      1e9 * stepped.median() / (steps * blocks), contacts / blocks);
  return {force, step};
}

void compare(const Packing& packing, double block_steps) {
  std::printf("%s, %zu blocks\n", packing.name, packing.blocks.size());
  constexpr const char* names[] = {"per contact", "per area", "potential"};
  Cost first{};
  for (const int32_t stiffness_kind :
       {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA, HS_STIFFNESS_POTENTIAL}) {
    std::printf("  %-11s rigid  ", names[stiffness_kind]);
    const Cost rigid = cost_of(packing, stiffness_kind, HS_BLOCK_RIGID, block_steps);
    if (stiffness_kind == HS_STIFFNESS_PER_CONTACT) first = rigid;
    std::printf("; over per contact %.2f, %.2f\n", rigid.forces / first.forces, rigid.step / first.step);
    std::printf("  %-11s affine ", "");
    const Cost affine = cost_of(packing, stiffness_kind, HS_BLOCK_AFFINE, block_steps);
    std::printf("; over rigid %.2f, %.2f\n", affine.forces / rigid.forces, affine.step / rigid.step);
    std::fflush(stdout);
  }
}

/// Blocks that overlap fly apart, and knock on each other on the way: contacts change as they seldom do.
void let_go(const Packing& packing, double block_steps) {
  std::printf("%s let go\n", packing.name);
  const double blocks = double(packing.blocks.size());
  const int steps = std::max(2, int(block_steps / blocks));
  double first = 0;
  for (const int32_t stiffness_kind : {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_POTENTIAL}) {
    const Scene scene(packing, stiffness_kind, HS_BLOCK_RIGID, 0);
    scene.step(2);
    const double contacts = double(scene.report().contact_count);
    const double step = seconds_of([&] { scene.step(steps); }) / (steps * blocks);
    if (stiffness_kind == HS_STIFFNESS_PER_CONTACT) first = step;
    std::printf(
        "  %-11s rigid  %8.1f ns a block-step over %d steps; contacts %.2f to %.2f a block; over per contact "
        "%.2f\n",
        stiffness_kind == HS_STIFFNESS_POTENTIAL ? "potential" : "per contact", 1e9 * step, steps,
        contacts / blocks, double(scene.report().contact_count) / blocks, step / first);
  }
}

}  // namespace
}  // namespace halfspace_benchmark

int main(int argc, char** argv) {
  using namespace halfspace_benchmark;
  const bool quick = has_option(argc, argv, "--quick");
  std::printf("libhalfspace %s, core %d\n", hs_version(), pin_to_this_core());
  try {
    const double block_steps = quick ? 1e2 : 3e4;
    compare(quick ? bricks(2, 4, 4, 1) : bricks(2, 30, 30, 1), 2 * block_steps);
    compare(quick ? bricks(3, 3, 3, 3) : bricks(3, 10, 10, 10), block_steps);
    const Packing packed = polyhedra(quick ? 3 : 10);
    compare(packed, block_steps);
    let_go(packed, 50 * block_steps);
    const int count = quick ? 10 : 500;
    compare(couples("polyhedra two and two, overlaps of 1e-2", count, 1e-2), block_steps);
    compare(couples("polyhedra two and two, overlaps of 1e-4", count, 1e-4), block_steps);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_laws: %s\n", error.what());
    return 1;
  }
}
