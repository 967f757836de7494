#pragma once

#include <string>
#include <vector>

#include "model/model.h"
#include "scene/scene.h"

namespace halfspace::cli {

// A block has failed when it has moved farther than joints and bodies give elastically.

/// The displacement of each block, m, beyond which it has failed: ten times the elastic displacement of all
/// joints and bodies at rest, from a thousandth to a tenth of its size.
std::vector<double> limits_at_rest(const Scene& scene, const Model& standing);
/// The same where the elastic displacement is unknown, as in a motion: a tenth of its size.
std::vector<double> limits_at_start(const Frame& start);

/// The displacements of all blocks relative to the ground, m; 0 of blocks that do not move freely.
std::vector<double> displacements(const Frame& start, const Frame& now);

/// The number of blocks beyond their limits and the farthest of them, in words; empty without any.
std::string failed_blocks(const Layout& layout, const std::vector<double>& moved,
                          const std::vector<double>& limits);

}  // namespace halfspace::cli
