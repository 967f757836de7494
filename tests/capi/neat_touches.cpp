// Blocks that are put neatly face to face, edge to edge or corner to corner, to rounding or with a little
// tilt: a step ends well, whatever the law. What goes wrong is seen best under the address sanitizer.

#include <cmath>

#include "capi/extremes.h"

namespace halfspace_test {
namespace {

struct Kinds {
  int dimension;
  std::int32_t law;
  std::int32_t block;  // HS_BLOCK_MESH stands for a body of finite elements
};

struct PlacedBox {
  double sides[3];
  Point3 place;
};

template <class T, std::size_t N>
T one_of(Random& random, const T (&values)[N]) {
  return values[random() % N];
}

/// 0, or of any size between rounding and what is seen.
double little(Random& random) { return random() % 3 == 0 ? 0 : any_size(random, -12, -2); }
double little_either_way(Random& random) { return (random() % 2 ? 1 : -1) * little(random); }

/// Face to face along one axis at least; along the others flush with one of its ends, its middle, or just
/// past it, so that they meet along an edge or at a corner.
PlacedBox next_to(const PlacedBox& other, int dimension, Random& random) {
  PlacedBox next{{1, 1, 1}, other.place};
  double* const place[] = {&next.place.x, &next.place.y, &next.place.z};
  const std::uint64_t touched = random() % std::uint64_t(dimension);
  for (int axis = 0; axis < dimension; ++axis) {
    double& side = next.sides[axis];
    side = one_of(random, {0.5, 1.0, 1.0, 2.0});
    const double outside = 0.5 * (other.sides[axis] + side), inside = 0.5 * (other.sides[axis] - side);
    const double way =
        std::uint64_t(axis) == touched ? outside : one_of(random, {0.0, inside, outside, outside});
    *place[axis] += (random() % 2 ? 1 : -1) * way + little_either_way(random);
  }
  return next;
}

Shape shape_of(hs_context* context, const PlacedBox& box, int dimension) {
  const double x = 0.5 * box.sides[0], y = 0.5 * box.sides[1], z = 0.5 * box.sides[2];
  return dimension == 2 ? make_shape(context, halfspace_test::box(-x, -y, x, y))
                        : make_polyhedron(context, box_3d({-x, -y, -z}, {x, y, z}));
}

/// Turned by a little, and often by a quarter before, about some axis.
hs_pose little_turned(const Point3& place, int dimension, Random& random) {
  const double quarters = dimension == 2 ? double(random() % 4) * std::acos(0.0) : 0;
  const Point3 axis = dimension == 2 ? Point3{0, 0, 1} : random_direction(random);
  return pose_at(place, axis, quarters + little_either_way(random));
}

void add_row(hs_context* context, hs_world* world, const Kinds& kinds, Random& random) {
  std::vector<PlacedBox> boxes;
  for (std::uint64_t count = 2 + random() % 3; count > 0; --count) {
    const PlacedBox box = boxes.empty() ? PlacedBox{{1, 1, 1}, {0, 0, 0}}
                                        : next_to(boxes[random() % boxes.size()], kinds.dimension, random);
    hs_pose pose = little_turned(box.place, kinds.dimension, random);
    const std::int32_t kind = boxes.empty() && random() % 2 ? HS_BLOCK_FIXED : kinds.block;
    boxes.push_back(box);
    if (kind == HS_BLOCK_MESH) {
      (void)add_body(context, world, bar(kinds.dimension, 0.5), body_def(pose));
      continue;
    }
    add_block(context, world, shape_of(context, box, kinds.dimension), kind, pose);
  }
}

World world_of(hs_context* context, const Kinds& kinds, Random& random) {
  hs_world_def def = world_def(kinds.dimension);
  def.time_step = 1e-6;
  World world = make_world(context, def);
  std::int32_t material = 0;
  require_ok(hs_world_add_material(world.get(), 2500, &material), context);
  const hs_elasticity_def elasticity = elasticity_def(1e8, 1e-6);
  require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context);
  hs_law_def law = law_def(1e8, 0.5);
  law.stiffness_kind = kinds.law;
  law.normal_damping = 0.1;
  const bool bonds = random() % 4 == 0 && kinds.law != HS_STIFFNESS_POTENTIAL;
  if (bonds) law.tensile_strength = law.cohesion = 1e4;
  require_ok(hs_world_set_default_law(world.get(), &law), context);
  return world;
}

bool is_of_numbers(hs_world* world) {
  const hs_world_report report = report_of(world);
  bool all = std::isfinite(report.energy.residual) && std::isfinite(report.largest_speed);
  for (const hs_pose& pose : poses_of(world))
    for (const double x : pose.position) all = all && std::isfinite(x);
  return all;
}

/// How many worlds of so many have had contacts.
int step_neat_worlds(const Kinds& kinds, int worlds) {
  Random random(std::uint64_t(100 * kinds.dimension + 10 * kinds.law + kinds.block));
  int in_contact = 0;
  for (int i = 0; i < worlds; ++i) {
    const Context context = make_context();
    const World world = world_of(context.get(), kinds, random);
    add_row(context.get(), world.get(), kinds, random);
    const hs_status status = hs_world_step(world.get(), 3);
    INFO(kinds.dimension << "D, law " << kinds.law << ", blocks of kind " << kinds.block << ", world " << i);
    INFO(hs_status_string(status) << ": " << hs_context_last_error(context.get()));
    CHECK(status == HS_OK);
    CHECK(is_of_numbers(world.get()));
    in_contact += !contacts_of(world.get()).empty();
  }
  return in_contact;
}

}  // namespace

TEST_CASE("blocks that are put neatly side by side are stepped by every law") {
  constexpr int worlds = 60;
  for (const int dimension : {2, 3})
    for (const std::int32_t law : all_laws)
      for (const std::int32_t block : {HS_BLOCK_RIGID, HS_BLOCK_AFFINE, HS_BLOCK_MESH})
        CHECK(step_neat_worlds({dimension, law, block}, worlds) > 0);
}

TEST_CASE("two cubes that meet along an edge to within 2e-7 press each other hardly by potentials") {
  const Context context = make_context();
  hs_world_def def = world_def(3);
  def.time_step = 1e-6;
  def.potential_length = 1;
  const World world = make_world(context.get(), def);
  std::int32_t material = 0;
  require_ok(hs_world_add_material(world.get(), 2500, &material), context.get());
  constexpr double stiffness = 1e8;
  hs_law_def law = law_def(stiffness, 0);
  law.stiffness_kind = HS_STIFFNESS_POTENTIAL;
  law.normal_damping = law.shear_damping = 0;
  require_ok(hs_world_set_default_law(world.get(), &law), context.get());
  const hs_pose poses[] = {
      {{0, 0, 0},
       {-2.5338465511719416e-07, 5.7658206871446654e-09, -4.3971443015241705e-07, 0.99999999999987121}},
      {{0.99999980812018474, -3.6259184456052981e-07, 0.99999958671454969},
       {3.3524689395136474e-07, -7.9884906026823773e-09, 1.7446668937827105e-07, 0.9999999999999285}}};
  hs_block blocks[2];
  for (int i = 0; i < 2; ++i)
    blocks[i] = add_block(context.get(), world.get(), make_polyhedron(context.get(), cube()),
                          i == 0 ? HS_BLOCK_FIXED : HS_BLOCK_RIGID, poses[i]);
  REQUIRE(hs_world_step(world.get(), 3) == HS_OK);
  // The potential of each block has a slope of at most 1. They share at most a prism along the edge of 1 m,
  // as wide and high as the centroids are nearer than 1 m, 4.1e-7, and as they are turned, 1.2e-6, over half
  // the edge.
  constexpr double width = 4.2e-7 + 0.5 * 1.3e-6;
  const hs_block_state state = state_of(world.get(), blocks[1]);
  for (const double force : state.force) CHECK(std::abs(force) <= 2 * stiffness * width * width);
}

}  // namespace halfspace_test
