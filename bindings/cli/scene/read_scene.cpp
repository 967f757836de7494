#include "scene/read_scene.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "common/files.h"
#include "common/text.h"
#include "notes/unusual_values.h"
#include "scene/deep_key.h"
#include "scene/keys.h"
#include "scene/read_actions.h"
#include "scene/read_blocks.h"
#include "scene/read_bolts.h"
#include "scene/read_laws.h"
#include "scene/read_reference.h"
#include "scene/read_stages.h"
#include "scene/read_tracked.h"
#include "scene/read_values.h"
#include "scene/read_water.h"
#include "scene/settings.h"

namespace halfspace::cli {
namespace {

void read_world(Keys keys, bool has_stages, Scene& scene) {
  hs_world_def& world = scene.world;
  hs_world_def_init(&world, sizeof world, keys.dimension());
  const Point gravity = keys.point("gravity", std::to_array(world.gravity));
  std::copy(gravity.begin(), gravity.end(), world.gravity);
  for (const std::string key : {"duration", "rest_speed"})
    if (has_stages && keys.has(key))
      keys.fault(key, "not allowed with stages; allowed: " + key + " in a [[stage]] that runs");
  scene.duration =
      has_stages ? keys.number("duration", above(0), 0.0) : keys.number("duration", above(0), required);
  world.time_step = keys.number("time_step", above(0), world.time_step);
  world.safety = keys.number("safety", {.low = 0, .high = 1, .with_low = false}, world.safety);
  world.local_damping =
      keys.number("local_damping", {.low = 0, .high = 1, .with_high = false}, world.local_damping);
  world.mass_damping = keys.number("mass_damping", at_least(0), world.mass_damping);
  world.skin = keys.number("skin", {.low = 0, .high = 1, .with_low = false}, world.skin);
  world.parallel_angle =
      degrees(keys, "parallel_angle", {.low = 0, .high = 28}, world.parallel_angle / degree);
  world.vertex_zone = keys.number("vertex_zone", {.low = 0, .high = 0.5}, world.vertex_zone);
  world.potential_length = keys.number("potential_length", above(0), world.potential_length);
  world.fast_blocks = keys.word("fast_blocks", {"divide", "refuse"}, world.fast_blocks);
  world.sleep_tolerance = keys.number("sleep_tolerance", at_least(0), world.sleep_tolerance);
  world.impulse_tolerance = keys.number("impulse_tolerance", above(0), world.impulse_tolerance);
  world.max_impulse_iterations = static_cast<std::int32_t>(
      keys.integer("max_impulse_iterations", 1, 1'000'000, world.max_impulse_iterations));
  world.locate_impacts = keys.boolean("locate_impacts", world.locate_impacts != 0);
  scene.rest_speed = keys.number("rest_speed", above(0), scene.rest_speed);
  scene.threads = static_cast<int>(keys.integer("threads", 1, max_threads, scene.threads));
  Scene::Places& places = scene.places;
  places.gravity = keys.place("gravity");
  places.time_step = keys.place("time_step");
  places.duration = keys.place("duration");
  places.sleep_tolerance = keys.place("sleep_tolerance");
  places.potential_length = keys.place("potential_length");
  places.rest_speed = keys.place("rest_speed");
  places.impulse_tolerance = keys.place_if_given("impulse_tolerance");
  places.max_impulse_iterations = keys.place_if_given("max_impulse_iterations");
  if (world.locate_impacts) places.locate_impacts = keys.place_if_given("locate_impacts");
  keys.finish();
}

/// Empty if there is no key of elasticity.
std::optional<hs_elasticity_def> read_elasticity(Keys& keys) {
  const bool has_plane = keys.dimension() == 2 && keys.has_any({"plane"});
  if (!keys.has_any({"young_modulus", "poisson_ratio", "damping_time"}) && !has_plane) return std::nullopt;
  hs_elasticity_def elasticity;
  hs_elasticity_def_init(&elasticity, sizeof elasticity);
  elasticity.young_modulus = keys.number("young_modulus", above(0), required);
  elasticity.poisson_ratio =
      keys.number("poisson_ratio", {.low = -1, .high = 0.5, .with_low = false, .with_high = false}, required);
  if (keys.dimension() == 2) elasticity.plane = keys.word("plane", {"strain", "stress"}, 0);
  elasticity.damping_time = keys.number("damping_time", at_least(0), elasticity.damping_time);
  return elasticity;
}

void read_materials(std::vector<Keys> tables, Scene& scene) {
  for (Keys& keys : tables) {
    Material material{read_name(keys), keys.number("density", above(0), required), read_elasticity(keys),
                      keys.place("name")};
    const bool twice = std::any_of(scene.materials.begin(), scene.materials.end(),
                                   [&](const Material& other) { return other.name == material.name; });
    if (twice && !material.name.empty())
      keys.fault("name", "used twice: \"" + material.name + "\"; allowed: a new name");
    scene.materials.push_back(std::move(material));
    keys.finish();
  }
}

void read_in_situ(Keys keys, Scene& scene) {
  InSitu in_situ;
  in_situ.surface = keys.number("surface", any_number(), required);
  in_situ.ratio = keys.number("K0", at_least(0), required);
  const std::string material = keys.text("material", required);
  if (keys.has("material")) in_situ.material = material_index(keys, "material", material, scene).value_or(0);
  in_situ.place = keys.place();
  keys.finish();
  scene.in_situ = in_situ;
}

void read_output(Keys keys, Scene& scene) {
  Output& output = scene.output;
  output.frame_interval =
      keys.number("frame_interval", above(0),
                  scene.duration > 0 ? scene.duration / 50 : std::numeric_limits<double>::infinity());
  output.history_interval = keys.number("history_interval", above(0), output.frame_interval);
  scene.places.frame_interval = keys.place("frame_interval");
  scene.places.history_interval = keys.place("history_interval");
  output.tracked = keys.texts_among("tracked", output.tracked_places);
  read_tracked_points(keys.tables_among("tracked"), scene);
  read_tracked_joints(keys.tables("joints", false), scene);
  output.contacts = keys.boolean("contacts", output.contacts);
  output.joints = keys.boolean("joint_forces", output.joints);
  Keys picture = keys.table("picture", false);
  output.forces = keys.dimension() == 2 && picture.boolean("forces", output.forces);
  output.open_joints = keys.dimension() == 2 && picture.boolean("open_joints", output.open_joints);
  output.thrust = keys.dimension() == 2 && picture.boolean("thrust", output.thrust);
  output.colour = static_cast<Colour>(
      picture.word("colour", {"displacement", "speed", "layer", "material", "mean_stress"}, 0));
  output.layers = static_cast<int>(picture.integer("layers", 1, 1000, output.layers));
  output.picture_times = picture.rising_numbers("times", above(0));
  output.has_stage_pictures = !scene.stages.empty() && picture.boolean("stages", output.has_stage_pictures);
  // The duration of a stage that settles is unknown.
  const bool is_length_known = std::none_of(scene.stages.begin(), scene.stages.end(),
                                            [](const SceneStage& stage) { return stage.settles; });
  if (is_length_known && !output.picture_times.empty() && output.picture_times.back() > scene.duration) {
    picture.note("times", shortest(output.picture_times.back()) + " s is after the end of the run, " +
                              shortest(scene.duration) + " s: this picture is not drawn");
  }
  output.numbers = picture.boolean("numbers", output.numbers);
  const std::vector<Point> window = picture.points("window", 2, std::vector<Point>{});
  if (window.size() == 2 && spans(window[0], window[1], keys.dimension())) {
    output.window = {{window[0], window[1]}};
    scene.places.window = picture.place("window");
  } else if (!window.empty()) {
    picture.fault("window", "not a window; allowed: two points, [lowest corner, highest corner]");
  }
  if (keys.dimension() == 3) {
    output.azimuth = degrees(picture, "azimuth", {.low = -360, .high = 360}, 150.0);
    output.elevation = degrees(picture, "elevation", {.low = -90, .high = 90}, 25.0);
  }
  picture.finish();
  keys.finish();
}

const std::initializer_list<std::string_view> top_keys = {
    "title", "dimension", "world",        "material",     "default_law", "law",      "bond",
    "stage", "block",     "jointed_rock", "triangulated", "voronoi",     "mesh",     "terrain",
    "water", "bolt",      "action",       "in_situ",      "output",      "reference"};

Scene read_top(Keys keys, const std::string& folder, Faults& faults) {
  Scene scene;
  scene.folder = folder;
  scene.title = keys.text("title", std::string());
  keys.set_dimension(static_cast<int>(keys.integer("dimension", 2, 3, required)));
  scene.has_all_names = keys.has_only(top_keys);
  if (keys.is_misspelt("dimension")) {  // the number of components of points is unknown
    keys.has_any(top_keys);
    keys.finish();
    return scene;
  }
  read_world(keys.table("world", true), keys.has("stage") || keys.is_misspelt("stage"), scene);
  read_materials(keys.tables("material", true), scene);
  read_default_law(keys.table("default_law", true), scene);
  read_laws(keys.tables("law", false), scene);
  read_bonds(keys.tables("bond", false), scene);
  scene.water = read_water(keys, {}, scene.folder);
  scene.places.water = keys.place("water");
  read_bolts(keys.tables("bolt", false), scene);
  read_stages(keys.tables("stage", false), scene);
  read_actions(keys.tables("action", false), scene);
  if (keys.has_any({"in_situ"})) read_in_situ(keys.table("in_situ", true), scene);
  const bool has_blocks = read_blocks(keys, scene);
  read_output(keys.table("output", false), scene);
  read_reference(keys.table("reference", false), scene);
  keys.finish();
  if (!has_blocks && faults.none()) {
    faults.add({}, "",
               std::string("no blocks; required: a [[block]], [[jointed_rock]], [[mesh]] or ") +
                   (keys.dimension() == 3 ? "[[voronoi]]" : "[[triangulated]]"));
  }
  return scene;
}

}  // namespace

Scene read_scene(const std::string& file, Faults& faults, const std::vector<std::string>& settings) {
  return read_scene_text(content_of(file), file, faults, settings);
}

Scene read_scene_text(const std::string& content, const std::string& file, Faults& faults,
                      const std::vector<std::string>& settings) {
  if (const std::optional<Place> place = deep_key(content, max_names)) {
    faults.add(*place, "",
               "more than " + std::to_string(max_names) + " names in a key; allowed: the keys of a scene");
    return {};
  }
  try {
    toml::table table = toml::parse(content, file);
    apply_settings(settings, table, faults);
    note_unusual_values(table, faults);
    Scene scene =
        read_top(Keys(table, "", faults), std::filesystem::path(file).parent_path().string(), faults);
    scene.settings = joined(settings);
    return scene;
  } catch (const toml::parse_error& error) {
    const toml::source_position begin = error.source().begin;
    faults.add({static_cast<int>(begin.line), static_cast<int>(begin.column)}, "",
               "not TOML: " + std::string(error.description()));
    return {};
  }
}

}  // namespace halfspace::cli
