#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "faults.h"
#include "halfspace/halfspace.h"

namespace halfspace::cli {

using Point = std::array<double, 2>;

struct Material {
  std::string name;
  double density = 0;
};

/// The law of one pair of materials, named by their indices.
struct PairLaw {
  int a = 0;
  int b = 0;
  hs_law_def law{};
};

/// How a block moves: the initial motion of a rigid block, the motion of a prescribed one between start and
/// stop.
struct Motion {
  Point velocity{};
  double angular_velocity = 0;  ///< rad/s
  double start = 0;
  double stop = std::numeric_limits<double>::infinity();
};

/// What blocks and generators have in common.
struct Making {
  std::string name;
  std::string key;  ///< path in the file and
  Place place;      ///< where the name stands, for faults
  int material = 0;
  int kind = HS_BLOCK_RIGID;
};

struct Block {
  Making making;
  std::vector<Point> vertices;
  Place vertices_place;
  Motion motion;
};

/// Parallel joints, each through the whole region.
struct JointSet {
  double dip = 0;  ///< rad below the horizontal, towards +x
  double spacing = 1;
  double offset = 0;  ///< of joint 0 from the origin, along the joints' normal
  double spread = 0;  ///< random deviation of each spacing, share of the spacing
  std::uint64_t seed = 0;
};

/// A convex region cut by joint sets.
struct JointedRock {
  Making making;
  std::vector<Point> region;
  Place region_place;
  double smallest_area = 0;
  std::vector<JointSet> joint_sets;
};

/// A rectangle cut into a given number of triangles.
struct Triangulated {
  Making making;
  Point lower_left{};
  Point upper_right{};
  std::int64_t count = 2;
  double jitter = 0;
  std::uint64_t seed = 0;
};

enum class Colour { displacement, speed, layer, material };

struct Output {
  double frame_interval = 0;
  double history_interval = 0;
  std::vector<std::string> tracked;
  std::vector<Place> tracked_places;
  Colour colour = Colour::displacement;
  int layers = 6;
  std::vector<double> picture_times;           ///< rising; pictures beside those of the first and last moment
  std::optional<std::array<Point, 2>> window;  ///< lower left, upper right
};

/// A scene file, checked as far as it can be without making blocks.
struct Scene {
  std::string title;
  hs_world_def world{};
  double duration = 0;
  double rest_speed = 0;  ///< 0: the run never ends early
  std::vector<Material> materials;
  hs_law_def default_law{};
  std::vector<PairLaw> laws;
  std::vector<Block> blocks;
  std::vector<JointedRock> jointed_rocks;
  std::vector<Triangulated> triangulated;
  Output output;
};

}  // namespace halfspace::cli
