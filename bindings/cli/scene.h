#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "faults.h"
#include "halfspace/halfspace.h"

namespace halfspace::cli {

constexpr std::int64_t most_blocks =
    10'000'000;  ///< of all generators that tell their number, and of each [[jointed_rock]]

/// A point or vector; in 2D its last component is 0.
using Point = std::array<double, 3>;

/// The axis that points upwards where gravity is not said otherwise: y in 2D, z in 3D.
constexpr std::size_t up_axis(int dimension) { return dimension == 3 ? 2 : 1; }

struct Material {
  std::string name;
  double density = 0;
  std::optional<hs_elasticity_def> elasticity;  ///< affine blocks need one
  Place place = {};                             ///< of the name, for notes
};

/// Does it move by Newton's law?
constexpr bool moves_freely(int kind) {
  return kind == HS_BLOCK_RIGID || kind == HS_BLOCK_AFFINE || kind == HS_BLOCK_MESH;
}
/// Does it strain?
constexpr bool deforms(int kind) { return kind == HS_BLOCK_AFFINE || kind == HS_BLOCK_MESH; }

/// A tensor as the C API has it, row by row.
using Tensor = std::array<double, 9>;

/// The law of one pair of materials, named by their indices.
struct PairLaw {
  int a = 0;
  int b = 0;
  hs_law_def law{};
  Place place = {};  ///< of the materials' names, for notes
};

/// The bonds between the blocks of two materials, named by their indices.
struct PairBond {
  int a = 0;
  int b = 0;
  hs_bond_def def{};
  Place place = {};  ///< of the materials' names, for notes
};

/// A part of a run with an end of its own: the world is brought to rest, or runs on. What changes does so
/// when it begins, and stays.
struct SceneStage {
  std::string name = {};
  bool settles = false;
  hs_relaxation_def relaxation{};  ///< of one that settles
  double duration = 0;             ///< of one that runs
  bool ends_exactly = false;       ///< likewise: not at the step nearest to its end
  double rest_speed = 0;           ///< likewise; 0: it never ends early
  double ramp = 0;                 ///< likewise, s: gravity, loads and what is excavated change over it
  std::int64_t portions = 1;       ///< of one that settles: they change in so many, and it settles after each
  std::optional<Point> gravity = {};
  std::optional<double> local_damping = {};
  std::optional<double> mass_damping = {};
  std::optional<double> strength_factor = {};
  std::optional<double> loads = {};         ///< all loads of meshes are those of the scene times this
  std::vector<std::string> excavated = {};  ///< names of blocks, generators and meshes, or "mesh/group"
  Place excavated_place = {};               ///< for faults
  Place gravity_place = {};                 ///< for notes
  bool resets_displacement = false;
};

/// The names of laws in scene files, in the order of the HS_STIFFNESS_ values.
inline constexpr std::array<std::string_view, 4> law_names = {"per contact", "per area", "potential", "none"};

/// How a block moves: the initial motion of a rigid block, the motion of a prescribed one between start and
/// stop.
struct Motion {
  Point velocity{};
  Point angular_velocity{};  ///< rad/s; 2D: the last component
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
  std::optional<Tensor> stress = {};  ///< of affine blocks and meshes at the start
  double cell_size = 0;               ///< m, of blocks that are meshes, and
  int cell_kind = HS_CELL_QUAD;       ///< in 2D of what
};

/// Where a block is put, from where its vertices are given.
struct Placing {
  Point rotation{};  ///< about the origin: axis times angle, rad
  Point shift{};     ///< after that
};

/// A block given by its vertices, the blocks of a file, or those behind the segments of a boundary.
struct Block {
  Making making;
  std::vector<Point> vertices;          ///< 2D: in order; 3D without faces: points whose hull it is
  std::vector<std::vector<int>> faces;  ///< 3D: loops of vertices
  Place shape_place;                    ///< of vertices, file or boundary
  std::string file;                     ///< instead of vertices: path, from where the command runs
  std::vector<Point> boundary;          ///< 2D, instead of vertices: ends and joints of a chain of segments
  double depth = 0;                     ///< how far blocks reach behind a boundary
  double scale = 1;                     ///< length in m of one unit of the file
  std::optional<double> tolerance;      ///< 3D, m: within which facets are plane and convex
  Placing placing;
  Motion motion;
};

/// Nodes or outer faces of a mesh: those of one of its groups, or those in a box.
struct MeshPart {
  std::string group;                        ///< or, when empty,
  std::optional<std::array<Point, 2>> box;  ///< lowest and highest corner, where the mesh is put
  std::string key;                          ///< path in the file and
  Place place;                              ///< where it stands, for faults
};

/// Nodes that are held along axes.
struct MeshSupport {
  MeshPart part;
  int axes = 0;  ///< a sum of HS_AXIS_ values
  Point velocity{};
};

/// A load on outer faces, which keeps its direction.
struct MeshLoad {
  MeshPart part;
  double pressure = 0;  ///< Pa, against the faces as they are at the start
  Point traction{};     ///< Pa, besides
};

/// The cells of one group are of another material.
struct MeshMaterial {
  MeshPart part;
  int material = 0;
};

/// The bodies that the cells of a mesh are divided among: what is not one body can be bonded, and break.
enum class MeshDivision { whole, groups, cells };

/// Bodies of finite elements, from a file or a box.
struct Mesh {
  Making making;
  std::string file;                         ///< path, from where the command runs; or, when empty,
  std::optional<std::array<Point, 2>> box;  ///< lowest and highest corner, cut into
  std::array<int, 3> counts{};              ///< so many parts along each axis
  int cell_kind = HS_CELL_TRIANGLE;         ///< in which there are such cells
  Place shape_place;                        ///< of file or box
  double scale = 1;                         ///< length in m of one unit of the file
  MeshDivision division = MeshDivision::whole;
  Placing placing;
  Point velocity{};
  Tensor stress_by_height{};  ///< the change of its stress from that at the origin, Pa/m upwards
  std::vector<MeshMaterial> materials;
  std::vector<MeshSupport> supports;
  std::vector<MeshLoad> loads;
};

/// A convex part of space: in 2D a polygon, its vertices in order; in 3D the hull of points.
struct Region {
  std::vector<Point> points;
  std::string key;  ///< path in the file and
  Place place;      ///< where it stands, for faults
};

/// Parallel joints, each through the whole region.
struct JointSet {
  Point normal{0, 1, 0};  ///< unit length
  double spacing = 1;
  double offset = 0;  ///< of joint 0 from the origin, along the joints' normal
  double jitter = 0;  ///< random deviation of each spacing, share of the spacing
  std::uint64_t seed = 0;
  std::string key = {};  ///< path of the spacing in the file and
  Place place = {};      ///< where it stands, for faults
};

/// Convex regions cut by joint sets.
struct JointedRock {
  Making making;
  std::vector<Region> regions;
  double smallest_size = 0;  ///< area in 2D, volume in 3D
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

/// A convex region divided among sites: each block is what lies nearer to its site than to all others.
struct Voronoi {
  Making making;
  Region region;
  std::int64_t count = 2;
  std::int64_t relaxation = 0;  ///< how often every site is moved to the centroid of its block
  std::uint64_t seed = 0;
};

enum class Colour { displacement, speed, layer, material, mean_stress };

struct Output {
  double frame_interval = 0;
  double history_interval = 0;
  bool contacts = false;  ///< points and forces of contacts go into files
  bool forces = false;    ///< pictures show them, too
  std::vector<std::string> tracked;
  std::vector<Place> tracked_places;
  Colour colour = Colour::displacement;
  int layers = 6;
  std::vector<double> picture_times;           ///< rising; pictures beside those of the first and last moment
  bool has_stage_pictures = false;             ///< one at the end of each stage
  std::optional<std::array<Point, 2>> window;  ///< lowest and highest corner
  double azimuth = 0;  ///< rad; 3D: direction from which the camera looks, clockwise from +y seen from above
  double elevation = 0;  ///< rad above the horizontal
};

/// A figure taken of a run, which `halfspace trade` compares with its reference.
enum class Quantity { run_out, height, position, force, stands, friction_angle };

/// The figure that `halfspace trade` asks for, and what it should be.
struct Reference {
  Quantity quantity = Quantity::run_out;
  std::string block;            ///< whose position or force, and
  Place block_place;            ///< where that stands
  std::size_t axis = 0;         ///< of a position
  double time = 0;              ///< s
  std::optional<double> value;  ///< none: that of the finest run
  std::optional<double> scale;  ///< the error that counts as 1
  double limit = 0;             ///< m: what moves farther has fallen; 0: a tenth of its size
};

constexpr int most_threads = 256;  // hs_context_def::threads

/// A scene file, checked as far as it can be without making blocks.
struct Scene {
  std::string folder;  ///< of the scene file; the names of other files are relative to it
  std::string title;
  hs_world_def world{};
  double duration = 0;
  /// Where keys stand, for notes: of [world], [default_law] and [output].
  struct Places {
    Place gravity, time_step, duration, sleep_tolerance, potential_length, default_law, rest_speed;
    Place frame_interval, history_interval;
  };
  Places places;
  double rest_speed = 0;  ///< 0: the run never ends early
  int threads = 1;
  bool has_all_names = true;  ///< or tables or names are misspelt, so that a name may be known none the less
  std::vector<Material> materials;
  hs_law_def default_law{};
  std::vector<PairLaw> laws;
  std::vector<PairBond> bonds;
  std::vector<SceneStage> stages;  ///< none: the scene runs for its duration
  std::vector<Block> blocks;
  std::vector<JointedRock> jointed_rocks;
  std::vector<Triangulated> triangulated;
  std::vector<Voronoi> voronoi;
  std::vector<Mesh> meshes;
  Output output;
  Reference reference;
};

/// Calls `visit` for the making of each block and generator, but for the bodies of [[mesh]].
template <class AnyScene, class Visit>
void for_each_block_making(AnyScene& scene, Visit visit) {
  const auto visit_all = [&](auto& makers) {
    for (auto& maker : makers) visit(maker.making);
  };
  visit_all(scene.blocks);
  visit_all(scene.jointed_rocks);
  visit_all(scene.triangulated);
  visit_all(scene.voronoi);
}

/// Does the condition hold for the making of some block or generator, but for the bodies of [[mesh]]?
template <class Condition>
bool any_block_making(const Scene& scene, Condition condition) {
  bool holds = false;
  for_each_block_making(scene, [&](const Making& making) { holds = holds || condition(making); });
  return holds;
}

/// Calls `visit` for the makings of these, too.
template <class AnyScene, class Visit>
void for_each_making(AnyScene& scene, Visit visit) {
  for_each_block_making(scene, visit);
  for (auto& mesh : scene.meshes) visit(mesh.making);
}

inline bool has_spring(const hs_law_def& law) { return law.stiffness_kind != HS_STIFFNESS_NONE; }

/// Does the condition hold for the default law or one between two materials?
template <class Condition>
bool any_law(const Scene& scene, Condition condition) {
  return condition(scene.default_law) ||
         std::any_of(scene.laws.begin(), scene.laws.end(),
                     [&](const PairLaw& pair) { return condition(pair.law); });
}

}  // namespace halfspace::cli
