#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "model/library.h"
#include "scene/faults.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// A body of finite elements. Its cells are consecutive blocks of the layout.
struct LayoutBody {
  struct Support {
    std::vector<int32_t> nodes;
    int axes = 0;
    Point velocity{};
  };
  struct Force {
    int32_t cell = 0;  ///< with the loaded face
    int32_t node = 0;
    Point force{};
  };
  /// A motion or load in time.
  struct NodeAction {
    int kind = HS_ACTION_FORCE;
    TimeTable table;
    std::size_t stage = 0;
    std::vector<int32_t> nodes;
    std::vector<Point> scales;  ///< of each node
  };
  /// A part of a face that waves leave, at a node.
  struct ViscousPart {
    int32_t node = 0;
    int32_t material = 0;
    Point area{};  ///< along the outward normal
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
  std::vector<NodeAction> actions;
  std::vector<ViscousPart> viscous;
  std::optional<Tensor> stress;  ///< initial stress at the origin
  Tensor stress_by_height{};     ///< vertical gradient of the initial stress, Pa/m
};

/// A concave block. Its convex parts are consecutive blocks of the layout.
struct LayoutCompound {
  std::size_t first_block = 0;
  std::size_t part_count = 0;
};

struct LayoutBlock {
  std::string name;
  std::string key;  ///< path of its table in the file, for notes
  Place place;      ///< of the name of that table, for notes
  int material = 0;
  int kind = HS_BLOCK_RIGID;
  std::optional<Tensor> stress;
  Shape shape;
  std::vector<std::vector<int>> faces;  ///< loops of vertices; 2D: one, the outline
  Placing placing;
  Motion motion;
  std::optional<std::size_t> body;      ///< index of the body whose cell this is
  std::optional<std::size_t> compound;  ///< index of the compound whose part this is
};

/// A point that a block carries along.
struct LayoutPoint {
  std::string name;
  std::size_t block = 0;
  Point at{};  ///< at the start
};

/// A joint between two blocks, at the start.
struct LayoutJoint {
  std::string name;
  std::size_t block_a = 0;
  std::size_t block_b = 0;
  Point center{};  ///< at the surface of block a
  Point normal{};  ///< unit length, from a to b
  double gap = 0;  ///< m, along the normal
};

/// All blocks of a scene, generators included, in the order of the file.
struct Layout {
  int dimension = 2;
  std::vector<LayoutBlock> blocks;
  std::vector<LayoutBody> bodies;
  std::vector<LayoutCompound> compounds;
  std::size_t terrain_count = 0;  ///< of the last blocks: they are triangles of terrains
  std::size_t terrain_begin() const { return blocks.size() - terrain_count; }
  /// True if some block deforms, so that there are stresses to write.
  bool has_deformable() const;

  std::vector<std::size_t> tracked;                 ///< blocks whose motion is written to the history
  std::vector<std::size_t> referenced;              ///< blocks whose common position or force is measured
  std::vector<std::vector<std::size_t>> excavated;  ///< in each stage of the scene
  std::vector<std::vector<std::size_t>> acted_on;   ///< by each action of the scene
  /// Blocks at the ends of each bolt that a stage installs, unless it names them.
  std::vector<std::array<std::optional<std::size_t>, 2>> bolt_ends;
  std::vector<LayoutPoint> points;  ///< whose motion is written to the history
  std::vector<LayoutJoint> joints;  ///< that are written to the history
  bool names_cells = false;         ///< a mesh cell is measured or excavated by its name
  int left_out = 0;                 ///< number of blocks below the smallest size
  double size_left_out = 0;         ///< their total area or volume
};

/// Makes the blocks of a scene. Invalid shapes and unknown names are faults.
Layout lay_out_blocks(const Context& context, const Scene& scene, Faults& faults);

}  // namespace halfspace::cli
