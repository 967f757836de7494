// Water and bolts against limit equilibrium: plane failure with a tension crack [Hoek 1981], and a
// wedge on two planes.

#include <cmath>
#include <numbers>

#include "capi/loads.h"
#include "catch.h"

namespace halfspace_test {
namespace {

constexpr double g = 9.81, degree = std::numbers::pi / 180;

/// A slope of 10 m at 60 degrees, a plane at 35 degrees through its toe, and a vertical crack behind its
/// crest.
struct PlaneFailure {
  static constexpr double dip = 35 * degree, height = 10, crack_x = 9, friction_angle = 45 * degree;
  const double crest_x = height / std::tan(60 * degree), foot = crack_x * std::tan(dip),
               crack = height - foot;
  Context context = make_context();
  World world = make_world(context.get(), world_def(2));
  hs_block block = 0;

  PlaneFailure() {
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), 2600, &material), context.get());
    hs_law_def law = law_def(1e10, friction_angle);
    require_ok(hs_world_set_default_law(world.get(), &law), context.get());
    const double rise = std::tan(dip);
    add_block(context.get(), world.get(), {{-4, -4 * rise}, {16, -4 * rise}, {16, 16 * rise}},
              HS_BLOCK_FIXED);
    block = add_block(context.get(), world.get(),
                      {{0, 0}, {crack_x, foot}, {crack_x, height}, {crest_x, height}}, HS_BLOCK_RIGID);
  }
  double weight() const { return state_of(world.get(), block).mass * g; }
};

}  // namespace

TEST_CASE("a plane failure with a tension crack has the factor of safety of Hoek and Bray") {
  const double filled = GENERATE(0.0, 0.5, 1.0);
  PlaneFailure slope;
  const double depth = filled * slope.crack;
  // Between crack and toe the pressure on the plane falls to 0 in proportion.
  if (filled > 0)
    set_water(slope.context.get(), slope.world.get(), {{0, 0, 0}, {slope.crack_x, slope.foot + depth, 0}});
  const double length = slope.crack_x / std::cos(slope.dip), weight = slope.weight();
  const double uplift = 0.5 * 1000 * g * depth * length, thrust = 0.5 * 1000 * g * depth * depth;
  const double normal = weight * std::cos(slope.dip) - uplift - thrust * std::sin(slope.dip);
  const double driving = weight * std::sin(slope.dip) + thrust * std::cos(slope.dip);
  const double expected = normal / driving * std::tan(slope.friction_angle);
  const double found = factor_of_safety(slope.context.get(), slope.world.get(), 0.001);
  CAPTURE(filled, expected, found);
  CHECK(found == Approx(expected).epsilon(0.005));
}

TEST_CASE("a pretensioned bolt raises the factor of safety of a plane failure as limit equilibrium says") {
  PlaneFailure slope;
  const double tension = 0.25 * slope.weight(), plunge = 10 * degree;
  const Point3 head{5, 5, 0};
  const Point3 anchor{head.x + 40 * std::cos(plunge), head.y - 40 * std::sin(plunge), 0};
  hs_bolt_def def = bolt_def(slope.block, head, 0, anchor, 1e4);
  def.pretension = tension;
  add_bolt(slope.context.get(), slope.world.get(), def);
  // The bolt pulls the block into the rock, upwards along the plane.
  const double weight = slope.weight(), angle = slope.dip + plunge;
  const double normal = weight * std::cos(slope.dip) + tension * std::sin(angle);
  const double driving = weight * std::sin(slope.dip) - tension * std::cos(angle);
  const double expected = normal / driving * std::tan(slope.friction_angle);
  const double found = factor_of_safety(slope.context.get(), slope.world.get(), 0.001);
  CAPTURE(expected, found);
  CHECK(found == Approx(expected).epsilon(0.005));
}

TEST_CASE("a bolted wedge on two planes has the factor of safety of limit equilibrium") {
  const bool is_bolted = GENERATE(false, true);
  const Point3 toe{0, 0, 0}, crest{10, 0, 7}, left{6, 5, 7}, right{6, -5, 7};
  Context context = make_context();
  const World world = make_world(context.get(), world_def(3));
  std::int32_t material = -1;
  require_ok(hs_world_add_material(world.get(), 2600, &material), context.get());
  const double friction_angle = 40 * degree;
  hs_law_def law = law_def(1e10, friction_angle);
  require_ok(hs_world_set_default_law(world.get(), &law), context.get());
  const auto add_hull = [&](const Points3& points, std::int32_t kind) {
    hs_shape* shape = nullptr;
    require_ok(hs_polyhedron_create_hull(context.get(), view_of(points), &shape), context.get());
    const Shape owned(shape);
    hs_block_def def = block_def(context.get(), owned, kind);
    return add_block(context.get(), world.get(), owned, def);
  };
  // Behind each plane, a plate whose face is a larger triangle.
  Point3 normals[2];
  const Point3 sides[2] = {left, right};
  for (int i = 0; i < 2; ++i) {
    const Point3 middle = (1.0 / 3) * (toe + crest + sides[i]);
    Point3 normal = cross(crest - toe, sides[i] - toe);
    normal = unit(normal);
    if (dot(normal, sides[1 - i] - toe) < 0) normal = -1.0 * normal;  // into the wedge
    normals[i] = normal;
    Points3 plate;
    for (const Point3& corner : {toe, crest, sides[i]}) {
      plate.push_back(middle + 1.6 * (corner - middle));
      plate.push_back(plate.back() - 3.0 * normal);
    }
    add_hull(plate, HS_BLOCK_FIXED);
  }
  const hs_block wedge = add_hull({toe, crest, left, right}, HS_BLOCK_RIGID);
  const double weight = state_of(world.get(), wedge).mass * g;
  const double tension = is_bolted ? 0.2 * weight : 0;
  const Point3 head{6, 0, 5.5};
  const Point3 into_rock = unit({1, 0.1, -0.3});
  if (is_bolted) {
    hs_bolt_def def = bolt_def(wedge, head, 0, head + 40.0 * into_rock, 1e4);
    def.pretension = tension;
    add_bolt(context.get(), world.get(), def);
  }
  // The resultant across the line of intersection is carried by the normals, the part along it by friction.
  const Point3 load = Point3{0, 0, -weight} + tension * into_rock;
  const Point3 line = unit(toe - crest);
  const double driving = dot(load, line);
  const Point3 across = load - driving * line;
  const double cosine = dot(normals[0], normals[1]), first = -dot(across, normals[0]),
               second = -dot(across, normals[1]);
  const double sum = (first + second) / (1 + cosine);
  const double expected = sum / driving * std::tan(friction_angle);
  const double found = factor_of_safety(context.get(), world.get(), 0.002);
  CAPTURE(is_bolted, expected, found);
  CHECK(found == Approx(expected).epsilon(0.005));
}

}  // namespace halfspace_test
