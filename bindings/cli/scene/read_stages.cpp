#include "scene/read_stages.h"

#include <algorithm>

#include "scene/read_bolts.h"
#include "scene/read_laws.h"
#include "scene/read_values.h"
#include "scene/read_water.h"

namespace halfspace::cli {
namespace {

constexpr Range angle_of_friction{.low = 0, .high = 90, .with_high = false};

hs_bond_def read_bond(Keys& keys) {
  hs_bond_def def;
  hs_bond_def_init(&def, sizeof def);
  def.normal_stiffness = keys.number("normal_stiffness", above(0), required);
  def.shear_stiffness = keys.number("shear_stiffness", at_least(0), 0);
  def.tensile_strength = keys.number("tensile_strength", at_least(0), 0);
  def.cohesion = keys.number("cohesion", at_least(0), 0);
  def.friction_angle = degrees(keys, "friction_angle", angle_of_friction, 0);
  def.residual_cohesion = keys.number("residual_cohesion", {.low = 0, .high = def.cohesion}, 0);
  def.residual_friction_angle =
      degrees(keys, "residual_friction_angle", angle_of_friction, def.friction_angle / degree);
  def.tensile_fracture_energy = keys.number("tensile_fracture_energy", at_least(0), 0);
  def.shear_fracture_energy = keys.number("shear_fracture_energy", at_least(0), 0);
  return def;
}

/// The new value that a stage sets, if any.
std::optional<double> change(Keys& keys, std::string_view key, Range range) {
  if (!keys.has_any({key})) return std::nullopt;
  return keys.number(key, range, required);
}

/// The water before a stage.
const std::optional<Water>& water_before(const Scene& scene) {
  for (auto stage = scene.stages.rbegin(); stage != scene.stages.rend(); ++stage)
    if (stage->water) return stage->water;
  return scene.water;
}

/// Corners are moved one by one, and a level becomes any other table.
bool can_change_gradually(const Water& from, const Water& to) {
  const bool are_alike = from.table.size() == to.table.size() && from.def.columns == to.def.columns;
  return are_alike || from.table.size() == 1 || to.table.size() == 1;
}

SceneStage read_stage(Keys& keys, Scene& scene, Laws& present) {
  SceneStage stage;
  stage.name = keys.text("name", std::string());
  stage.settles = keys.kind("do", {"run", "settle"}, required) == 1;
  if (stage.settles) {
    hs_relaxation_def_init(&stage.relaxation, sizeof stage.relaxation);
    stage.relaxation.ratio = keys.number("ratio", above(0), stage.relaxation.ratio);
    stage.relaxation.measure = keys.word("measure", {"mean", "largest"}, stage.relaxation.measure);
    stage.relaxation.max_steps =
        keys.integer("max_steps", 1, std::numeric_limits<std::int64_t>::max(), stage.relaxation.max_steps);
    stage.relaxation.hold_bonds = keys.word("bonds", {"may fail", "hold"}, stage.relaxation.hold_bonds);
    stage.portions = keys.integer("portions", 1, 10'000, stage.portions);
  } else {
    stage.duration = keys.number("duration", above(0), required);
    stage.ends_exactly = true;
    stage.rest_speed = keys.number("rest_speed", above(0), stage.rest_speed);
    stage.ramp = keys.number("ramp", {.low = 0, .high = stage.duration}, stage.ramp);
  }
  if (keys.has_any({"gravity"})) stage.gravity = keys.point("gravity", required);
  stage.gravity_place = keys.place("gravity");
  stage.local_damping = change(keys, "local_damping", {.low = 0, .high = 1, .with_high = false});
  stage.mass_damping = change(keys, "mass_damping", at_least(0));
  stage.strength_factor = change(keys, "strength_factor", above(0));
  stage.loads = change(keys, "loads", any_number());
  const std::optional<Water>& before = water_before(scene);
  stage.water = read_water(keys, before, scene.folder);
  if (before && stage.water && !can_change_gradually(*before, *stage.water)) {
    keys.fault("water", "a table of " + std::to_string(stage.water->table.size()) + " points after one of " +
                            std::to_string(before->table.size()) +
                            "; allowed: as many points in as many rows, or a level");
  }
  stage.installed = read_installed(keys, scene);
  std::vector<Place> places;
  stage.excavated = keys.texts("excavate", places, std::vector<std::string>{});
  stage.excavated_place = keys.place("excavate");
  read_stage_laws(keys, scene, present, stage);
  stage.resets_displacement = keys.boolean("reset_displacement", false);
  keys.finish();
  return stage;
}

}  // namespace

void read_bonds(std::vector<Keys> tables, Scene& scene) {
  for (Keys& keys : tables) {
    const std::optional<std::pair<int, int>> between = read_between(keys, scene);
    const hs_bond_def def = read_bond(keys);
    keys.finish();
    if (between) scene.bonds.push_back({between->first, between->second, def, keys.place("between")});
  }
}

void read_stages(std::vector<Keys> tables, Scene& scene) {
  Laws present{scene.default_law, scene.laws};
  for (Keys& keys : tables) {
    SceneStage stage = read_stage(keys, scene, present);
    stage.index = scene.stages.size();
    scene.stages.push_back(std::move(stage));
  }
  for (const SceneStage& stage : scene.stages) scene.duration += stage.duration;
}

}  // namespace halfspace::cli
