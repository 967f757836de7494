#pragma once

#include <string>
#include <vector>

#include "scene.h"

namespace halfspace_trade {

/// Many blocks on a plate, and what is measured of them.
struct Assembly {
  std::string name;
  Scene scene;
  double divide = 1;   // s: costs are measured before and after it
  bool falls = false;  // from the air: no block has a place that it should keep
};

/// Walls, stacks and pyramids that stand, and heaps that fall into a bin. In their dimension the later ones
/// have more blocks than the earlier ones of their kind.
std::vector<Assembly> assemblies();

/// Has it another shape than boxes, in space?
bool has_hulls(const Assembly& assembly);

}  // namespace halfspace_trade
