#include "settled_scenes.h"

#include <random>

#include "random_polygon.h"

namespace halfspace_benchmark {

using halfspace_test::require_ok;

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

namespace {

Scene wall(const char* name, int dimension, const Triple& size, int columns, int courses, double shift) {
  const int up = dimension - 1;
  const double pitch = 1.001 * size[0];
  Scene scene{name, dimension, size[0], {}};
  Triple lower{-size[0], -size[1], 0}, upper{(columns + 1) * pitch, 2 * size[1], 0};
  lower[std::size_t(up)] = -1;
  upper[std::size_t(up)] = 0;
  scene.add(HS_BLOCK_FIXED, box_of(dimension, lower, upper));
  for (int i = 0; i < columns * courses; ++i) {
    const int course = i / columns;
    Triple low{(i % columns + shift * (course % 2)) * pitch, 0, 0};
    low[std::size_t(up)] = course * size[std::size_t(up)];
    scene.add(HS_BLOCK_RIGID, box_of(dimension, low, {low[0] + size[0], low[1] + size[1], low[2] + size[2]}));
  }
  return scene;
}

}  // namespace

Scene polygons(int columns, int rows) {
  constexpr double radius = 0.0115, pitch = 2.1 * radius, wall = 0.01;
  const double width = columns * pitch, height = rows * pitch;
  Scene scene{"polygons", 2, 2 * radius, {}};
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

Scene bricks(int columns, int courses, double shift) {
  return wall("bricks", 2, {0.2, 0.1, 0}, columns, courses, shift);
}

Scene cubes(int columns, int courses, double shift) {
  return wall("cubes", 3, {0.2, 0.2, 0.2}, columns, courses, shift);
}

Scene polyhedra(int side, int layers) {
  const double width = side, height = 1.2 * layers;
  Scene scene{"polyhedra", 3, 1, {}};
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

hs_law_def law_of(std::int32_t stiffness_kind, double stiffness) {
  hs_law_def law{};
  require_ok(hs_law_def_init(&law, sizeof law), nullptr);
  law.stiffness_kind = stiffness_kind;
  law.normal_stiffness = law.shear_stiffness = stiffness;
  law.friction_angle = 0.45;
  law.normal_damping = law.shear_damping = 0.2;
  return law;
}

halfspace_test::World make_world(hs_context* context, int dimension, double time_step,
                                 const hs_law_def& law) {
  hs_world_def def{};
  require_ok(hs_world_def_init(&def, sizeof def, dimension), context);
  def.dimension = dimension;
  def.gravity[0] = def.gravity[1] = def.gravity[2] = 0;
  def.gravity[dimension - 1] = -9.81;
  def.time_step = time_step;
  def.local_damping = 0.3;
  hs_world* made = nullptr;
  require_ok(hs_world_create(context, &def, &made), context);
  halfspace_test::World world(made);
  require_ok(hs_world_set_default_law(made, &law), context);
  std::int32_t material = 0;
  require_ok(hs_world_add_material(made, 2500, &material), context);
  return world;
}

hs_block add_block(hs_context* context, hs_world* world, int dimension, const Block& block,
                   const hs_pose* pose) {
  hs_shape* made = nullptr;
  require_ok(dimension == 2 ? hs_polygon_create(context, view_of(block.corners), &made)
                            : hs_polyhedron_create_hull(context, view_of(block.corners), &made),
             context);
  const halfspace_test::Shape shape(made);
  hs_block_def def{};
  require_ok(hs_block_def_init(&def, sizeof def, made), context);
  def.kind = block.kind;
  if (pose) def.pose = *pose;
  hs_block id = 0;
  require_ok(hs_world_add_block(world, made, &def, &id), context);
  return id;
}

}  // namespace halfspace_benchmark
