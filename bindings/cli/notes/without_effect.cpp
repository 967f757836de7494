#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "common/text.h"
#include "notes/kinds.h"

namespace halfspace::cli {
namespace {

/// An extent along one axis.
struct Extent {
  double low = INFINITY, high = -INFINITY;
  double size() const { return high - low; }
  void include(double coordinate) {
    low = std::min(low, coordinate);
    high = std::max(high, coordinate);
  }
};

/// Of all blocks at the start.
Extent extent_along(const Start& start, std::size_t axis) {
  Extent extent;
  for (const auto& block : start.frame.blocks)
    for (const Point& vertex : block.vertices) extent.include(vertex[axis]);
  return extent;
}

/// The largest extent of a body along an axis, of the bodies that one table makes.
double largest_body(const Start& start, const std::string& key) {
  std::map<std::pair<std::size_t, std::size_t>, Extent> extents;  // by body and axis
  for (std::size_t i = 0; i < start.layout.blocks.size(); ++i) {
    const LayoutBlock& block = start.layout.blocks[i];
    if (block.key != key || !block.body) continue;
    for (const Point& vertex : start.frame.blocks[i].vertices)
      for (std::size_t axis = 0; axis < vertex.size(); ++axis)
        extents[{*block.body, axis}].include(vertex[axis]);
  }
  double largest = 0;
  for (const auto& [place, extent] : extents) largest = std::max(largest, extent.size());
  return largest;
}

void note_tables_without_blocks(const Start& start, Faults& faults) {
  std::set<std::string> with_blocks;
  for (const LayoutBlock& block : start.layout.blocks) with_blocks.insert(block.key);
  for_each_making(start.scene, [&](const Making& making) {
    if (!with_blocks.contains(making.key))
      faults.note(making.place, making.key,
                  quoted(making.name) + " has no block; usual: pieces above the smallest size");
  });
}

/// A plane through three points is not level: it goes on beyond them.
void note_water(const Start& start, Faults& faults) {
  constexpr double max_distance = 32;  // in extents of the blocks: the root of 1000, as a level in mm
  const Scene& scene = start.scene;
  const bool changes = std::any_of(scene.stages.begin(), scene.stages.end(),
                                   [](const SceneStage& stage) { return stage.water.has_value(); });
  const std::size_t up = up_axis(start.layout.dimension);
  const bool is_plane =
      up == 2 && scene.water && scene.water->def.columns == 0 && scene.water->table.size() == 3;
  if (!scene.water || scene.water->table.empty() || changes || is_plane) return;
  const auto [lowest, highest] =
      std::minmax_element(scene.water->table.begin(), scene.water->table.end(),
                          [&](const Point& a, const Point& b) { return a[up] < b[up]; });
  const Extent blocks = extent_along(start, up);
  const double above = (*lowest)[up] - blocks.high, below = blocks.low - (*highest)[up];
  if (!(std::max(above, below) > max_distance * blocks.size())) return;
  faults.note(scene.places.water, "water",
              "the table lies " + rounded(std::max(above, below), 3) + " m " +
                  (above > 0 ? "above" : "below") + " all blocks; usual: heights in m");
}

void note_window(const Start& start, Faults& faults) {
  const auto& window = start.scene.output.window;
  if (!window) return;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(start.layout.dimension); ++axis) {
    const Extent blocks = extent_along(start, axis);
    if ((*window)[0][axis] <= blocks.high && (*window)[1][axis] >= blocks.low) continue;
    faults.note(start.scene.places.window, "output.picture.window", "no block is in it at the start");
    return;
  }
}

void note_cells(const Start& start, Faults& faults) {
  for_each_making(start.scene, [&](const Making& making) {
    if (!(making.cell_size > 0)) return;
    const double widest = largest_body(start, making.key);
    if (widest > 0 && making.cell_size > widest)
      faults.note(making.place, making.key + ".cell_size",
                  shortest(making.cell_size) +
                      " m is larger than the block: it is not divided; usual: a fraction of its thickness");
  });
}

}  // namespace

void note_without_effect(const Start& start, Faults& faults) {
  note_tables_without_blocks(start, faults);
  note_water(start, faults);
  note_window(start, faults);
  note_cells(start, faults);
}

}  // namespace halfspace::cli
