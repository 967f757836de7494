#pragma once

// Worlds that several tests start from.

#include <cmath>
#include <random>
#include <vector>

#include "capi/handles.h"

namespace halfspace_test {

inline hs_world_def world_def(int32_t dimension = 2) {
  hs_world_def def;
  if (hs_world_def_init(&def, sizeof def, dimension) != HS_OK)
    throw std::runtime_error("no world definition");
  return def;
}

inline hs_law_def law_def(double stiffness, double friction_angle) {
  hs_law_def def;
  if (hs_law_def_init(&def, sizeof def) != HS_OK) throw std::runtime_error("no law definition");
  def.normal_stiffness = stiffness;
  def.shear_stiffness = stiffness;
  def.friction_angle = friction_angle;
  return def;
}

inline hs_elasticity_def elasticity_def(double young_modulus, double damping_time = 0) {
  hs_elasticity_def def;
  if (hs_elasticity_def_init(&def, sizeof def) != HS_OK) throw std::runtime_error("no elasticity definition");
  def.young_modulus = young_modulus;
  def.damping_time = damping_time;
  return def;
}

inline World make_world(hs_context* context, const hs_world_def& def) {
  hs_world* world = nullptr;
  require_ok(hs_world_create(context, &def, &world), context);
  return World(world);
}

inline hs_block_def block_def(hs_context* context, const Shape& shape, std::int32_t kind) {
  hs_block_def def;
  require_ok(hs_block_def_init(&def, sizeof def, shape.get()), context);
  def.kind = kind;
  return def;
}

inline hs_block add_block(hs_context* context, hs_world* world, const Shape& shape, const hs_block_def& def) {
  hs_block block = 0;
  require_ok(hs_world_add_block(world, shape.get(), &def, &block), context);
  return block;
}

/// Where its vertices are given.
inline hs_block add_block(hs_context* context, hs_world* world, const Points& vertices, std::int32_t kind,
                          std::int32_t material = 0) {
  const Shape shape = make_shape(context, vertices);
  hs_block_def def = block_def(context, shape, kind);
  def.material = material;
  return add_block(context, world, shape, def);
}

inline hs_block add_block(hs_context* context, hs_world* world, const Shape& shape, std::int32_t kind,
                          const hs_pose& pose) {
  hs_block_def def = block_def(context, shape, kind);
  def.pose = pose;
  return add_block(context, world, shape, def);
}

inline std::vector<unsigned char> saved(const hs_world* world) {
  std::size_t size = 0;
  (void)hs_world_save(world, nullptr, 0, &size);
  std::vector<unsigned char> bytes(size);
  if (hs_world_save(world, bytes.data(), bytes.size(), &size) != HS_OK) throw std::runtime_error("not saved");
  return bytes;
}

inline World restored(hs_context* context, const std::vector<unsigned char>& bytes) {
  hs_world* world = nullptr;
  require_ok(hs_world_restore(context, bytes.data(), bytes.size(), &world), context);
  return World(world);
}

inline hs_world_report report_of(hs_world* world) {
  hs_world_report report{};
  if (hs_world_get_report(world, &report, sizeof report) != HS_OK) throw std::runtime_error("no report");
  return report;
}

inline hs_block_state state_of(const hs_world* world, hs_block block) {
  hs_block_state state{};
  if (hs_world_get_block_state(world, block, &state) != HS_OK) throw std::runtime_error("no block state");
  return state;
}

inline std::vector<hs_pose> poses_of(const hs_world* world) {
  std::int64_t count = 0;
  (void)hs_world_get_poses(world, nullptr, 0, &count);
  std::vector<hs_pose> poses(static_cast<std::size_t>(count));
  if (hs_world_get_poses(world, poses.data(), count, nullptr) != HS_OK) throw std::runtime_error("no poses");
  return poses;
}

inline std::vector<hs_contact> contacts_of(const hs_world* world) {
  std::int64_t count = 0;
  (void)hs_world_get_contacts(world, nullptr, 0, &count);
  std::vector<hs_contact> contacts(static_cast<std::size_t>(count));
  if (hs_world_get_contacts(world, contacts.data(), count, nullptr) != HS_OK)
    throw std::runtime_error("no contacts");
  return contacts;
}

/// A box on a fixed floor, pressed in by its weight over two springs' worth, and one more box far away.
struct TwoBoxes {
  Context context = make_context();
  World world;
  std::int32_t material = -1;
  hs_block floor = 0, box_on_floor = 0, box_away = 0;

  explicit TwoBoxes(double friction_angle = 0.5, hs_world_def def = world_def()) {
    world = make_world(context.get(), def);
    require_ok(hs_world_add_material(world.get(), 2000, &material), context.get());
    const hs_law_def law = law_def(1e8, friction_angle);
    require_ok(hs_world_set_default_law(world.get(), &law), context.get());
    const double sink = 1 * 2000 * 9.81 / 1e8;
    floor = add_block(context.get(), world.get(), box(-5, -1, 5, 0), HS_BLOCK_FIXED);
    box_on_floor = add_block(context.get(), world.get(), box(-0.5, -sink, 0.5, 1 - sink), HS_BLOCK_RIGID);
    box_away = add_block(context.get(), world.get(), box(2, 3, 3, 4), HS_BLOCK_RIGID);
  }
};

/// Steps until `seconds` have passed, however long a step is.
inline void run(hs_context* context, hs_world* world, double seconds) {
  const double time_step = report_of(world).time_step;
  require_ok(hs_world_step(world, std::int64_t(std::ceil(seconds / time_step))), context);
}

/// How a block is turned and strained.
inline hs_deformation deformation_of(const hs_world* world, hs_block block) {
  hs_deformation deformation{};
  if (hs_world_get_deformation(world, block, &deformation) != HS_OK)
    throw std::runtime_error("no deformation");
  return deformation;
}

/// What a pile is made of.
struct PileOf {
  std::int32_t kind = HS_BLOCK_RIGID;
  std::int32_t stiffness_kind = HS_STIFFNESS_PER_CONTACT;
};

/// Random convex polygons that fall into a trough and pile up there.
struct Pile {
  World world;
  std::vector<hs_block> blocks;

  Pile(hs_context* context, int count, hs_world_def def = world_def(), PileOf of = {}) {
    world = make_world(context, def);
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), 2500, &material), context);
    const hs_elasticity_def elasticity = elasticity_def(1e8, 1e-5);
    require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context);
    hs_law_def law = law_def(5e7, 0.4);
    law.normal_damping = 0.2;
    law.shear_damping = 0.1;
    law.stiffness_kind = of.stiffness_kind;
    require_ok(hs_world_set_default_law(world.get(), &law), context);
    for (const Points& wall : {box(-4, -1, 4, 0), box(-4, 0, -3, 8), box(3, 0, 4, 8)}) {
      blocks.push_back(add_block(context, world.get(), wall, HS_BLOCK_FIXED));
    }
    std::mt19937_64 random(42);
    const auto uniform = [&](double from, double to) {
      return std::uniform_real_distribution<double>(from, to)(random);
    };
    for (int i = 0; i < count; ++i) {
      const double x = -2.4 + 0.8 * (i % 7), y = 0.45 + 0.8 * (i / 7);
      const int corners = 3 + i % 6;
      const double phase = uniform(0, 6.28);
      Points points;
      for (int k = 0; k < corners; ++k) {
        const double angle = phase + (k + uniform(-0.3, 0.3)) * 6.283185307179586 / corners;
        points.push_back({x + 0.38 * std::cos(angle), y + 0.38 * std::sin(angle)});
      }
      blocks.push_back(add_block(context, world.get(), points, of.kind));
    }
  }
};

}  // namespace halfspace_test
