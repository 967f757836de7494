#include "studies/trade/runs.h"

#include <algorithm>
#include <cmath>

namespace halfspace::cli {
namespace {

/// The kinds of the free blocks, except those that stay rigid.
struct Kinds {
  explicit Kinds(Scene scene) {
    std::erase_if(scene.blocks,
                  [&](const Block& block) { return stays_rigid(block, scene.world.dimension); });
    for_each_block_making(scene, [&](const Making& making) {
      if (!moves_freely(making.kind)) return;
      (making.kind == HS_BLOCK_RIGID    ? has_rigid
       : making.kind == HS_BLOCK_AFFINE ? has_affine
                                        : has_mesh) = true;
      can_strain = can_strain && scene.materials[static_cast<std::size_t>(making.material)].elasticity;
    });
    deforms = has_affine || has_mesh || !scene.meshes.empty();
  }

  /// The other kinds that the blocks can have; affine blocks require an elasticity.
  std::vector<int> others() const {
    std::vector<int> kinds;
    if (has_affine || has_mesh) kinds.push_back(HS_BLOCK_RIGID);
    if ((has_rigid || has_mesh) && can_strain) kinds.push_back(HS_BLOCK_AFFINE);
    return kinds;
  }

  bool has_rigid = false, has_affine = false, has_mesh = false, can_strain = true;
  bool deforms = false;
};

/// The laws of the runs; empty: the scene's own. Potentials have no cohesion, and rigid blocks without
/// springs none that holds them together. Springs in place of a law without require elements that determine
/// their stiffness. Servos require springs.
std::vector<std::optional<int>> laws_of(const Scene& scene, bool deforms) {
  const bool is_bonded = any_law(scene, holds_together);
  const bool is_given = !any_law(scene, has_no_spring) || deforms;
  const bool has_servo = std::any_of(scene.actions.begin(), scene.actions.end(),
                                     [](const Action& action) { return action.kind == HS_ACTION_SERVO; });
  std::vector<std::optional<int>> laws = {std::nullopt};
  for (const int kind : law_kinds) {
    const bool is_another = any_law(scene, [&](const hs_law_def& law) { return law.stiffness_kind != kind; });
    const bool fits = kind == HS_STIFFNESS_NONE        ? !has_servo && (deforms || !is_bonded)
                      : kind == HS_STIFFNESS_POTENTIAL ? is_given && !is_bonded
                                                       : is_given;
    if (is_another && fits) laws.push_back(kind);
  }
  return laws;
}

}  // namespace

std::vector<Setting> runs_of(const Scene& scene, bool names_cells) {
  std::vector<Setting> runs;
  const auto add = [&](auto change) {
    Setting setting{.step = held_step};
    change(setting);
    if (std::find(runs.begin(), runs.end(), setting) == runs.end()) runs.push_back(setting);
  };
  const Kinds kinds(scene);
  for (const std::optional<int> law : laws_of(scene, kinds.deforms)) {
    for (const double step : step_ladder) add([&](Setting& s) { s.step = step, s.law = law; });
    if (law == HS_STIFFNESS_NONE || (!law && !any_law(scene, has_spring))) {
      if (kinds.deforms) continue;
      for (const double tolerance : tolerance_values)
        add([&](Setting& s) { s.law = law, s.tolerance = tolerance; });
      continue;
    }
    for (const double stiffness : stiffness_ladder)
      for (const double step : {1.0, held_step})
        add([&](Setting& s) { s.step = step, s.law = law, s.stiffness = stiffness; });
  }
  for (const int kind : kinds.others()) {
    if (names_cells && kinds.has_mesh) break;
    if (has_stable_step(scene) && !has_stable_step(with_setting(scene, {.kind = kind}, {}))) continue;
    add([&](Setting& s) { s.kind = kind; });
  }
  if (has_cut_meshes(scene) && !names_cells)
    for (const double cells : cell_factors) add([&](Setting& s) { s.cells = cells; });
  if (any_law(scene, has_spring))
    for (const double damping : damping_values) add([&](Setting& s) { s.damping = damping; });
  for (const double skin : skin_values) add([&](Setting& s) { s.skin = skin; });
  for (int number = 1; number <= disturbed_starts; ++number) add([&](Setting& s) { s.disturbance = number; });
  return runs;
}

double expected_cost(const Setting& setting) {
  const double steps = std::sqrt(setting.stiffness) / setting.step;
  return steps * std::pow(setting.cells, 3) * (setting.law == HS_STIFFNESS_POTENTIAL ? 3 : 1) *
         (setting.kind == HS_BLOCK_AFFINE ? 1.5 : 1);
}

}  // namespace halfspace::cli
