#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/vector.h"
#include "halfspace/halfspace.h"
#include "scene/faults.h"
#include "scene/kinds.h"

namespace halfspace::cli {

/// The limit of all generators with a `count` together, and of each [[jointed_rock]].
constexpr std::int64_t max_blocks = 10'000'000;

/// The vertical axis by default: y in 2D, z in 3D.
constexpr std::size_t up_axis(int dimension) { return dimension == 3 ? 2 : 1; }

struct Material {
  std::string name;
  double density = 0;
  std::optional<hs_elasticity_def> elasticity;  ///< affine blocks need one
  Place place = {};                             ///< of the name, for notes
};

/// True for blocks that move by Newton's laws.
constexpr bool moves_freely(int kind) {
  return kind == HS_BLOCK_RIGID || kind == HS_BLOCK_AFFINE || kind == HS_BLOCK_MESH;
}
/// True for blocks that strain.
constexpr bool deforms(int kind) { return kind == HS_BLOCK_AFFINE || kind == HS_BLOCK_MESH; }

/// A tensor in row-major order, as in the C API.
using Tensor = std::array<double, 9>;

/// The law of a pair of materials, given by their indices.
struct PairLaw {
  int a = 0;
  int b = 0;
  hs_law_def law{};
  Place place = {};                             ///< of the materials' names, for notes
  std::optional<Place> restitution_place = {};  ///< if it is given
};

/// The bonds between the blocks of two materials, given by their indices.
struct PairBond {
  int a = 0;
  int b = 0;
  hs_bond_def def{};
  Place place = {};  ///< of the materials' names, for notes
};

/// Values at times, in the order of the times. Between them values are linear.
struct TimeTable {
  std::vector<double> times;  ///< s, from the begin of a stage
  std::vector<Point> values;
  std::string key = {};  ///< path in the file, for notes
  Place place = {};      ///< for notes
};

/// The stress of rigid blocks at the start, by the weight of the rock above.
struct InSitu {
  double surface = 0;  ///< m, height at which the stress is 0
  double ratio = 0;    ///< K0: horizontal over vertical stress
  int material = 0;    ///< whose density it is
  Place place = {};
};

/// A motion or load in time of some blocks, or an acceleration of all blocks.
struct Action {
  std::string on;  ///< name of a block or generator; empty: all blocks
  std::string key;
  Place place;  ///< of that name
  int kind = HS_ACTION_FORCE;
  std::string file;  ///< of the table, or empty: path, from the working directory
  TimeTable table;
  Point scale{1, 1, 1};
  std::optional<Point> at;  ///< of a force
  bool is_carried = true;   ///< the place moves with the block
  double max_speed = 0;     ///< of a servo, m/s
  std::size_t stage = 0;    ///< that it begins with
};

/// Water below a table, as hs_world_set_water() takes it.
struct Water {
  hs_water_def def{};
  std::vector<Point> table;
};

/// The name of what carries an end of a bolt that stays.
inline constexpr std::string_view ground_name = "ground";

/// A bolt between two places.
struct Bolt {
  std::string name;
  std::array<Point, 2> ends{};
  std::array<std::string, 2> blocks{};  ///< empty: the blocks that contain the ends
  hs_bolt_def def{};                    ///< without blocks and places
  std::array<std::string, 2> keys{};    ///< paths of the ends in the file, for faults
  std::array<Place, 2> places{};        ///< of the ends, for faults
  bool is_installed_later = false;      ///< by a stage
};

/// A stage of a run: the world is brought to rest, or runs for a duration. Changes apply when it begins, and
/// persist.
struct SceneStage {
  std::string name = {};
  bool settles = false;
  hs_relaxation_def relaxation{};  ///< settle
  double duration = 0;             ///< run: s
  bool ends_exactly = false;       ///< run: the last steps are shortened to end exactly
  double rest_speed = 0;           ///< run: m/s; 0: it never ends early
  double ramp = 0;                 ///< run: s, of the changes of gravity, loads and excavation
  std::int64_t portions = 1;       ///< settle: number of increments of these changes
  std::optional<Point> gravity = {};
  std::optional<double> local_damping = {};
  std::optional<double> mass_damping = {};
  std::optional<double> strength_factor = {};
  std::optional<double> loads = {};  ///< factor of all mesh loads of the scene without a table
  std::optional<Water> water = {};
  std::vector<std::size_t> installed = {};  ///< indices of bolts
  std::vector<std::string> excavated = {};  ///< names of blocks, generators and meshes, or "mesh/group"
  Place excavated_place = {};               ///< for faults
  std::size_t index = 0;
  Place gravity_place = {};  ///< for notes
  bool resets_displacement = false;
  std::optional<hs_law_def> default_law = {};  ///< whole, as for all laws of a stage
  std::vector<PairLaw> laws = {};
};

/// The initial motion of a free block, or the motion of a prescribed block between start and stop.
struct Motion {
  Point velocity{};
  Point angular_velocity{};  ///< rad/s; 2D: the last component
  double start = 0;
  double stop = std::numeric_limits<double>::infinity();
  std::int64_t held_axes = 0;  ///< of a rigid block: a sum of HS_AXIS_ values
};

/// Properties common to blocks and generators.
struct Making {
  std::string name;
  std::string key;  ///< path in the file, for faults
  Place place;      ///< of the name, for faults
  int material = 0;
  int kind = HS_BLOCK_RIGID;
  std::optional<Tensor> stress = {};  ///< initial, of affine blocks and meshes
  double cell_size = 0;               ///< m, of mesh blocks
  int cell_kind = HS_CELL_QUAD;       ///< 2D: of mesh blocks
};

/// The placing of a block: a rotation, then a translation of the given vertices.
struct Placing {
  Point rotation{};  ///< about the origin: axis times angle, rad
  Point shift{};     ///< after the rotation, m
};

/// A block given by its vertices, in 2D concave ones as well, the blocks of a file, or the blocks behind the
/// segments of a boundary.
struct Block {
  Making making;
  std::vector<Point> vertices;          ///< 2D: in order; 3D without faces: points of a convex hull
  std::vector<std::vector<int>> faces;  ///< 3D: loops of vertices
  Place shape_place;                    ///< of vertices, file or boundary
  std::string file;                     ///< instead of vertices: path, from the working directory
  std::vector<Point> boundary;          ///< 2D, instead of vertices: points of a chain of segments
  double depth = 0;                     ///< m, thickness of the blocks behind a boundary
  double scale = 1;                     ///< length in m of one unit of the file
  std::optional<double> tolerance;      ///< 3D, m: of planarity and convexity
  bool is_joined = false;               ///< 3D: all solids of the file are one compound
  Placing placing;
  Motion motion;
};

/// Nodes or outer faces of a mesh: those of a group, or those in a box.
struct MeshPart {
  std::string group;                        ///< empty: those in the box
  std::optional<std::array<Point, 2>> box;  ///< lowest and highest corner, in the placed mesh
  std::string key;                          ///< path in the file, for faults
  Place place;                              ///< for faults
};

/// Nodes held along axes.
struct MeshSupport {
  MeshPart part;
  int axes = 0;  ///< a sum of HS_AXIS_ values
  Point velocity{};
  TimeTable table = {};   ///< factors of the velocity; empty: it is constant
  std::size_t stage = 0;  ///< that the table begins with
};

/// A dead load on outer faces: it keeps its direction.
struct MeshLoad {
  MeshPart part;
  double pressure = 0;    ///< Pa, against the outward normals at the start
  Point traction{};       ///< Pa, added to the pressure
  TimeTable table = {};   ///< factors of the load; empty: it is constant
  std::size_t stage = 0;  ///< that the table begins with
};

/// The material of one group of cells.
struct MeshMaterial {
  MeshPart part;
  int material = 0;
};

/// The division of a mesh into bodies. Separate bodies can be bonded, and break apart.
enum class MeshDivision { whole, groups, cells };

/// Bodies of finite elements, from a file or a box.
struct Mesh {
  Making making;
  std::string file;                         ///< path, from the working directory; empty: a box
  std::optional<std::array<Point, 2>> box;  ///< lowest and highest corner
  std::array<int, 3> counts{};              ///< number of cells of the box along each axis
  int cell_kind = HS_CELL_TRIANGLE;         ///< of the cells of the box
  Place shape_place;                        ///< of file or box
  double scale = 1;                         ///< length in m of one unit of the file
  MeshDivision division = MeshDivision::whole;
  Placing placing;
  Point velocity{};
  Tensor stress_by_height{};  ///< vertical gradient of the initial stress, Pa/m; that stress is at the origin
  std::vector<MeshMaterial> materials;
  std::vector<MeshSupport> supports;
  std::vector<MeshLoad> loads;
  std::vector<MeshPart> viscous;  ///< outer faces that waves leave
};

/// A convex region: in 2D a polygon with its vertices in order, in 3D the hull of points.
struct Region {
  std::vector<Point> points;
  std::string key;  ///< path in the file, for faults
  Place place;      ///< for faults
};

/// Parallel joints, each through the whole region.
struct JointSet {
  Point normal{0, 1, 0};  ///< unit length
  double spacing = 1;
  double offset = 0;  ///< of joint 0 from the origin, along the joints' normal
  double jitter = 0;  ///< max random deviation of each spacing, fraction of the spacing
  std::uint64_t seed = 0;
  std::string key = {};  ///< path of the spacing in the file, for faults
  Place place = {};      ///< for faults
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

/// A convex region divided into the Voronoi cells of random sites.
struct Voronoi {
  Making making;
  Region region;
  std::int64_t count = 2;
  std::int64_t relaxation = 0;  ///< iterations, each of which moves every site to the centroid of its cell
  std::uint64_t seed = 0;
};

/// An open surface of triangles as a fixed boundary, 3D.
struct Terrain {
  Making making;
  std::string file;  ///< path, from the working directory
  Place shape_place;
  double depth = 0;    ///< m, extent of the blocks behind the surface
  Point shift{};       ///< m
  double scale = 1;    ///< STL, OBJ: length in m of one unit of the file
  double spacing = 1;  ///< height map: m, between nodes
  double lowest = 0;   ///< PNG: height of black, m
  double highest = 1;  ///< PNG: height of white, m
};

/// A point whose motion is written to the history. A block carries it along.
struct TrackedPoint {
  std::string name;
  Point at{};
  std::string key;  ///< path of its position in the file, for faults
  Place place;      ///< of the position, for faults
};

/// A joint that is written to the history: two blocks, given by their names or by a point near to both.
struct TrackedJoint {
  std::string name;
  std::vector<std::string> blocks;  ///< two names; empty: the blocks at the point
  Point at{};
  std::string key;  ///< path of the blocks or of the point in the file, for faults
  Place place;      ///< of the blocks or of the point, for faults
};

enum class Colour { displacement, speed, layer, material, mean_stress };

struct Output {
  double frame_interval = 0;
  double history_interval = 0;
  bool contacts = false;     ///< points and forces of contacts are written to files
  bool forces = false;       ///< contact forces are drawn
  bool joints = false;       ///< joints between rigid blocks are written at the end
  bool open_joints = false;  ///< 2D: they are drawn
  bool thrust = false;       ///< 2D: the thrust line is drawn
  std::vector<std::string> tracked;
  std::vector<Place> tracked_places;
  std::vector<TrackedPoint> tracked_points;
  std::vector<TrackedJoint> tracked_joints;
  Colour colour = Colour::displacement;
  int layers = 6;
  std::vector<double> picture_times;           ///< s, increasing; besides the first and the last picture
  bool has_stage_pictures = false;             ///< one at the end of each stage
  bool numbers = false;                        ///< of blocks are drawn
  std::optional<std::array<Point, 2>> window;  ///< lowest and highest corner
  double azimuth = 0;  ///< rad; 3D: direction from which the camera looks, clockwise from +y seen from above
  double elevation = 0;  ///< rad above the horizontal

  /// For runs whose blocks may be others than those of the scene.
  void track_nothing() {
    tracked.clear();
    tracked_points.clear();
    tracked_joints.clear();
  }
};

/// A quantity of a run, which `halfspace trade` compares with its reference.
enum class Quantity { run_out, height, position, force, stands, friction_angle };

/// The quantity that `halfspace trade` measures, and its reference value.
struct Reference {
  bool is_given = false;  ///< by the scene
  Quantity quantity = Quantity::run_out;
  std::string block;            ///< of a position or a force
  Place block_place;            ///< of its name, for faults
  std::size_t axis = 0;         ///< of a position
  double time = 0;              ///< s
  std::optional<double> value;  ///< empty: that of the run with the smallest step
  std::optional<double> scale;  ///< the difference that is an error of 1
  double limit = 0;             ///< m, displacement of a fallen block; 0: a tenth of its size
};

constexpr int max_threads = 256;  // hs_context_def::threads

/// A scene file, checked except for the shapes of its blocks.
struct Scene {
  std::string folder;  ///< of the scene file; the names of other files are relative to it
  std::string title;
  std::string settings;  ///< of the command line, for reports
  hs_world_def world{};
  double duration = 0;
  /// Places of keys of [world], [default_law] and [output], for notes.
  struct Places {
    Place gravity, time_step, duration, sleep_tolerance, potential_length, default_law, rest_speed;
    Place frame_interval, history_interval, window, water;
    /// Places of keys that may be missing.
    std::optional<Place> restitution, impulse_tolerance, max_impulse_iterations, locate_impacts;
  };
  Places places;
  double rest_speed = 0;  ///< 0: the run never ends early
  int threads = 1;
  bool has_all_names = true;  ///< false: tables or names are misspelt, so that an unknown name may be valid
  std::vector<Material> materials;
  hs_law_def default_law{};
  bool is_law_set = false;  ///< a setting of the command line has replaced its kind
  std::vector<PairLaw> laws;
  std::vector<PairBond> bonds;
  std::optional<Water> water;
  std::vector<Bolt> bolts;
  std::vector<SceneStage> stages;  ///< empty: the scene runs for its duration
  std::vector<Action> actions;
  std::optional<InSitu> in_situ;
  std::vector<Block> blocks;
  std::vector<JointedRock> jointed_rocks;
  std::vector<Triangulated> triangulated;
  std::vector<Voronoi> voronoi;
  std::vector<Mesh> meshes;
  std::vector<Terrain> terrains;
  Output output;
  Reference reference;
};

/// True if there is water, at some time.
inline bool has_water(const Scene& scene) {
  return scene.water || std::any_of(scene.stages.begin(), scene.stages.end(),
                                    [](const SceneStage& stage) { return stage.water.has_value(); });
}

/// Calls `visit` for the making of each block and generator, except [[mesh]] and [[terrain]].
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

/// True if the condition holds for any block or generator, except [[mesh]].
template <class Condition>
bool any_block_making(const Scene& scene, Condition condition) {
  bool holds = false;
  for_each_block_making(scene, [&](const Making& making) { holds = holds || condition(making); });
  return holds;
}

/// Calls `visit` for the making of each block, generator, mesh and terrain.
template <class AnyScene, class Visit>
void for_each_making(AnyScene& scene, Visit visit) {
  for_each_block_making(scene, visit);
  for (auto& mesh : scene.meshes) visit(mesh.making);
  for (auto& terrain : scene.terrains) visit(terrain.making);
}

inline bool has_spring(const hs_law_def& law) { return law.stiffness_kind != HS_STIFFNESS_NONE; }
inline bool has_no_spring(const hs_law_def& law) { return !has_spring(law); }
inline bool holds_together(const hs_law_def& law) { return law.cohesion > 0 || law.tensile_strength > 0; }

/// Stiffnesses of two aligned faces, along their normal and along them, over those of a law: area of both, in
/// 2D their length, where these are per area. By potentials faces repel each other like springs per area of
/// 2 k / H.
inline double normal_per_face(int stiffness_kind, double area, double potential_length) {
  if (stiffness_kind == HS_STIFFNESS_PER_AREA) return area;
  return stiffness_kind == HS_STIFFNESS_POTENTIAL ? 2 * area / potential_length : 1;
}
inline double shear_per_face(int stiffness_kind, double area) {
  return stiffness_kind == HS_STIFFNESS_PER_AREA ? area : 1;
}

/// The law that the blocks of two materials follow.
inline const hs_law_def& law_between(const Scene& scene, int a, int b) {
  for (const PairLaw& pair : scene.laws) {
    if (std::minmax(pair.a, pair.b) == std::minmax(a, b)) return pair.law;
  }
  return scene.default_law;
}

/// Calls `visit` for the default law, and for the laws of pairs and of stages.
template <class AnyScene, class Visit>
void for_each_law(AnyScene& scene, Visit visit) {
  visit(scene.default_law);
  for (auto& pair : scene.laws) visit(pair.law);
  for (auto& stage : scene.stages) {
    if (stage.default_law) visit(*stage.default_law);
    for (auto& pair : stage.laws) visit(pair.law);
  }
}

/// True if the condition holds for any of these laws.
template <class Condition>
bool any_law(const Scene& scene, Condition condition) {
  bool holds = false;
  for_each_law(scene, [&](const hs_law_def& law) { holds = holds || condition(law); });
  return holds;
}

}  // namespace halfspace::cli
