#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "recording/table.h"

namespace halfspace::viewer {

using Point = std::array<double, 3>;
using Quaternion = std::array<double, 4>;  ///< x, y, z, w

/// A block where it is recorded first.
struct BlockShape {
  std::string name = {};
  int kind = 2;
  int material = 0;
  std::vector<Point> vertices = {};          ///< positions
  std::vector<std::vector<int>> faces = {};  ///< loops of vertices; 2D: one, the outline
};

inline bool is_fixed(const BlockShape& shape) { return shape.kind == 0; }
/// True for affine blocks and cells of meshes.
inline bool deforms(const BlockShape& shape) { return shape.kind >= 3; }

/// The position and orientation of a block.
struct Pose {
  Point position{};  ///< of the centroid
  Quaternion rotation{0, 0, 0, 1};
};

/// The contact of two blocks in a frame.
struct ContactForce {
  std::size_t block_a = 0, block_b = 0;
  Point point{};
  Point force{};            ///< on block b
  double normal_force = 0;  ///< compression is positive
};

struct BoltForce {
  std::size_t number = 0;
  Point place_a{}, place_b{};
  double tension = 0;
  bool is_ruptured = false;
};

/// The failure of a bond.
struct Crack {
  double time = 0;
  std::array<std::size_t, 2> blocks{};
  Point position{};  ///< at that time
  Point normal{};    ///< from the first block to the second one
  double area = 0;   ///< in 2D a length
  bool is_shear = false;
};

/// A run as the viewer shows it. Frames are added in order of time; each group of frames is packed as soon as
/// it is complete, so that a long run needs little memory. Functions refuse what a page cannot show, by a
/// std::invalid_argument that names the block: places that are no numbers of a float, faces of vertices that
/// there are not, rotations without an axis.
class Recording {
 public:
  Recording(int dimension, std::string title);

  /// Adds a block and returns its number. It is in no frame yet.
  std::size_t add_block(BlockShape shape, const Pose& pose);
  /// Adds a block that never moves, such as a triangle of a terrain. It is in all frames, which do not repeat
  /// it, until it is removed. All blocks added after it are still ones.
  std::size_t add_still_block(BlockShape shape);
  bool is_still(std::size_t block) const { return block >= moving_count(); }
  /// Takes a still block out of the current frame and later ones.
  void remove_still_block(std::size_t block);
  void add_frame(double time);

  // Contents of the current frame.
  void set_rigid(std::size_t block, const Pose& pose);
  void set_deformed(std::size_t block, const std::vector<Point>& vertices);
  /// Either of them, from the vertices and the rotation of a block, which counts if the block is rigid.
  void set_vertices(std::size_t block, const std::vector<Point>& vertices, const Quaternion& rotation);
  /// Sets a field. Ranges of fields are those of blocks that are not fixed.
  void set_value(const std::string& field, const std::string& unit, std::size_t block, double value);
  /// Keeps the max_contacts contacts with the largest forces.
  void set_contacts(std::vector<ContactForce> contacts);
  void set_bolt(const BoltForce& bolt);
  /// Sets the water table. Its faces are loops of points; in 2D there is one, the polyline.
  void set_water(std::vector<Point> points, std::vector<std::vector<std::size_t>> faces);

  void add_crack(Crack crack);
  void set_material_names(std::vector<std::string> names) { materials_ = std::move(names); }
  /// A table with a column `time`, as text of comma-separated values.
  void set_history(std::string csv) { history_ = std::move(csv); }

  int dimension() const { return dimension_; }
  std::size_t block_count() const { return blocks_.size(); }
  /// A block, with its vertices relative to its first pose or, if it is still, with their positions.
  const BlockShape& shape(std::size_t block) const { return blocks_[block].shape; }
  std::size_t frame_count() const { return times_.size(); }

  /// The recording as one page of HTML, which fetches nothing.
  /// @throws std::runtime_error if it has no frames, or `viewer` is not the viewer's page
  std::string page(const std::string& viewer);

  static constexpr std::size_t max_contacts = 20000;  ///< of a frame

 private:
  struct Block {
    BlockShape shape;     ///< as shape() returns it
    Point turn{};         ///< rotation vector in the last frame
    int first_node = -1;  ///< of a block that deforms
  };
  struct Water {
    std::size_t frame = 0;  ///< the first one that has it
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> faces;
  };

  std::size_t moving_count() const { return blocks_.size() - frame_counts_.size(); }
  Point from_origin(const Point& point) const;
  void make_tables();
  void pack_group();
  std::string header() const;
  std::string geometry() const;

  int dimension_;
  std::string title_;
  Point
      origin_{};  ///< of all stored positions, so that floats have their digits also far from that of the run
  bool has_origin_ = false;  ///< a block with vertices
  std::vector<Block> blocks_;
  std::vector<std::size_t>
      frame_counts_;  ///< of the still blocks, which come last: frames until their removal
  std::vector<std::string> materials_;
  std::vector<double> times_;
  Table of_blocks_, of_nodes_, of_contacts_, of_bolts_;
  std::size_t node_count_ = 0;
  std::size_t left_out_contacts_ = 0;  ///< of the frame with the largest number of them
  std::vector<Water> water_;
  std::vector<Crack> cracks_;
  std::string history_;
  std::map<std::tuple<std::size_t, std::size_t, std::size_t>, std::size_t> contact_items_;  ///< of the group
  std::map<std::size_t, std::size_t> bolt_items_;                                           ///< by number
  std::size_t frames_in_group_ = 0, frames_per_group_ = 1;
  std::vector<std::string> groups_;
};

}  // namespace halfspace::viewer
