#include "plan/without.h"

namespace halfspace::cli {
namespace {

/// Sets the same member of all laws to 0.
template <class... Member>
void clear(Scene& scene, Member... member) {
  ((scene.default_law.*member = 0), ...);
  for (PairLaw& pair : scene.laws) ((pair.law.*member = 0), ...);
}

/// Steps and skin stay as the scene has them.
Scene with(const Scene& scene, const Setting& setting, const FaceSize& face) {
  Scene changed = turned(scene, setting, face);
  changed.world = scene.world;
  return changed;
}

/// The bodies of [[mesh]] cannot be rigid.
bool some_block_strains(const Scene& scene) {
  bool strains = false;
  for_each_block_making(scene, [&](const Making& making) {
    strains = strains || making.kind == HS_BLOCK_AFFINE || making.kind == HS_BLOCK_MESH;
  });
  return strains;
}

Scene without(Scene scene, int part, const FaceSize& face) {
  switch (part) {
    case HS_PART_FRICTION:
      clear(scene, &hs_law_def::friction_angle, &hs_law_def::cohesion, &hs_law_def::tensile_strength);
      break;
    case HS_PART_BONDS:
      clear(scene, &hs_law_def::cohesion, &hs_law_def::tensile_strength);
      break;
    case HS_PART_CONTACT_DAMPING:
      clear(scene, &hs_law_def::normal_damping, &hs_law_def::shear_damping);
      break;
    case HS_PART_AREA:
    case HS_PART_POTENTIAL:
    case HS_PART_REACTIONS:
      return with(scene, {.law = HS_STIFFNESS_PER_CONTACT}, face);
    case HS_PART_STRAIN:
      return with(scene, {.kind = HS_BLOCK_RIGID}, face);
    case HS_PART_LOCAL_DAMPING:
      scene.world.local_damping = 0;
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
                                              {HS_PART_REACTIONS, "springless contacts"}};
  return names;
}

std::vector<Without> without_each(const Scene& scene, int active_parts, const FaceSize& face) {
  std::vector<Without> all;
  for (const PartName& named : part_names()) {
    const bool can_go = named.part == HS_PART_STRAIN      ? some_block_strains(scene)
                        : named.part == HS_PART_REACTIONS ? face.stiffness > 0
                                                          : true;
    if ((active_parts & named.part) && can_go) all.push_back({named.name, without(scene, named.part, face)});
  }
  return all;
}

}  // namespace halfspace::cli
