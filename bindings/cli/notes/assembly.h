#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "notes/separation.h"
#include "notes/start.h"

namespace halfspace::cli {

/// The connectivity of a scene: blocks that touch or hang on a bolt, parts of one compound, and cells of one
/// body that share a face.
class Assembly {
 public:
  explicit Assembly(const Start& start);

  /// For each block the first block of its cluster; an excavated block is a cluster of its own.
  std::vector<std::size_t> clusters(const std::vector<char>& is_gone) const;

  /// Fixed and prescribed blocks, those that hang on a bolt in the ground, and rigid blocks and cells that
  /// are held along some of these axes, a sum of HS_AXIS_ values.
  std::vector<char> held_blocks(int axes) const;

  const std::vector<ConvexBody>& bodies() const { return bodies_; }

 private:
  void connect_cells(const LayoutBody& body);
  void connect_bolts();
  std::optional<std::size_t> block_at_end(const Bolt& bolt, std::size_t end) const;

  const Start& start_;
  std::vector<ConvexBody> bodies_;
  std::vector<Neighbours> neighbours_;
  std::vector<std::pair<std::size_t, std::size_t>> connected_;  ///< cells, parts, and blocks on a bolt
  std::vector<std::size_t> on_ground_;                          ///< blocks on a bolt in the ground
};

}  // namespace halfspace::cli
