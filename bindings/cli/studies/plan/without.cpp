#include "studies/plan/without.h"

namespace halfspace::cli {
namespace {

/// Sets the same member of all laws to 0.
template <class... Member>
void clear(Scene& scene, Member... member) {
  for_each_law(scene, [&](hs_law_def& law) { ((law.*member = 0), ...); });
}

/// The scene with another law or kind; steps and skin stay.
Scene with_law_or_kind(const Scene& scene, const Setting& setting, const FaceSize& face) {
  Scene changed = with_setting(scene, setting, face);
  changed.world = scene.world;
  return changed;
}

/// True if some block has this kind; bodies of [[mesh]] cannot have another one.
bool some_block_is(const Scene& scene, int kind) {
  return any_block_making(scene, [&](const Making& making) { return making.kind == kind; });
}

Scene without_cells(Scene scene) {
  for_each_block_making(scene, [](Making& making) {
    if (making.kind == HS_BLOCK_MESH) making.kind = HS_BLOCK_AFFINE;
  });
  return scene;
}

Scene without_actions(Scene scene) {
  scene.actions.clear();
  return scene;
}

Scene without(Scene scene, int part, const FaceSize& face) {
  switch (part) {
    case HS_PART_FRICTION:
      clear(scene, &hs_law_def::friction_angle, &hs_law_def::cohesion, &hs_law_def::tensile_strength);
      break;
    case HS_PART_BONDS:
      clear(scene, &hs_law_def::cohesion, &hs_law_def::tensile_strength);
      scene.bonds.clear();
      break;
    case HS_PART_CONTACT_DAMPING:
      clear(scene, &hs_law_def::normal_damping, &hs_law_def::shear_damping);
      break;
    case HS_PART_AREA:
    case HS_PART_POTENTIAL:
    case HS_PART_HARD_CONTACTS:
      return with_law_or_kind(scene, {.law = HS_STIFFNESS_PER_CONTACT}, face);
    case HS_PART_STRAIN:
      return with_law_or_kind(scene, {.kind = HS_BLOCK_RIGID}, face);
    case HS_PART_LOCAL_DAMPING:
      scene.world.local_damping = 0;
      break;
    case HS_PART_SLEEP:
      scene.world.sleep_tolerance = 0;
      break;
    case HS_PART_WATER:
      scene.water.reset();
      for (SceneStage& stage : scene.stages) stage.water.reset();
      break;
    case HS_PART_BOLTS:
      scene.bolts.clear();
      for (SceneStage& stage : scene.stages) stage.installed.clear();
      break;
    default:
      scene.world.mass_damping = 0;
  }
  return scene;
}

}  // namespace

const std::vector<PartName>& part_names() {
  static const std::vector<PartName> names = {{HS_PART_FRICTION, "friction"},
                                              {HS_PART_BONDS, "bonds"},
                                              {HS_PART_CONTACT_DAMPING, "damping of contacts"},
                                              {HS_PART_AREA, "areas"},
                                              {HS_PART_POTENTIAL, "potentials"},
                                              {HS_PART_STRAIN, "strain"},
                                              {HS_PART_LOCAL_DAMPING, "local damping"},
                                              {HS_PART_MASS_DAMPING, "mass damping"},
                                              {HS_PART_HARD_CONTACTS, "springless contacts"},
                                              {HS_PART_SLEEP, "sleep"},
                                              {HS_PART_WATER, "water"},
                                              {HS_PART_BOLTS, "bolts"}};
  return names;
}

std::vector<Without> without_each(const Scene& scene, int active_parts, const FaceSize& face,
                                  bool names_cells) {
  const bool has_cells = some_block_is(scene, HS_BLOCK_MESH);
  const auto can_go = [&](int part) {
    if (part == HS_PART_STRAIN) return !names_cells && (has_cells || some_block_is(scene, HS_BLOCK_AFFINE));
    return part != HS_PART_HARD_CONTACTS || face.stiffness > 0;
  };
  std::vector<Without> all;
  for (const PartName& named : part_names()) {
    if (active_parts & named.part && can_go(named.part))
      all.push_back({named.name, without(scene, named.part, face)});
  }
  if (!scene.actions.empty()) all.push_back({"actions", without_actions(scene)});
  if (has_cells && !names_cells) all.push_back({"cells", without_cells(scene)});
  std::erase_if(
      all, [&](const Without& one) { return scene.world.time_step == 0 && !has_stable_step(one.scene); });
  return all;
}

}  // namespace halfspace::cli
