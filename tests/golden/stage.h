#pragma once

// A world that a scene is built in. All that goes into it is made by sums, products, quotients and square
// roots of given numbers, which round alike everywhere, and by one random number at a time: the arguments of
// a call are worked out in any order.

#include <cmath>
#include <functional>
#include <random>

#include "capi/polyhedra.h"
#include "capi/world_fixture.h"
#include "golden/record.h"

namespace halfspace_test {

/// A number of 53 bits; the distributions of the C++ library may differ.
inline double number_between(Random& random, double from, double to) {
  return from + (to - from) * (double(random() >> 11) * 0x1p-53);
}

/// A turn about an axis of any length by the angle whose half has this tangent.
inline hs_pose turned_pose(const Point3& position, const Point3& axis, double tangent_of_half) {
  const double w = 1 / std::sqrt(1 + tangent_of_half * tangent_of_half);
  const Point3 v = tangent_of_half * w * unit(axis);
  return {{position.x, position.y, position.z}, {v.x, v.y, v.z, w}};
}

inline hs_pose turned_pose(const Point& position, double tangent_of_half) {
  return turned_pose({position.x, position.y, 0}, {0, 0, 1}, tangent_of_half);
}

/// Corners on a circle, none near another.
inline Points random_round_polygon(Random& random, int corners, double radius) {
  Points points;
  for (int k = 0; k < corners; ++k) {
    // Whole quarters of the circle, and the tangent of half of what is left of the angle.
    const double quarters = (k + number_between(random, 0, 0.5)) * 4 / corners;
    const int whole = int(quarters);
    const double t = quarters - whole;
    const double x = radius * (1 - t * t) / (1 + t * t), y = radius * 2 * t / (1 + t * t);
    const Point turned[] = {{x, y}, {-y, x}, {-x, -y}, {y, -x}};
    points.push_back(turned[whole]);
  }
  return points;
}

inline Points3 random_round_points(Random& random, int count, double radius) {
  Points3 points;
  while (int(points.size()) < count) {
    const Point3 p = {number_between(random, -1, 1), number_between(random, -1, 1),
                      number_between(random, -1, 1)};
    if (length(p) > 0.1 && length(p) <= 1) points.push_back(radius * unit(p));
  }
  return points;
}

class Stage {
 public:
  explicit Stage(const hs_world_def& def) : world_(make_world(context(), def)) {}
  /// With a material, and a law for it.
  Stage(const hs_world_def& def, const hs_law_def& of_material) : Stage(def) {
    material(2500);
    law(of_material);
  }

  hs_context* context() const { return context_.get(); }
  hs_world* world() const { return world_.get(); }
  void ok(hs_status status) const { require_ok(status, context()); }

  std::int32_t material(double density) {
    std::int32_t material = -1;
    ok(hs_world_add_material(world(), density, &material));
    return material;
  }
  std::int32_t elastic_material(double density, const hs_elasticity_def& elasticity) {
    const std::int32_t added = material(density);
    ok(hs_world_set_elasticity(world(), added, &elasticity));
    return added;
  }
  void law(const hs_law_def& def) { ok(hs_world_set_default_law(world(), &def)); }

  hs_block add(const Shape& shape, std::int32_t kind, const hs_pose* pose = nullptr,
               const Point3& velocity = {}, const Point3& spin = {}) {
    hs_block_def def;
    ok(hs_block_def_init(&def, sizeof def, shape.get()));
    def.kind = kind;
    if (pose) def.pose = *pose;
    const double v[] = {velocity.x, velocity.y, velocity.z}, w[] = {spin.x, spin.y, spin.z};
    std::memcpy(def.velocity, v, sizeof v);
    std::memcpy(def.angular_velocity, w, sizeof w);
    hs_block block = 0;
    ok(hs_world_add_block(world(), shape.get(), &def, &block));
    blocks_.push_back(block);
    return block;
  }
  hs_block add(const Shape& shape, std::int32_t kind, const hs_pose& pose, const Point3& velocity = {},
               const Point3& spin = {}) {
    return add(shape, kind, &pose, velocity, spin);
  }

  Shape polygon(const Points& vertices) const { return make_shape(context(), vertices); }
  Shape rectangle(const Point& low, const Point& high) const {
    return polygon(halfspace_test::box(low.x, low.y, high.x, high.y));
  }
  Shape cuboid(const Point3& low, const Point3& high) const {
    return make_polyhedron(context(), box_3d(low, high));
  }

  /// Steps on and records, several times over.
  std::uint64_t run(std::int64_t steps, int times = 4) {
    Hash hash;
    for (int i = 0; i < times; ++i) {
      ok(hs_world_step(world(), steps / times));
      record(hash, world(), blocks_);
    }
    return hash.value();
  }
  /// The same from where a shear spring holds the block on the slope.
  std::uint64_t run_preloaded(hs_block slope, hs_block block, const double (&shear_force)[3],
                              std::int64_t steps) {
    ok(hs_world_detect(world(), nullptr));
    ok(hs_world_set_shear_force(world(), slope, block, shear_force));
    return run(steps);
  }

 private:
  Context context_ = make_context();
  World world_;
  std::vector<hs_block> blocks_;
};

/// A run that has a name, and what it shows.
struct Scene {
  std::string name;
  std::function<std::uint64_t()> hash;
};

/// The laws by the names that scenes have for them.
struct LawOfStiffness {
  const char* name;
  std::int32_t stiffness_kind;
};
inline constexpr LawOfStiffness laws_of_stiffness[] = {{"per contact", HS_STIFFNESS_PER_CONTACT},
                                                       {"per area", HS_STIFFNESS_PER_AREA},
                                                       {"potential", HS_STIFFNESS_POTENTIAL}};

/// Stiffness in N/m of faces of that area that meet.
inline hs_law_def law_of(const LawOfStiffness& of, double stiffness, double friction_angle,
                         double area = 0.5) {
  hs_law_def law =
      law_def(of.stiffness_kind == HS_STIFFNESS_PER_CONTACT ? stiffness : stiffness / area, friction_angle);
  law.stiffness_kind = of.stiffness_kind;
  return law;
}

/// A stage on which a block bounces to and fro without loss.
inline Stage stage_without_loss(hs_world_def def, const LawOfStiffness& of) {
  def.time_step = 1e-4;
  hs_law_def law = law_of(of, 1e7, 0);
  law.normal_damping = law.shear_damping = 0;
  return Stage(def, law);
}

/// A stage with a step in which a fast block would pass a plate, for blocks that strain as well.
inline Stage stage_of_fast_blocks(hs_world_def def, const hs_law_def& law) {
  def.time_step = 1e-5;
  def.mass_damping = 0.5;
  Stage stage(def);
  stage.elastic_material(2500, elasticity_def(1e8, 1e-6));
  stage.law(law);
  return stage;
}

/// A stage whose blocks may sleep, and soon do.
inline Stage stage_of_sleep(hs_world_def def, const LawOfStiffness& of) {
  def.sleep_tolerance = 2e-3;
  def.local_damping = 0.5;
  hs_law_def law = law_of(of, 1e7, 0.5);
  law.normal_damping = law.shear_damping = 0.5;
  return Stage(def, law);
}

/// A stage for rigid blocks without springs at a step of 1/64 s, which rebound a little.
inline Stage stage_of_impulses(hs_world_def def) {
  def.time_step = 0x1p-6;
  def.locate_impacts = 1;
  hs_law_def law = law_def(1, 0.4);
  law.stiffness_kind = HS_STIFFNESS_NONE;
  law.restitution = 0.25;
  Stage stage(def);
  stage.material(2500);
  stage.law(law);
  return stage;
}

std::vector<Scene> scenes_in_plane();
std::vector<Scene> scenes_in_space();
std::vector<Scene> scenes_of_meshes();
std::vector<Scene> scenes_of_pairs();

}  // namespace halfspace_test
