#include "golden/stage.h"

namespace halfspace_test {
namespace {

/// Four walls and a floor, open above.
void add_box(Stage& stage, double half, double height) {
  const double out = half + 0.5;
  stage.add(stage.cuboid({-out, -out, -0.5}, {out, out, 0}), HS_BLOCK_FIXED);
  stage.add(stage.cuboid({-out, -out, 0}, {-half, out, height}), HS_BLOCK_FIXED);
  stage.add(stage.cuboid({half, -out, 0}, {out, out, height}), HS_BLOCK_FIXED);
  stage.add(stage.cuboid({-half, -out, 0}, {half, -half, height}), HS_BLOCK_FIXED);
  stage.add(stage.cuboid({-half, half, 0}, {half, out, height}), HS_BLOCK_FIXED);
}

/// Hulls of a few random points that fall into a box.
std::uint64_t packing(const LawOfStiffness& of, std::int32_t kind) {
  hs_world_def def = world_def(3);
  def.local_damping = 0.05;
  def.safety = 0.9;
  Stage stage(def);
  stage.elastic_material(2500, elasticity_def(1e8, 1e-5));
  stage.law(law_of(of, 2e6, 0.4));
  add_box(stage, 0.75, 3);
  Random random(42);
  for (int i = 0; i < 12; ++i) {
    const Shape grain = make_hull(stage.context(), random_round_points(random, 5 + 2 * (i % 6), 0.3));
    const Point3 axis = {number_between(random, -1, 1), number_between(random, -1, 1),
                         number_between(random, -1, 1)};
    stage.add(
        grain, kind,
        turned_pose({-0.36 + 0.72 * (i % 2), -0.36 + 0.72 * (i / 2 % 2), 0.42 + 0.72 * (i / 4)}, axis, 0.7),
        {0, 0, -8});
  }
  return stage.run(kind == HS_BLOCK_AFFINE ? 1600 : 800);
}

/// Hulls and bricks fall into a box.
std::uint64_t impulses() {
  Stage stage = stage_of_impulses(world_def(3));
  add_box(stage, 0.75, 3);
  const Shape brick = stage.cuboid({-0.3, -0.2, -0.1}, {0.3, 0.2, 0.1});
  Random random(17);
  for (int i = 0; i < 16; ++i) {
    const Shape grain = make_hull(stage.context(), random_round_points(random, 6 + i % 5, 0.25));
    const Point3 axis = {number_between(random, -1, 1), number_between(random, -1, 1),
                         number_between(random, -1, 1)};
    stage.add(
        i % 2 ? brick : grain, HS_BLOCK_RIGID,
        turned_pose({-0.36 + 0.72 * (i % 2), -0.36 + 0.72 * (i / 2 % 2), 0.42 + 0.72 * (i / 4)}, axis, 0.7),
        {0, 0, -4});
  }
  return stage.run(32);
}

/// Bonded bricks on a floor that goes off sideways, all turned by 36.87 degrees about x.
std::uint64_t wall(const LawOfStiffness& of) {
  hs_world_def def = world_def(3);
  def.gravity[1] = 9.81 * 0.6;
  def.gravity[2] = -9.81 * 0.8;
  Stage stage(def);
  stage.material(2000);
  hs_law_def law = law_of(of, 1e8, 0.5);
  law.cohesion = 3e4;
  law.tensile_strength = 1e4;
  stage.law(law);
  const Shape brick = stage.cuboid({-0.5, -0.25, -0.25}, {0.5, 0.25, 0.25}),
              floor = stage.cuboid({-3, -3, -0.5}, {3, 3, 0.5});
  const auto turned = [](const Point3& p) {
    return turned_pose({p.x, 0.8 * p.y - 0.6 * p.z, 0.6 * p.y + 0.8 * p.z}, {1, 0, 0}, 1.0 / 3);
  };
  stage.add(floor, HS_BLOCK_PRESCRIBED, turned({0, 0, -0.5}), {0.3, 0.8, 0.6}, {0, 0, 0.5});
  for (int row = 0; row < 4; ++row)
    for (int i = 0; i < 3; ++i)
      stage.add(brick, HS_BLOCK_RIGID, turned({i - 1.0 + 0.5 * (row % 2), 0, 0.25 + 0.5 * row}));
  return stage.run(400);
}

/// A cube on a slope of 3 to 4, its shear spring loaded with what holds it.
std::uint64_t preload(const LawOfStiffness& of) {
  Stage stage(world_def(3), law_of(of, 1e8, 0.7));
  const auto up_the_slope = [](const Point3& p) {
    return turned_pose({0.8 * p.x - 0.6 * p.z, p.y, 0.6 * p.x + 0.8 * p.z}, {0, -1, 0}, 1.0 / 3);
  };
  const hs_block slope =
      stage.add(stage.cuboid({-5, -5, -0.5}, {5, 5, 0.5}), HS_BLOCK_FIXED, up_the_slope({0, 0, -0.5}));
  const hs_block block = stage.add(stage.cuboid({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}), HS_BLOCK_RIGID,
                                   up_the_slope({0.1, 0.2, 0.4998}));
  const double along = 0.6 * 9.81 * 2500, shear_force[] = {0.8 * along, 0, 0.6 * along};
  return stage.run_preloaded(slope, block, shear_force, 600);
}

/// A needle that spins by more than 0.06 rad in a step and bounces to and fro without loss.
std::uint64_t needle(const LawOfStiffness& of) {
  Stage stage = stage_without_loss(world_def(3), of);
  add_box(stage, 1, 2);
  stage.add(stage.cuboid({-0.4, -0.02, -0.03}, {0.4, 0.02, 0.03}), HS_BLOCK_RIGID,
            turned_pose({0.1, 0.2, 0.5}, {1, 2, 3}, 0.3), {20, 30, -10}, {100, 900, 1200});
  return stage.run(400);
}

/// A cube that would pass a plate within a step.
std::uint64_t fast(const LawOfStiffness& of, std::int32_t kind) {
  const bool strains = kind == HS_BLOCK_AFFINE;
  Stage stage = stage_of_fast_blocks(world_def(3), law_of(of, strains ? 5e6 : 1e8, 0.3, 0.01));
  stage.add(stage.cuboid({-0.5, -0.5, -0.005}, {0.5, 0.5, 0}), HS_BLOCK_FIXED);
  stage.add(stage.cuboid({-0.05, -0.05, -0.0025}, {0.05, 0.05, 0.0025}), kind,
            turned_pose({0, 0, 0.2}, {2, 1, 0}, 0.02), {20, 10, -150}, {500, 300, 900});
  return stage.run(120);
}

/// Hulls of so many points that the Gauss map and the descent are asked, and that roll.
std::uint64_t round_hulls() {
  Stage stage(world_def(3), law_def(1e6, 0.3));
  stage.add(stage.cuboid({-3, -3, -1}, {3, 3, 0}), HS_BLOCK_FIXED);
  Random random(11);
  for (int i = 0; i < 4; ++i)
    stage.add(make_hull(stage.context(), random_round_points(random, i % 2 ? 60 : 200, 0.4)), HS_BLOCK_RIGID,
              turned_pose({0.9 * (i % 2), 0.1 * i, 0.45 + 0.9 * (i / 2)}, {1, 1, 1}, 0.2 * i), {1, 0, -3},
              {0, 5, 1});
  return stage.run(600);
}

/// Two towers fall asleep; what falls on one of them wakes it.
std::uint64_t towers(const LawOfStiffness& of) {
  Stage stage = stage_of_sleep(world_def(3), of);
  stage.add(stage.cuboid({-4, -4, -1}, {4, 4, 0}), HS_BLOCK_FIXED);
  for (const double x : {-1.5, 0.5})
    for (int i = 0; i < 3; ++i)
      stage.add(stage.cuboid({x + 0.125 * i, 0, double(i)}, {x + 1 + 0.125 * i, 1, i + 1.0}), HS_BLOCK_RIGID);
  stage.add(stage.cuboid({0.5, 0.25, 8}, {1, 0.75, 8.5}), HS_BLOCK_RIGID);
  return stage.run(12000);
}

/// The parts of a cube cut through thrice, let go.
std::uint64_t cut_parts(const LawOfStiffness& of) {
  Stage stage(world_def(3), law_of(of, 2e7, 0.3));
  stage.add(stage.cuboid({-3, -3, -1}, {3, 3, 0}), HS_BLOCK_FIXED);
  std::vector<Shape> parts;
  parts.push_back(stage.cuboid({-1, -1, 0}, {1, 1, 2}));
  const double normals[][3] = {{1, 0.25, 0.5}, {-0.25, 1, 0.375}, {0.25, -0.5, 1}}, at[] = {0.0625, 0.125, 1};
  for (const auto& normal : normals) {
    std::vector<Shape> cut;
    for (const Shape& part : parts) {
      hs_shape *behind = nullptr, *ahead = nullptr;
      stage.ok(hs_shape_cut(part.get(), at, normal, &behind, &ahead));
      cut.push_back(Shape(behind));
      cut.push_back(Shape(ahead));
    }
    parts = std::move(cut);
  }
  for (const Shape& part : parts)
    if (part) stage.add(part, HS_BLOCK_RIGID);
  return stage.run(400);
}

}  // namespace

std::vector<Scene> scenes_in_space() {
  std::vector<Scene> scenes;
  for (const LawOfStiffness& of : laws_of_stiffness) {
    const std::string law = std::string(", ") + of.name;
    scenes.push_back({"space: packing" + law, [&] { return packing(of, HS_BLOCK_RIGID); }});
    scenes.push_back({"space: affine packing" + law, [&] { return packing(of, HS_BLOCK_AFFINE); }});
    scenes.push_back({"space: needle" + law, [&] { return needle(of); }});
    scenes.push_back({"space: fast slab" + law, [&] { return fast(of, HS_BLOCK_RIGID); }});
    scenes.push_back({"space: fast affine slab" + law, [&] { return fast(of, HS_BLOCK_AFFINE); }});
    scenes.push_back({"space: towers asleep" + law, [&] { return towers(of); }});
    scenes.push_back({"space: preload" + law, [&] { return preload(of); }});
    scenes.push_back({"space: cut cube" + law, [&] { return cut_parts(of); }});
    if (of.stiffness_kind != HS_STIFFNESS_POTENTIAL)
      scenes.push_back({"space: bonded wall" + law, [&] { return wall(of); }});
  }
  scenes.push_back({"space: impulses", impulses});
  scenes.push_back({"space: round hulls", round_hulls});
  return scenes;
}

}  // namespace halfspace_test
