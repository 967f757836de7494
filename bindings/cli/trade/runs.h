#pragma once

#include <vector>

#include "trade/setting.h"

namespace halfspace::cli {

/// Steps of the time as shares of the stable one: each half of the one before, so that the order in which
/// runs converge can be told (Richardson).
inline constexpr double step_ladder[] = {1, 0.5, 0.25, 0.125, 0.0625};
/// The step at which all other knobs are turned, fine enough that they are what is seen.
inline constexpr double held_step = 0.25;
inline constexpr double stiffness_ladder[] = {0.01, 0.1, 10, 100};
inline constexpr double cell_places[] = {0.5, 2};
inline constexpr int law_places[] = {HS_STIFFNESS_PER_CONTACT, HS_STIFFNESS_PER_AREA, HS_STIFFNESS_POTENTIAL,
                                     HS_STIFFNESS_NONE};
inline constexpr int kind_places[] = {HS_BLOCK_RIGID, HS_BLOCK_AFFINE};
inline constexpr double damping_places[] = {0, 0.1, 0.3, 1};
inline constexpr double skin_places[] = {0.02, 0.05, 0.3};
inline constexpr int disturbed_starts = 16;

/// The runs that a trade of the scene consists of: the ladder of steps for each law, stiffnesses over four
/// decades for each law that has one, kinds of blocks, cells of meshes, dampings and skins one by one, and
/// disturbed starts. Meshes whose cells have a name in the scene stay as they are.
std::vector<Setting> runs_of(const Scene& scene, bool names_cells);

/// The cost of a run compared with others, from experience; only their order and the budget hang on it.
double expected_cost(const Setting& setting);

}  // namespace halfspace::cli
