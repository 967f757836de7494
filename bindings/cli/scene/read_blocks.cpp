#include "scene/read_blocks.h"

#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "blocks/rock/jointed_rock.h"
#include "scene/read_actions.h"
#include "scene/read_meshes.h"
#include "scene/read_terrains.h"
#include "scene/read_values.h"

namespace halfspace::cli {
namespace {

std::uint64_t read_seed(Keys& keys) {
  return static_cast<std::uint64_t>(keys.integer("seed", 0, std::numeric_limits<std::int64_t>::max(), 0));
}

Making read_making(Keys& keys, const Scene& scene, bool may_be_prescribed) {
  Making making{.name = read_name(keys), .key = keys.path("name"), .place = keys.place("name")};
  making.key.resize(making.key.size() - std::string_view(".name").size());
  const std::string material = keys.text("material", required);
  std::optional<int> known;
  if (keys.has("material")) known = material_index(keys, "material", material, scene);
  making.material = known.value_or(0);
  static constexpr int kinds[] = {HS_BLOCK_RIGID, HS_BLOCK_FIXED, HS_BLOCK_AFFINE, HS_BLOCK_MESH,
                                  HS_BLOCK_PRESCRIBED};
  making.kind =
      kinds[may_be_prescribed ? keys.kind("kind", {"rigid", "fixed", "affine", "mesh", "prescribed"}, 0)
                              : keys.kind("kind", {"rigid", "fixed", "affine", "mesh"}, 0)];
  if (deforms(making.kind) && known && !scene.materials[static_cast<std::size_t>(*known)].elasticity) {
    keys.fault("kind",
               "the material \"" + material +
                   "\" is not elastic; allowed: with young_modulus and poisson_ratio in its [[material]]");
  }
  making.stress = read_stress(keys);
  if (making.stress && !deforms(making.kind) && keys.is_kind_known()) {
    keys.fault(keys.has("normal_stress") ? "normal_stress" : "shear_stress",
               "only blocks that strain have a stress; allowed: with kind = \"affine\" or \"mesh\"");
  }
  if (making.kind == HS_BLOCK_MESH) {
    making.cell_size = keys.number("cell_size", above(0), required);
    if (keys.dimension() == 2) making.cell_kind = keys.word("cell", {"triangle", "quad"}, HS_CELL_QUAD);
  }
  return making;
}

Motion read_motion(Keys& keys, int kind) {
  Motion motion;
  motion.velocity = keys.point("velocity", Point{});
  motion.angular_velocity = rotation(keys, "angular_velocity");
  motion.start = keys.number("start", at_least(0), motion.start);
  motion.stop = keys.number("stop", above(motion.start), motion.stop);
  for (const char* key : {"velocity", "angular_velocity"}) {
    if (kind == HS_BLOCK_FIXED && keys.has(key)) {
      keys.fault(key,
                 "a fixed block does not move; allowed: with kind = \"rigid\", \"affine\" or \"prescribed\"");
    }
  }
  if (kind == HS_BLOCK_MESH && keys.has("angular_velocity"))
    keys.fault("angular_velocity", "a mesh has no initial angular velocity; allowed: velocity");
  for (const char* key : {"start", "stop"}) {
    if (kind != HS_BLOCK_PRESCRIBED && keys.is_kind_known() && keys.has(key)) {
      keys.fault(key, "only a prescribed motion starts and stops; allowed: with kind = \"prescribed\"");
    }
  }
  return motion;
}

void read_tolerance(Keys& keys, Block& block) {
  if (keys.has("tolerance")) block.tolerance = keys.number("tolerance", at_least(0), required);
}

void read_file(Keys& keys, const Scene& scene, Block& block) {
  block.file = (std::filesystem::path(scene.folder) / keys.text("file", required)).string();
  block.scale = keys.number("scale", above(0), block.scale);
  block.shape_place = keys.place("file");
  block.is_joined = keys.boolean("joined", false);
  if (block.is_joined && deforms(block.making.kind) && keys.is_kind_known()) {
    keys.fault("joined",
               "joined solids do not strain; allowed: with kind = \"rigid\", \"fixed\" or \"prescribed\"");
  }
  read_tolerance(keys, block);
}

void read_vertices(Keys& keys, Block& block) {
  const std::size_t min_count = keys.dimension() == 3 ? 4 : 3;
  block.vertices = keys.points("vertices", min_count, required);
  block.shape_place = keys.place("vertices");
  if (keys.dimension() == 2) return;
  read_tolerance(keys, block);
  // The number of faulty vertices is unknown.
  block.faces =
      keys.loops("faces", block.vertices.empty() ? std::numeric_limits<int>::max() : block.vertices.size());
}

void read_boundary(Keys& keys, Block& block) {
  block.boundary = keys.points("boundary", 2, required);
  block.depth = keys.number("depth", above(0), required);
  block.shape_place = keys.place("boundary");
  if (moves_freely(block.making.kind) && keys.is_kind_known()) {
    keys.fault("boundary",
               "a boundary does not move freely; allowed: with kind = \"fixed\" or \"prescribed\"");
  }
}

void read_blocks(std::vector<Keys> tables, Scene& scene) {
  for (Keys& keys : tables) {
    Block block;
    block.making = read_making(keys, scene, true);
    if (keys.dimension() == 3 && keys.either("file", "vertices")) {
      read_file(keys, scene, block);
    } else if (keys.dimension() == 2 && keys.either("boundary", "vertices")) {
      read_boundary(keys, block);
    } else {
      read_vertices(keys, block);
    }
    block.placing = {.rotation = rotation(keys, "rotation"), .shift = keys.point("shift", Point{})};
    block.motion = read_motion(keys, block.making.kind);
    block.motion.held_axes = read_axes(keys, "hold", "", true);
    if (block.motion.held_axes != 0 && block.making.kind != HS_BLOCK_RIGID && keys.is_kind_known())
      keys.fault("hold", "only rigid blocks can be held; allowed: with kind = \"rigid\"");
    scene.blocks.push_back(std::move(block));
    keys.finish();
  }
}

/// The corners of a box: counter-clockwise in 2D.
std::vector<Point> corners_of_box(const Point& low, const Point& high, int dimension) {
  std::vector<Point> corners;
  for (double z : {low[2], high[2]}) {
    corners.insert(corners.end(),
                   {{low[0], low[1], z}, {high[0], low[1], z}, {high[0], high[1], z}, {low[0], high[1], z}});
    if (dimension == 2) break;
  }
  return corners;
}

Region read_region(Keys& keys) {
  if (!keys.either("box", "region")) {
    const std::size_t min_count = keys.dimension() == 3 ? 4 : 3;
    std::vector<Point> points = keys.points("region", min_count, required);
    return {std::move(points), keys.path("region"), keys.place("region")};
  }
  Region region{{}, keys.path("box"), keys.place("box")};
  const std::vector<Point> box = keys.points("box", 2, required);
  if (box.size() == 2 && spans(box[0], box[1], keys.dimension())) {
    region.points = corners_of_box(box[0], box[1], keys.dimension());
  } else if (!box.empty()) {
    keys.fault("box", "not a box; allowed: two points, [lowest corner, highest corner]");
  }
  return region;
}

JointSet read_joint_set(Keys& keys) {
  JointSet set;
  if (keys.dimension() == 2) {
    set.normal = joint_normal(degrees(keys, "dip", {.low = -90, .high = 90, .with_low = false}, required));
  } else {
    const double dip = degrees(keys, "dip", {.low = 0, .high = 90}, required);
    const double direction = degrees(keys, "dip_direction", {.low = -360, .high = 360}, required);
    set.normal = joint_normal(dip, direction);
  }
  set.spacing = keys.number("spacing", above(0), required);
  set.offset = keys.number("offset", any_number(), set.offset);
  set.jitter = keys.number("jitter", {.low = 0, .high = 1, .with_high = false}, set.jitter);
  set.seed = read_seed(keys);
  set.key = keys.path("spacing");
  set.place = keys.place("spacing");
  keys.finish();
  return set;
}

void read_jointed_rocks(std::vector<Keys> tables, Scene& scene) {
  for (Keys& keys : tables) {
    JointedRock rock;
    rock.making = read_making(keys, scene, false);
    if (keys.either("part", "region")) {
      for (Keys& part : keys.tables("part", true)) {
        rock.regions.push_back(read_region(part));
        part.finish();
      }
    } else {
      rock.regions.push_back(read_region(keys));
    }
    const char* smallest = keys.dimension() == 3 ? "smallest_volume" : "smallest_area";
    rock.smallest_size = keys.number(smallest, at_least(0), rock.smallest_size);
    for (Keys& set : keys.tables("joint_set", true)) rock.joint_sets.push_back(read_joint_set(set));
    scene.jointed_rocks.push_back(std::move(rock));
    keys.finish();
  }
}

void read_triangulated(std::vector<Keys> tables, Scene& scene) {
  for (Keys& keys : tables) {
    Triangulated region;
    region.making = read_making(keys, scene, false);
    region.lower_left = keys.point("lower_left", required);
    region.upper_right = keys.point("upper_right", required);
    region.count = keys.integer("count", 2, max_blocks, required);
    region.jitter = keys.number("jitter", {.low = 0, .high = 0.25, .with_high = false}, 0.2);
    region.seed = read_seed(keys);
    if (region.count % 2 != 0) {
      keys.fault("count", "odd: " + std::to_string(region.count) + "; allowed: an even number of triangles");
    }
    if (keys.has("lower_left") && keys.has("upper_right") &&
        !spans(region.lower_left, region.upper_right, 2)) {
      keys.fault("upper_right",
                 "not above and to the right of lower_left; allowed: a rectangle with an area");
    }
    scene.triangulated.push_back(std::move(region));
    keys.finish();
  }
}

void read_voronoi(std::vector<Keys> tables, Scene& scene) {
  constexpr std::int64_t max_relaxation = 10'000;
  for (Keys& keys : tables) {
    Voronoi voronoi;
    voronoi.making = read_making(keys, scene, false);
    voronoi.region = read_region(keys);
    voronoi.count = keys.integer("count", 2, max_blocks, required);
    voronoi.relaxation = keys.integer("relaxation", 0, max_relaxation, voronoi.relaxation);
    voronoi.seed = read_seed(keys);
    scene.voronoi.push_back(std::move(voronoi));
    keys.finish();
  }
}

}  // namespace

bool read_blocks(Keys& top, Scene& scene) {
  read_blocks(top.tables("block", false), scene);
  read_jointed_rocks(top.tables("jointed_rock", false), scene);
  if (top.dimension() == 2) {
    read_triangulated(top.tables("triangulated", false), scene);
  } else {
    read_voronoi(top.tables("voronoi", false), scene);
  }
  read_meshes(top.tables("mesh", false), scene);
  if (top.dimension() == 3) read_terrains(top.tables("terrain", false), scene);
  bool has_some = false;
  for_each_making(scene, [&](const Making&) { has_some = true; });
  return has_some;
}

}  // namespace halfspace::cli
