#include "trade/runs.h"

#include <algorithm>
#include <cmath>

namespace halfspace::cli {
namespace {

bool holds_together(const hs_law_def& law) { return law.cohesion > 0 || law.tensile_strength > 0; }

bool has_no_spring(const hs_law_def& law) { return law.stiffness_kind == HS_STIFFNESS_NONE; }

/// The scene's own law is told by nothing given. Potentials hold nothing together. A law without a spring has
/// no stiffness that another one could have as well.
std::vector<std::optional<int>> laws_of(const Scene& scene) {
  if (any_law(scene, has_no_spring)) return {std::nullopt};
  const bool is_bonded = any_law(scene, holds_together);
  std::vector<std::optional<int>> laws = {std::nullopt};
  for (const int kind : law_places) {
    const bool is_another = any_law(scene, [&](const hs_law_def& law) { return law.stiffness_kind != kind; });
    if (is_another && !(kind == HS_STIFFNESS_POTENTIAL && is_bonded)) laws.push_back(kind);
  }
  return laws;
}

/// The kinds that free blocks can have besides their own: to strain takes an elasticity.
std::vector<int> other_kinds(const Scene& scene) {
  bool has_rigid = false, has_affine = false, can_strain = true;
  for_each_making(scene, [&](const Making& making) {
    if (!moves_freely(making.kind)) return;
    (making.kind == HS_BLOCK_AFFINE ? has_affine : has_rigid) = true;
    can_strain = can_strain && scene.materials[static_cast<std::size_t>(making.material)].elasticity;
  });
  std::vector<int> kinds;
  if (has_affine) kinds.push_back(HS_BLOCK_RIGID);
  if (has_rigid && can_strain) kinds.push_back(HS_BLOCK_AFFINE);
  return kinds;
}

}  // namespace

std::vector<Setting> runs_of(const Scene& scene) {
  std::vector<Setting> runs;
  const auto add = [&](auto change) {
    Setting setting{.step = held_step};
    change(setting);
    if (std::find(runs.begin(), runs.end(), setting) == runs.end()) runs.push_back(setting);
  };
  for (const std::optional<int> law : laws_of(scene)) {
    for (const double step : step_ladder) add([&](Setting& s) { s.step = step, s.law = law; });
    if (any_law(scene, has_no_spring)) continue;
    for (const double stiffness : stiffness_ladder)
      for (const double step : {1.0, held_step})
        add([&](Setting& s) { s.step = step, s.law = law, s.stiffness = stiffness; });
  }
  for (const int kind : other_kinds(scene)) add([&](Setting& s) { s.kind = kind; });
  for (const double damping : damping_places) add([&](Setting& s) { s.damping = damping; });
  for (const double skin : skin_places) add([&](Setting& s) { s.skin = skin; });
  for (int number = 1; number <= disturbed_starts; ++number) add([&](Setting& s) { s.disturbance = number; });
  return runs;
}

double expected_cost(const Setting& setting) {
  const double steps = std::sqrt(setting.stiffness) / setting.step;
  return steps * (setting.law == HS_STIFFNESS_POTENTIAL ? 3 : 1) *
         (setting.kind == HS_BLOCK_AFFINE ? 1.5 : 1);
}

}  // namespace halfspace::cli
