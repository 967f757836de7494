#include "read_scene.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <numbers>
#include <set>
#include <stdexcept>
#include <utility>

#include "keys.h"

namespace halfspace::cli {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr std::int64_t any_integer = std::numeric_limits<std::int64_t>::max();

double degrees(Keys& keys, std::string_view key, Range range, std::optional<double> fallback) {
  return degree * keys.number(key, range, fallback);
}

/// Names become columns of a table, so they are kept to what needs no quotes.
std::string read_name(Keys& keys) {
  const std::string name = keys.text("name", required);
  const bool plain = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.';
  });
  if (keys.has("name") && (name.empty() || !plain)) {
    keys.fault("name", "not a name: \"" + name + "\"; allowed: letters, digits, '_', '-' and '.'");
  }
  return name;
}

void read_world(Keys keys, Scene& scene) {
  hs_world_def& world = scene.world;
  hs_world_def_init(&world, sizeof world);
  const Point gravity = keys.point("gravity", Point{world.gravity[0], world.gravity[1]});
  world.gravity[0] = gravity[0];
  world.gravity[1] = gravity[1];
  scene.duration = keys.number("duration", above(0), required);
  world.time_step = keys.number("time_step", above(0), world.time_step);
  world.safety = keys.number("safety", {.low = 0, .high = 1, .with_low = false}, world.safety);
  world.local_damping =
      keys.number("local_damping", {.low = 0, .high = 1, .with_high = false}, world.local_damping);
  world.mass_damping = keys.number("mass_damping", at_least(0), world.mass_damping);
  world.skin = keys.number("skin", {.low = 0, .high = 1, .with_low = false}, world.skin);
  world.parallel_angle =
      degrees(keys, "parallel_angle", {.low = 0, .high = 28}, world.parallel_angle / degree);
  world.vertex_zone = keys.number("vertex_zone", {.low = 0, .high = 0.5}, world.vertex_zone);
  scene.rest_speed = keys.number("rest_speed", above(0), scene.rest_speed);
  keys.finish();
}

void read_materials(std::vector<Keys> tables, Scene& scene) {
  for (Keys& keys : tables) {
    Material material{read_name(keys), keys.number("density", above(0), required)};
    const bool twice = std::any_of(scene.materials.begin(), scene.materials.end(),
                                   [&](const Material& other) { return other.name == material.name; });
    if (twice && !material.name.empty())
      keys.fault("name", "used twice: \"" + material.name + "\"; allowed: a new name");
    scene.materials.push_back(std::move(material));
    keys.finish();
  }
}

int material_index(Keys& keys, std::string_view key, const std::string& name, const Scene& scene) {
  std::vector<std::string_view> names;
  for (const Material& material : scene.materials) names.push_back(material.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  keys.fault(key, "no such material: \"" + name + '"' + suggestion(name, names) +
                      "; allowed: the name of a [[material]]");
  return 0;
}

/// The keys of a law; what is not said keeps the value it has in `law`.
void read_law_values(Keys& keys, hs_law_def& law, bool is_whole) {
  const bool changes_kind = !is_whole && keys.has("stiffness");
  const std::optional<int> kind = is_whole ? std::nullopt : std::optional(law.stiffness_kind);
  law.stiffness_kind = keys.word("stiffness", {"per contact", "per area"}, kind);
  const auto stiffness = [&](double inherited) {
    // A stiffness in other units than the default law's cannot come from it.
    return is_whole || changes_kind ? std::optional<double>() : inherited;
  };
  law.normal_stiffness = keys.number("normal_stiffness", above(0), stiffness(law.normal_stiffness));
  law.shear_stiffness = keys.number("shear_stiffness", at_least(0), stiffness(law.shear_stiffness));
  law.friction_angle = degrees(keys, "friction_angle", {.low = 0, .high = 90, .with_high = false},
                               law.friction_angle / degree);
  law.cohesion = keys.number("cohesion", at_least(0), law.cohesion);
  law.tensile_strength = keys.number("tensile_strength", at_least(0), law.tensile_strength);
  law.normal_damping = keys.number("normal_damping", at_least(0), law.normal_damping);
  law.shear_damping = keys.number("shear_damping", at_least(0), law.shear_damping);
}

void read_default_law(Keys keys, Scene& scene) {
  hs_law_def_init(&scene.default_law, sizeof scene.default_law);
  read_law_values(keys, scene.default_law, true);
  keys.finish();
}

void read_laws(std::vector<Keys> tables, Scene& scene) {
  for (Keys& keys : tables) {
    PairLaw pair{.law = scene.default_law};
    std::vector<Place> places;
    const std::vector<std::string> between = keys.texts("between", places, required);
    if (between.size() == 2) {
      pair.a = material_index(keys, "between", between[0], scene);
      pair.b = material_index(keys, "between", between[1], scene);
    } else if (!between.empty()) {
      keys.fault("between", std::to_string(between.size()) + " materials; allowed: two, [\"a\", \"b\"]");
    }
    read_law_values(keys, pair.law, false);
    const bool twice = std::any_of(scene.laws.begin(), scene.laws.end(), [&](const PairLaw& other) {
      return std::minmax(other.a, other.b) == std::minmax(pair.a, pair.b);
    });
    if (twice && between.size() == 2) {
      keys.fault("between", "a law between \"" + between[0] + "\" and \"" + between[1] +
                                "\" was given before; allowed: one law for two materials");
    }
    scene.laws.push_back(pair);
    keys.finish();
  }
}

Making read_making(Keys& keys, const Scene& scene, bool may_be_prescribed) {
  Making making{.name = read_name(keys), .key = keys.path("name"), .place = keys.place("name")};
  making.key.resize(making.key.size() - std::string_view(".name").size());
  const std::string material = keys.text("material", required);
  if (keys.has("material")) making.material = material_index(keys, "material", material, scene);
  static constexpr int kinds[] = {HS_BLOCK_RIGID, HS_BLOCK_FIXED, HS_BLOCK_PRESCRIBED};
  making.kind = kinds[may_be_prescribed ? keys.word("kind", {"rigid", "fixed", "prescribed"}, 0)
                                        : keys.word("kind", {"rigid", "fixed"}, 0)];
  return making;
}

Motion read_motion(Keys& keys, int kind) {
  Motion motion;
  motion.velocity = keys.point("velocity", Point{});
  motion.angular_velocity = degrees(keys, "angular_velocity", any_number(), 0.0);
  motion.start = keys.number("start", at_least(0), motion.start);
  motion.stop = keys.number("stop", above(motion.start), motion.stop);
  for (const char* key : {"velocity", "angular_velocity"}) {
    if (kind == HS_BLOCK_FIXED && keys.has(key)) {
      keys.fault(key, "a fixed block does not move; allowed: with kind = \"rigid\" or \"prescribed\"");
    }
  }
  for (const char* key : {"start", "stop"}) {
    if (kind != HS_BLOCK_PRESCRIBED && keys.has(key)) {
      keys.fault(key, "only a prescribed motion starts and stops; allowed: with kind = \"prescribed\"");
    }
  }
  return motion;
}

void read_blocks(std::vector<Keys> tables, Scene& scene) {
  for (Keys& keys : tables) {
    Block block;
    block.making = read_making(keys, scene, true);
    block.vertices = keys.points("vertices", 3, required);
    block.vertices_place = keys.place("vertices");
    block.motion = read_motion(keys, block.making.kind);
    scene.blocks.push_back(std::move(block));
    keys.finish();
  }
}

JointSet read_joint_set(Keys& keys) {
  JointSet set;
  set.dip = degrees(keys, "dip", {.low = -90, .high = 90, .with_low = false}, required);
  set.spacing = keys.number("spacing", above(0), required);
  set.offset = keys.number("offset", any_number(), set.offset);
  set.spread = keys.number("spread", {.low = 0, .high = 1, .with_high = false}, set.spread);
  set.seed = static_cast<std::uint64_t>(keys.integer("seed", 0, any_integer, 0));
  keys.finish();
  return set;
}

void read_jointed_rocks(std::vector<Keys> tables, Scene& scene) {
  for (Keys& keys : tables) {
    JointedRock rock;
    rock.making = read_making(keys, scene, false);
    rock.region = keys.points("region", 3, required);
    rock.region_place = keys.place("region");
    rock.smallest_area = keys.number("smallest_area", at_least(0), rock.smallest_area);
    for (Keys& set : keys.tables("joint_set", true)) rock.joint_sets.push_back(read_joint_set(set));
    scene.jointed_rocks.push_back(std::move(rock));
    keys.finish();
  }
}

void read_triangulated(std::vector<Keys> tables, Scene& scene) {
  constexpr std::int64_t most_triangles = 10'000'000;
  for (Keys& keys : tables) {
    Triangulated region;
    region.making = read_making(keys, scene, false);
    region.lower_left = keys.point("lower_left", required);
    region.upper_right = keys.point("upper_right", required);
    region.count = keys.integer("count", 2, most_triangles, required);
    region.jitter = keys.number("jitter", {.low = 0, .high = 0.25, .with_high = false}, 0.2);
    region.seed = static_cast<std::uint64_t>(keys.integer("seed", 0, any_integer, 0));
    if (region.count % 2 != 0) {
      keys.fault("count", "odd: " + std::to_string(region.count) + "; allowed: an even number of triangles");
    }
    const bool has_area =
        region.upper_right[0] > region.lower_left[0] && region.upper_right[1] > region.lower_left[1];
    if (keys.has("lower_left") && keys.has("upper_right") && !has_area) {
      keys.fault("upper_right",
                 "not above and to the right of lower_left; allowed: a rectangle with an area");
    }
    scene.triangulated.push_back(std::move(region));
    keys.finish();
  }
}

void read_output(Keys keys, Scene& scene) {
  Output& output = scene.output;
  output.frame_interval = keys.number("frame_interval", above(0), scene.duration);
  output.history_interval = keys.number("history_interval", above(0), output.frame_interval);
  output.tracked = keys.texts("tracked", output.tracked_places, std::vector<std::string>{});
  Keys picture = keys.table("picture", false);
  output.colour =
      static_cast<Colour>(picture.word("colour", {"displacement", "speed", "layer", "material"}, 0));
  output.layers = static_cast<int>(picture.integer("layers", 1, 1000, output.layers));
  output.picture_times =
      picture.rising_numbers("times", {.low = 0, .high = scene.duration, .with_low = false});
  const std::vector<Point> window = picture.points("window", 2, std::vector<Point>{});
  if (window.size() == 2 && window[1][0] > window[0][0] && window[1][1] > window[0][1]) {
    output.window = {{window[0], window[1]}};
  } else if (!window.empty()) {
    picture.fault("window", "not a window; allowed: two points, [lower left, upper right]");
  }
  picture.finish();
  keys.finish();
}

Scene read_top(Keys keys, Faults& faults) {
  Scene scene;
  scene.title = keys.text("title", std::string());
  keys.integer("dimension", 2, 2, required);
  read_world(keys.table("world", true), scene);
  read_materials(keys.tables("material", true), scene);
  read_default_law(keys.table("default_law", true), scene);
  read_laws(keys.tables("law", false), scene);
  read_blocks(keys.tables("block", false), scene);
  read_jointed_rocks(keys.tables("jointed_rock", false), scene);
  read_triangulated(keys.tables("triangulated", false), scene);
  read_output(keys.table("output", false), scene);
  keys.finish();
  if (scene.blocks.empty() && scene.jointed_rocks.empty() && scene.triangulated.empty() && faults.none()) {
    faults.add({}, "", "no blocks; required: a [[block]], [[jointed_rock]] or [[triangulated]]");
  }
  return scene;
}

std::string content_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad()) throw std::runtime_error("cannot read " + file);
  return content;
}

}  // namespace

Scene read_scene(const std::string& file, Faults& faults) {
  const std::string content = content_of(file);
  try {
    const toml::table table = toml::parse(content, file);
    return read_top(Keys(table, "", faults), faults);
  } catch (const toml::parse_error& error) {
    const toml::source_position begin = error.source().begin;
    faults.add({static_cast<int>(begin.line), static_cast<int>(begin.column)}, "",
               "not TOML: " + std::string(error.description()));
    return {};
  }
}

}  // namespace halfspace::cli
