#pragma once

#include <array>
#include <vector>

#include "studies/trade/setting.h"

namespace halfspace::cli {

/// Time steps as fractions of the stable one, each half of the one before, which gives the order of
/// convergence (Richardson).
inline constexpr double step_ladder[] = {1, 0.5, 0.25, 0.125, 0.0625};
/// The step at which all other parameters are varied, small enough for its own error not to matter.
inline constexpr double held_step = 0.25;
inline constexpr double stiffness_ladder[] = {0.01, 0.1, 10, 100};
inline constexpr double cell_factors[] = {0.5, 2};
inline constexpr auto law_kinds = [] {
  std::array<int, law_names.size()> kinds{};
  for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] = static_cast<int>(i);
  return kinds;
}();
inline constexpr int block_kinds[] = {HS_BLOCK_RIGID, HS_BLOCK_AFFINE};
inline constexpr double damping_values[] = {0, 0.1, 0.3, 1};
inline constexpr double skin_values[] = {0.02, 0.05, 0.3};
inline constexpr double tolerance_values[] = {1e-4, 1e-2};
inline constexpr int disturbed_starts = 16;

/// The runs of a trade: the ladder of steps for each law, stiffnesses over four decades for each law that has
/// one, kinds of blocks, cells of meshes, dampings, tolerances of impulses and skins one by one, and
/// disturbed starts. Meshes with cells named in the scene stay unchanged.
std::vector<Setting> runs_of(const Scene& scene, bool names_cells);

/// The relative cost of a run, from experience; only the order of runs and the budget depend on it.
double expected_cost(const Setting& setting);

}  // namespace halfspace::cli
