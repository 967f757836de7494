#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "model/layout.h"

namespace halfspace::cli {

/// True if the library lets a block follow an action: loads act on free blocks, motions on prescribed blocks
/// and along held axes.
bool can_follow(const LayoutBlock& block, const Action& action, int dimension);

/// The blocks that can follow an action, in words.
const char* followers(const Action& action);

/// The axes along which the actions of a scene move its blocks.
class GivenAxes {
 public:
  explicit GivenAxes(int dimension) : dimension_(dimension) {}

  /// Adds the axes along which an action, the next one of the scene or the same as before, moves a block.
  /// `block`: none for the action of all blocks. Returns the fault of an axis that another action of its
  /// stage has taken: that action's motion would be lost.
  std::optional<std::string> add(std::optional<std::size_t> block, std::size_t index, const Action& action);

 private:
  int dimension_;
  /// Per stage, block and axis, the index of the action; rotations follow translations.
  std::map<std::array<std::size_t, 3>, std::size_t> taken_;
};

}  // namespace halfspace::cli
