// The library of scenes, by its C interface: what it refuses, and what callbacks can do.
#include <cmath>
#include <filesystem>
#include <string>

#include "capi/handles.h"
#include "catch.h"
#include "halfspace/scene.h"

using namespace halfspace_test;

namespace {

struct DestroyScene {
  void operator()(hs_scene* scene) const { hs_scene_destroy(scene); }
};
using Scene = std::unique_ptr<hs_scene, DestroyScene>;

Scene make_scene() {
  hs_scene* scene = nullptr;
  REQUIRE(hs_scene_create(&scene) == HS_OK);
  return Scene(scene);
}

const std::string falling = R"(
dimension = 2
world.duration = 0.5
world.time_step = 1e-3
default_law = { stiffness = "per contact", normal_stiffness = 1e8, friction_angle = 30 }
material = [{ name = "stone", density = 2500 }]
block = [{ name = "stone", material = "stone", vertices = [[0, 0], [1, 0], [1, 1], [0, 1]] }]
output.history_interval = 0.1
)";

hs_status read(const Scene& scene, const std::string& text) {
  return hs_scene_read(scene.get(), text.data(), text.size(), "falling.toml", nullptr, 0);
}

bool names(const Scene& scene, const std::string& part) {
  return std::string(hs_scene_last_error(scene.get())).find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("an empty scene refuses all work") {
  const Scene scene = make_scene();
  const Context context = make_context();
  hs_world* world = nullptr;
  hs_scene_properties properties;
  int64_t count = 0;
  CHECK(hs_scene_get_properties(scene.get(), &properties) == HS_ERROR_STATE);
  CHECK(hs_scene_make_world(scene.get(), context.get(), &world) == HS_ERROR_STATE);
  CHECK(hs_scene_make_shapes(scene.get(), context.get(), &count) == HS_ERROR_STATE);
  CHECK(names(scene, "the scene is empty"));
  CHECK(std::string(hs_scene_get_text(scene.get(), HS_SCENE_TEXT_TOML)).empty());
  CHECK(std::string(hs_scene_get_text(scene.get(), 99)).empty());
}

TEST_CASE("arguments that are missing are named") {
  const Scene scene = make_scene();
  const Context context = make_context();
  hs_scene_run_def run;
  hs_scene_run_def_init(&run);
  hs_scene_safety_def safety;
  hs_scene_safety_def_init(&safety);
  hs_scene_limit_def limit;
  hs_scene_limit_def_init(&limit);
  CHECK(hs_scene_create(nullptr) == HS_ERROR_ARGUMENT);
  CHECK(read(Scene(), falling) == HS_ERROR_ARGUMENT);
  CHECK(hs_scene_read(scene.get(), nullptr, 0, "s.toml", nullptr, 0) == HS_ERROR_ARGUMENT);
  CHECK(names(scene, "toml is NULL"));
  CHECK(hs_scene_read(scene.get(), "", 0, "s.toml", nullptr, 1) == HS_ERROR_ARGUMENT);
  CHECK(names(scene, "settings is NULL"));
  REQUIRE(read(scene, falling) == HS_OK);
  CHECK(hs_scene_run(scene.get(), context.get(), &run, nullptr, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(names(scene, "directory is NULL"));
  CHECK(hs_scene_make_world(scene.get(), nullptr, nullptr) == HS_ERROR_ARGUMENT);
  safety.directory = "unused";
  safety.low = NAN;
  CHECK(hs_scene_find_safety(scene.get(), context.get(), &safety, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(names(scene, "low below high"));
  CHECK(hs_scene_find_limit(scene.get(), context.get(), &limit, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(names(scene, "directory is NULL"));
  limit.directory = "unused";
  CHECK(hs_scene_find_limit(scene.get(), nullptr, &limit, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(names(scene, "context is NULL"));
  limit.varied = HS_SCENE_VARY_SETTING;
  CHECK(hs_scene_find_limit(scene.get(), context.get(), &limit, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(names(scene, "a setting requires name"));
  limit.varied = 3;
  CHECK(hs_scene_find_limit(scene.get(), context.get(), &limit, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(names(scene, "varied is 3"));
  limit.varied = HS_SCENE_VARY_TILT;
  limit.limit = NAN;
  CHECK(hs_scene_find_limit(scene.get(), context.get(), &limit, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(names(scene, "limit is nan"));
  CHECK(!std::filesystem::exists("unused"));
  CHECK(hs_scene_write_vtk(scene.get(), context.get(), nullptr, nullptr, "a.vtp", nullptr) ==
        HS_ERROR_ARGUMENT);
  hs_scene_destroy(nullptr);
  CHECK(std::string(hs_scene_last_error(nullptr)).empty());
}

TEST_CASE("a faulty scene leaves the scene before as it was") {
  const Scene scene = make_scene();
  REQUIRE(read(scene, falling) == HS_OK);
  CHECK(read(scene, "dimension = 4") == HS_ERROR_FORMAT);
  CHECK(names(scene, "falling.toml:1:13: dimension: out of range: 4"));
  CHECK(hs_scene_get_text(scene.get(), HS_SCENE_TEXT_TOML) == falling);
  const Context context = make_context();
  CHECK(hs_scene_make_world(scene.get(), context.get(), nullptr) == HS_OK);
  CHECK(std::string(hs_scene_get_text(scene.get(), HS_SCENE_TEXT_NAMES)) == "stone\n");
}

TEST_CASE("a shape is handed over once") {
  const Scene scene = make_scene();
  const Context context = make_context();
  REQUIRE(read(scene, falling) == HS_OK);
  int64_t count = 0;
  REQUIRE(hs_scene_make_shapes(scene.get(), context.get(), &count) == HS_OK);
  CHECK(count == 1);
  hs_shape* shape = nullptr;
  CHECK(hs_scene_take_shape(scene.get(), 1, &shape) == HS_ERROR_ARGUMENT);
  CHECK(hs_scene_take_shape(scene.get(), -1, &shape) == HS_ERROR_ARGUMENT);
  REQUIRE(hs_scene_take_shape(scene.get(), 0, &shape) == HS_OK);
  const Shape owned(shape);
  CHECK(hs_scene_take_shape(scene.get(), 0, &shape) == HS_ERROR_STATE);
}

TEST_CASE("rows of the history are the world's, and end the run") {
  const Scene scene = make_scene();
  const Context context = make_context();
  REQUIRE(read(scene, falling) == HS_OK);
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "halfspace_scene_library";
  std::filesystem::remove_all(folder);
  const std::string directory = folder.string();
  struct Seen {
    int rows = 0;
    double time = 0;
  } seen;
  hs_scene_run_def def;
  hs_scene_run_def_init(&def);
  def.directory = directory.c_str();
  def.user = &seen;
  def.row = [](void* user, hs_world* world) -> int32_t {
    hs_world_report report;
    if (hs_world_get_report(world, &report, sizeof report) != HS_OK) return 1;
    static_cast<Seen*>(user)->time = report.time;
    return ++static_cast<Seen*>(user)->rows == 3;
  };
  hs_scene_run_result result;
  hs_world* world = nullptr;
  REQUIRE(hs_scene_run(scene.get(), context.get(), &def, &result, &world) == HS_OK);
  const World end(world);
  CHECK(result.end == HS_SCENE_INTERRUPTED);
  CHECK(result.steps == 200);  // rows at 0, 0.1 and 0.2 s
  CHECK(std::abs(seen.time - 0.2) < 1e-12);
  CHECK(std::abs(result.max_displacement - 0.5 * 9.81 * 0.2 * 0.2) < 1e-12);
  CHECK(hs_scene_run(scene.get(), context.get(), &def, nullptr, nullptr) == HS_ERROR_STATE);
  CHECK(names(scene, "is not empty"));
  std::filesystem::remove_all(folder);
}
