#pragma once

#include <optional>
#include <string>
#include <vector>

#include "faults.h"
#include "library.h"
#include "scene.h"

namespace halfspace::cli {

/// A body of finite elements. Each of its cells is a block of the layout, one after the other.
struct LayoutBody {
  struct Support {
    std::vector<int32_t> nodes;
    int axes = 0;
    Point velocity{};
  };
  struct Force {
    int32_t cell = 0;  ///< on whose face it acts
    int32_t node = 0;
    Point force{};
  };
  MeshHandle mesh;
  std::vector<int32_t> materials;            ///< of each cell
  std::vector<std::vector<int>> cell_nodes;  ///< of each cell
  std::vector<double> cell_sizes;            ///< area in 2D, volume in 3D
  std::size_t node_count = 0;
  std::size_t first_block = 0;
  Placing placing;
  Point velocity{};
  std::vector<Support> supports;
  std::vector<Force> forces;
  std::optional<Tensor> stress;  ///< at the origin, and
  Tensor stress_by_height{};     ///< its change, Pa/m upwards
};

struct LayoutBlock {
  std::string name;
  std::string key;  ///< path in the file of what it comes from, and
  Place place;      ///< where the name of that stands, for notes
  int material = 0;
  int kind = HS_BLOCK_RIGID;
  std::optional<Tensor> stress;
  Shape shape;
  std::vector<std::vector<int>> faces;  ///< loops of vertices; in 2D one, the block itself
  Placing placing;
  Motion motion;
  std::optional<std::size_t> body;  ///< index of the body whose cell this is
};

/// All blocks of a scene, generators included, in the order of the file.
struct Layout {
  int dimension = 2;
  std::vector<LayoutBlock> blocks;
  std::vector<LayoutBody> bodies;
  /// True when some block deforms: then there are stresses to be told.
  bool has_deformable() const;

  std::vector<std::size_t> tracked;  ///< indices of the blocks whose motion goes into the history
  std::vector<std::size_t>
      referenced;  ///< whose position or force is measured: together, where they are several
  std::vector<std::vector<std::size_t>> excavated;  ///< in each stage of the scene
  bool names_cells = false;  ///< a cell of a mesh is measured or excavated: cut otherwise, it is another one
  int left_out = 0;          ///< blocks too small to be kept
  double size_left_out = 0;  ///< of all those together
};

/// Makes the shapes of a scene. Bad shapes and unknown names go to the faults.
Layout lay_out_blocks(const Context& context, const Scene& scene, Faults& faults);

}  // namespace halfspace::cli
