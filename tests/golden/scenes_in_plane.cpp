#include "golden/stage.h"

namespace halfspace_test {
namespace {

Shape boundary(const Stage& stage, const Point& before, const Point& first, const Point& second,
               const Point& after) {
  const double at[4][3] = {
      {before.x, before.y, 0}, {first.x, first.y, 0}, {second.x, second.y, 0}, {after.x, after.y, 0}};
  hs_shape* shape = nullptr;
  stage.ok(hs_polygon_create_boundary(stage.context(), at[0], at[1], at[2], at[3], 1, &shape));
  return Shape(shape);
}

/// Polygons of 3 to 8 corners that fall into a trough.
std::uint64_t heap(const LawOfStiffness& of, std::int32_t kind) {
  hs_world_def def = world_def();
  def.local_damping = 0.05;
  def.safety = 0.9;
  Stage stage(def);
  stage.elastic_material(2500, elasticity_def(1e8, 1e-5));
  stage.law(law_of(of, 5e7, 0.4));
  stage.add(stage.rectangle({-2, -1}, {2, 0}), HS_BLOCK_FIXED);
  stage.add(stage.rectangle({-2, 0}, {-1, 4}), HS_BLOCK_FIXED);
  stage.add(stage.rectangle({1, 0}, {2, 4}), HS_BLOCK_FIXED);
  Random random(42);
  for (int i = 0; i < 20; ++i) {
    const Shape grain = stage.polygon(random_round_polygon(random, 3 + i % 6, 0.23));
    stage.add(grain, kind,
              turned_pose({-0.75 + 0.5 * (i % 4), 0.25 + 0.5 * (i / 4)}, number_between(random, -2, 2)),
              {0, -8, 0});
  }
  return stage.run(1400);
}

/// Bonded bricks on a floor that goes off sideways, all turned by 36.87 degrees.
std::uint64_t wall(const LawOfStiffness& of) {
  hs_world_def def = world_def();
  def.gravity[0] = 9.81 * 0.6;
  def.gravity[1] = -9.81 * 0.8;
  Stage stage(def);
  stage.material(2000);
  hs_law_def law = law_of(of, 1e8, 0.5);
  law.cohesion = 3e4;
  law.tensile_strength = 1e4;
  stage.law(law);
  const Shape brick = stage.rectangle({-0.5, -0.25}, {0.5, 0.25}),
              floor = stage.rectangle({-4, -0.5}, {4, 0.5});
  const auto turned = [](const Point& p) {
    return turned_pose({0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y}, 1.0 / 3);
  };
  stage.add(floor, HS_BLOCK_PRESCRIBED, turned({0, -0.5}), {0.8, 0.6, 0});
  for (int row = 0; row < 5; ++row)
    for (int i = 0; i < 4; ++i)
      stage.add(brick, HS_BLOCK_RIGID, turned({i - 1.5 + 0.5 * (row % 2), 0.25 + 0.5 * row}));
  return stage.run(800);
}

/// Blocks that slide down a chain of boundary segments.
std::uint64_t boundaries(const LawOfStiffness& of) {
  Stage stage(world_def());
  stage.material(2500);
  hs_law_def law = law_of(of, 1e7, 0.2);
  law.shear_damping = 0;
  stage.law(law);
  const Points chain = {{6, 1}, {3, 0}, {1, 0}, {-1, 0.75}, {-3, 2.5}, {-5, 5}};
  for (std::size_t i = 1; i + 2 < chain.size(); ++i)
    stage.add(boundary(stage, chain[i - 1], chain[i], chain[i + 1], chain[i + 2]), HS_BLOCK_FIXED);
  Random random(7);
  for (int i = 0; i < 4; ++i) {
    const Shape block = stage.polygon(random_round_polygon(random, 4 + i, 0.3));
    stage.add(block, HS_BLOCK_RIGID,
              turned_pose({-2.5 + 0.7 * i, 2.8 - 0.5 * i}, number_between(random, -1, 1)), {1, 0, 0},
              {0, 0, -3});
  }
  return stage.run(1500);
}

/// A block on a slope of 3 to 4, its shear spring loaded with what holds it.
std::uint64_t preload(const LawOfStiffness& of) {
  Stage stage(world_def(), law_of(of, 1e8, 0.7));
  const auto up_the_slope = [](const Point& p) {
    return turned_pose({0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y}, 1.0 / 3);
  };
  const hs_block slope =
      stage.add(stage.rectangle({-5, -0.5}, {5, 0.5}), HS_BLOCK_FIXED, up_the_slope({0, -0.5}));
  const hs_block block =
      stage.add(stage.rectangle({-0.5, -0.5}, {0.5, 0.5}), HS_BLOCK_RIGID, up_the_slope({0.1, 0.4998}));
  const double along = 0.6 * 9.81 * 2500, shear_force[] = {0.8 * along, 0.6 * along, 0};
  return stage.run_preloaded(slope, block, shear_force, 1000);
}

/// A needle that spins by more than 0.06 rad in a step and bounces to and fro without loss.
std::uint64_t needle(const LawOfStiffness& of) {
  Stage stage = stage_without_loss(world_def(), of);
  const Points chain = {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}};
  for (std::size_t i = 0; i < 4; ++i)
    stage.add(boundary(stage, chain[(i + 3) % 4], chain[i], chain[(i + 1) % 4], chain[(i + 2) % 4]),
              HS_BLOCK_FIXED);
  stage.add(stage.rectangle({-0.4, -0.01}, {0.4, 0.01}), HS_BLOCK_RIGID, turned_pose({0.1, 0.2}, 0.3),
            {30, 50, 0}, {0, 0, 1500});
  return stage.run(800);
}

/// A bar that would pass a plate within a step.
std::uint64_t fast(const LawOfStiffness& of, std::int32_t kind) {
  const bool strains = kind == HS_BLOCK_AFFINE;
  Stage stage = stage_of_fast_blocks(world_def(), law_of(of, strains ? 5e7 : 1e9, 0.3, 0.1));
  stage.add(stage.rectangle({-0.5, -0.005}, {0.5, 0}), HS_BLOCK_FIXED);
  stage.add(stage.rectangle({-0.05, -0.0025}, {0.05, 0.0025}), kind, turned_pose({0, 0.2}, 0.02),
            {20, strains ? -150.0 : -300.0, 0}, {0, 0, 900});
  return stage.run(200);
}

/// Two towers fall asleep; what falls on one of them wakes it.
std::uint64_t towers(const LawOfStiffness& of) {
  Stage stage = stage_of_sleep(world_def(), of);
  stage.add(stage.rectangle({-4, -1}, {4, 0}), HS_BLOCK_FIXED);
  for (const double x : {-1.5, 0.5})
    for (int i = 0; i < 3; ++i)
      stage.add(stage.rectangle({x + 0.125 * i, double(i)}, {x + 1 + 0.125 * i, i + 1.0}), HS_BLOCK_RIGID);
  stage.add(stage.rectangle({0.5, 8}, {1, 8.5}), HS_BLOCK_RIGID);
  return stage.run(12000);
}

/// Polygons fall on a wall of bricks beside a chute.
std::uint64_t impulses() {
  Stage stage = stage_of_impulses(world_def());
  stage.add(stage.rectangle({-8, -1}, {8, 0}), HS_BLOCK_FIXED);
  const Shape brick = stage.rectangle({-0.5, -0.25}, {0.5, 0.25});
  for (int row = 0; row < 6; ++row)
    for (int i = 0; i < 5; ++i)
      stage.add(brick, HS_BLOCK_RIGID, turned_pose({i + 0.5 * (row % 2), 0.25 + 0.5 * row}, 0));
  Random random(5);
  for (int i = 0; i < 12; ++i) {
    const Shape block = stage.polygon(random_round_polygon(random, 3 + i % 6, 0.3));
    stage.add(block, HS_BLOCK_RIGID,
              turned_pose({0.7 * (i % 6), 4 + 0.8 * (i / 6)}, number_between(random, -2, 2)), {1, -6, 0});
  }
  return stage.run(40);
}

/// A heap whose forces a host has evaluated, and which it moves on by itself.
std::uint64_t stages() {
  Stage stage(world_def());
  stage.material(1000);
  stage.law(law_def(1e6, 0.3));
  stage.add(stage.rectangle({-2, -1}, {2, 0}), HS_BLOCK_FIXED);
  Random random(3);
  for (int i = 0; i < 6; ++i)
    stage.add(stage.polygon(random_round_polygon(random, 9, 0.5)), HS_BLOCK_RIGID,
              turned_pose({0.3 * (i % 2), 0.4 + 0.7 * i}, 0.1 * i), {0, -1, 0}, {0, 0, 1});
  Hash hash;
  Points forces(7);
  std::vector<hs_pose> poses = poses_of(stage.world());
  for (int k = 0; k < 20; ++k) {
    stage.ok(hs_world_detect(stage.world(), nullptr));
    stage.ok(hs_world_forces(stage.world(), 1e-3, mutable_view_of(forces), {}));
    for (const Point& force : forces) hash.all(force.x, force.y);
    for (const hs_contact& contact : contacts_of(stage.world())) record(hash, contact);
    for (hs_pose& pose : poses) pose.position[1] *= 1 - 0x1p-8;
    stage.ok(hs_world_set_poses(stage.world(), poses.data(), std::int64_t(poses.size())));
  }
  return hash.value();
}

}  // namespace

std::vector<Scene> scenes_in_plane() {
  std::vector<Scene> scenes;
  for (const LawOfStiffness& of : laws_of_stiffness) {
    const std::string law = std::string(", ") + of.name;
    scenes.push_back({"plane: heap" + law, [&] { return heap(of, HS_BLOCK_RIGID); }});
    scenes.push_back({"plane: affine heap" + law, [&] { return heap(of, HS_BLOCK_AFFINE); }});
    scenes.push_back({"plane: boundaries" + law, [&] { return boundaries(of); }});
    scenes.push_back({"plane: needle" + law, [&] { return needle(of); }});
    scenes.push_back({"plane: fast bar" + law, [&] { return fast(of, HS_BLOCK_RIGID); }});
    scenes.push_back({"plane: fast affine bar" + law, [&] { return fast(of, HS_BLOCK_AFFINE); }});
    scenes.push_back({"plane: towers asleep" + law, [&] { return towers(of); }});
    scenes.push_back({"plane: preload" + law, [&] { return preload(of); }});
    if (of.stiffness_kind != HS_STIFFNESS_POTENTIAL)
      scenes.push_back({"plane: bonded wall" + law, [&] { return wall(of); }});
  }
  scenes.push_back({"plane: impulses", impulses});
  scenes.push_back({"plane: stages of a host", stages});
  return scenes;
}

}  // namespace halfspace_test
