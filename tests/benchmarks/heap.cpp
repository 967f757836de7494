#include "heap.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace halfspace_benchmark {
namespace {

using halfspace_test::require_ok;
using halfspace_test::Shape;
using halfspace_test::World;

constexpr double radius = 0.0115;           // of the triangles' circumcircle: edges of about 0.02 m
constexpr double pitch = 2.1 * radius;      // of the grains before they fall: they cannot overlap
constexpr double friction = 25 * pi / 180;  // Wang et al. 2021, section 4.4
constexpr double stiffness = 1e7;           // a tenth of the paper's, so that the heap is at rest sooner
constexpr double density = 2500;

World make_world(hs_context* context) {
  hs_world_def def;
  hs_world_def_init(&def, sizeof def, 2);
  def.local_damping = 0.3;
  hs_world* world = nullptr;
  require_ok(hs_world_create(context, &def, &world), context);
  World owned(world);

  hs_law_def law;
  hs_law_def_init(&law, sizeof law);
  law.normal_stiffness = law.shear_stiffness = stiffness;
  law.friction_angle = friction;
  law.normal_damping = law.shear_damping = 0.2;
  require_ok(hs_world_set_default_law(world, &law), context);
  std::int32_t material = 0;
  require_ok(hs_world_add_material(world, density, &material), context);
  return owned;
}

hs_block add_block(hs_context* context, hs_world* world, const hs_shape* shape, int kind,
                   const hs_pose* pose) {
  hs_block_def def;
  hs_block_def_init(&def, sizeof def, shape);
  def.kind = kind;
  if (pose) def.pose = *pose;
  hs_block block = 0;
  require_ok(hs_world_add_block(world, shape, &def, &block), context);
  return block;
}

hs_block add_box(hs_context* context, hs_world* world, const Box& box) {
  const Shape shape =
      halfspace_test::make_shape(context, halfspace_test::box(box.low.x, box.low.y, box.high.x, box.high.y));
  return add_block(context, world, shape.get(), HS_BLOCK_FIXED, nullptr);
}

hs_pose pose_of(const Grain& grain, double shift) {
  return halfspace_test::pose_at(grain.position.x + shift, grain.position.y, std::sin(grain.angle / 2),
                                 std::cos(grain.angle / 2));
}

std::vector<Shape> shapes_of(hs_context* context, const Bin& bin) {
  std::vector<Shape> shapes;
  for (const Grain& grain : bin.grains) shapes.push_back(halfspace_test::make_shape(context, grain.vertices));
  return shapes;
}

/// The bin's walls and grains by their ids, in worlds of one bin or many.
struct Ids {
  hs_block floor = 0;
  std::vector<hs_block> walls;   ///< one more than bins
  std::vector<hs_block> grains;  ///< bin by bin

  hs_block of(int part, std::size_t bin, std::size_t grains_per_bin) const {
    if (part == floor_wall) return floor;
    if (part == left_wall) return walls[bin];
    if (part == right_wall) return walls[bin + 1];
    return grains[bin * grains_per_bin + std::size_t(part)];
  }
};

/// The order by hs_points_order_along_curve(), from grains at random.
void order_along_curve(hs_context* context, const std::vector<hs_pose>& poses,
                       std::vector<std::size_t>& order) {
  halfspace_test::Points places;
  for (const std::size_t i : order) places.push_back({poses[i].position[0], poses[i].position[1]});
  std::vector<int32_t> along(order.size());
  require_ok(hs_points_order_along_curve(context, 2, halfspace_test::view_of(places), along.data()), context);
  const std::vector<std::size_t> given = order;
  std::transform(along.begin(), along.end(), order.begin(), [&](int32_t i) { return given[std::size_t(i)]; });
}

Ids fill(hs_context* context, hs_world* world, const Bin& bin, int bins, Order wanted, Random& random) {
  Ids ids;
  ids.floor = add_box(context, world, floor_of(bin, bins));
  for (int i = 0; i <= bins; ++i) ids.walls.push_back(add_box(context, world, wall_of(bin, i)));

  const std::vector<Shape> shapes = shapes_of(context, bin);
  ids.grains.resize(std::size_t(bins) * shapes.size());
  std::vector<std::size_t> order(ids.grains.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::vector<hs_pose> poses;
  for (std::size_t i = 0; i < order.size(); ++i)
    poses.push_back(pose_of(bin.grains[i % shapes.size()], double(i / shapes.size()) * spacing(bin)));
  if (wanted != Order::bin_by_bin) std::shuffle(order.begin(), order.end(), random);
  if (wanted == Order::along_curve) order_along_curve(context, poses, order);
  for (const std::size_t i : order)
    ids.grains[i] = add_block(context, world, shapes[i % shapes.size()].get(), HS_BLOCK_RIGID, &poses[i]);
  return ids;
}

std::vector<ShearSpring> springs_of(const hs_world* world, hs_context* context, const Ids& ids) {
  std::unordered_map<hs_block, int> part{
      {ids.floor, floor_wall}, {ids.walls[0], left_wall}, {ids.walls[1], right_wall}};
  for (std::size_t i = 0; i < ids.grains.size(); ++i) part[ids.grains[i]] = int(i);
  std::int64_t count = 0;
  (void)hs_world_get_contacts(world, nullptr, 0, &count);  // which tells how many there are
  std::vector<hs_contact> contacts(static_cast<std::size_t>(count));
  require_ok(hs_world_get_contacts(world, contacts.data(), count, nullptr), context);
  std::vector<ShearSpring> springs;
  for (const hs_contact& c : contacts)
    springs.push_back(
        {part.at(c.block_a), part.at(c.block_b), {c.shear_force[0], c.shear_force[1], c.shear_force[2]}});
  return springs;
}

/// A contact at the edge of touching may be gone by a rounding where its bin stands now; its spring bears
/// nothing then.
void preload(hs_context* context, hs_world* world, const Bin& bin, int bins, const Ids& ids) {
  require_ok(hs_world_detect(world, nullptr), context);
  for (std::size_t i = 0; i < std::size_t(bins); ++i) {
    for (const ShearSpring& spring : bin.springs) {
      const hs_status status = hs_world_set_shear_force(world, ids.of(spring.a, i, bin.grains.size()),
                                                        ids.of(spring.b, i, bin.grains.size()), spring.force);
      if (status != HS_ERROR_STALE_ID) require_ok(status, context);
    }
  }
}

Bin loose_bin(hs_context* context, int columns, int rows, Random& random) {
  Bin bin{columns * pitch, rows * pitch, {}, {}, 0, 0};
  for (int i = 0; i < columns * rows; ++i) {
    Points vertices = random_polygon(3, radius, random);
    const Shape shape = halfspace_test::make_shape(context, vertices);
    const hs_shape_properties properties = halfspace_test::properties_of(shape.get());
    for (Point& p : vertices) p = {p.x - properties.centroid[0], p.y - properties.centroid[1]};
    // The circumcircle keeps clear of the neighbours' and of the walls; the centroid is off its centre.
    const double angle = uniform(random, -pi, pi), c = std::cos(angle), s = std::sin(angle);
    const Point off{c * properties.centroid[0] - s * properties.centroid[1],
                    s * properties.centroid[0] + c * properties.centroid[1]};
    bin.grains.push_back(
        {vertices, {(i % columns + 0.5) * pitch + off.x, (i / columns + 0.5) * pitch + off.y}, angle});
  }
  return bin;
}

}  // namespace

Box floor_of(const Bin& bin, int bins) {
  return {{-wall_thickness, -wall_thickness}, {bins * spacing(bin), 0}};
}

Box wall_of(const Bin& bin, int index) {
  const double right = index * spacing(bin);
  return {{right - wall_thickness, 0}, {right, bin.height}};
}

Bin settle_bin(int columns, int rows, double most_time, Random& random) {
  const halfspace_test::Context context = halfspace_test::make_context();
  Bin bin = loose_bin(context.get(), columns, rows, random);
  const World world = make_world(context.get());
  const Ids ids = fill(context.get(), world.get(), bin, 1, Order::bin_by_bin, random);

  hs_world_report report;
  do {
    require_ok(hs_world_step(world.get(), 500), context.get());
    require_ok(hs_world_get_report(world.get(), &report, sizeof report), context.get());
  } while (report.time < most_time && report.largest_speed > 1e-3);
  bin.settling_time = report.time;
  bin.largest_speed = report.largest_speed;

  for (std::size_t i = 0; i < bin.grains.size(); ++i) {
    hs_block_state state;
    require_ok(hs_world_get_block_state(world.get(), ids.grains[i], &state), context.get());
    bin.grains[i].position = {state.pose.position[0], state.pose.position[1]};
    bin.grains[i].angle = 2 * std::atan2(state.pose.rotation[2], state.pose.rotation[3]);
  }
  bin.springs = springs_of(world.get(), context.get(), ids);
  return bin;
}

World make_heap(hs_context* context, const Bin& bin, int bins, Order order, Random& random) {
  World world = make_world(context);
  preload(context, world.get(), bin, bins, fill(context, world.get(), bin, bins, order, random));
  return world;
}

}  // namespace halfspace_benchmark
