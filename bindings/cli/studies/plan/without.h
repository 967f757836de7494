#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"
#include "studies/trade/setting.h"

namespace halfspace::cli {

/// A scene with one of its parts left out.
struct Without {
  std::string part;
  Scene scene;
};

/// The parts of a world by their names, in the order of the HS_PART_ bits.
struct PartName {
  int part;
  const char* name;
};
const std::vector<PartName>& part_names();

/// The scene without each of its active parts in turn, and without its actions. Areas and potentials are
/// replaced by springs per contact, with the same stiffness of the typical face. Blocks without cells are
/// affine; if the scene names cells, they stay.
std::vector<Without> without_each(const Scene& scene, int active_parts, const FaceSize& face,
                                  bool names_cells);

}  // namespace halfspace::cli
