#include <sstream>

#include "interface/scene_handle.h"
#include "notes/notes.h"
#include "scene/read_scene.h"
#include "scene/settings.h"

namespace halfspace::cli {

void require_faultless(const hs_scene& scene, const Faults& faults) {
  if (!faults.none()) throw Refusal(HS_ERROR_FORMAT, faults.describe(scene.file.path));
}

void require_read(const hs_scene& scene, hs_context* context) {
  if (!scene.is_read) throw Refusal(HS_ERROR_STATE, "the scene is empty; read one first");
  require_given(context, "context");
}

CheckedScene read_in(hs_context* context, const SceneFile& file) {
  CheckedScene checked;
  checked.scene = read_scene_text(*file.content, file.path, checked.faults, file.settings);
  checked.context = borrowed(context);
  return checked;
}

CheckedScene checked_scene(const hs_scene& scene, hs_context* context) {
  require_read(scene, context);
  CheckedScene checked = read_in(context, scene.file);
  lay_out(checked);
  require_faultless(scene, checked.faults);
  return checked;
}

void set_notes(hs_scene& scene, CheckedScene& checked, const Model& model) {
  note_start(checked.context, checked.scene, model, checked.faults);
  scene.notes = checked.faults.describe_notes(scene.file.path);
}

std::string lines_of(const std::vector<std::string>& texts) {
  std::string lines;
  for (const std::string& text : texts) lines += text + '\n';
  return lines;
}

namespace {

/// The text of a scene with its settings; without settings its own text.
std::string toml_of(const SceneFile& file) {
  if (file.settings.empty()) return *file.content;
  toml::table table = toml::parse(*file.content);
  Faults faults;
  apply_settings(file.settings, table, faults);
  std::ostringstream text;
  text << table << '\n';
  return text.str();
}

std::vector<std::string> texts(const char* const values[], int64_t count) {
  std::vector<std::string> texts;
  for (int64_t i = 0; i < count; ++i) {
    require_given(values[i], "settings[]");
    texts.emplace_back(values[i]);
  }
  return texts;
}

}  // namespace
}  // namespace halfspace::cli

using namespace halfspace::cli;

hs_status hs_scene_create(hs_scene** scene) {
  if (!scene) return HS_ERROR_ARGUMENT;
  *scene = new (std::nothrow) hs_scene;
  return *scene ? HS_OK : HS_ERROR_OUT_OF_MEMORY;
}

void hs_scene_destroy(hs_scene* scene) { delete scene; }

const char* hs_scene_last_error(const hs_scene* scene) { return scene ? scene->last_error.c_str() : ""; }

const char* hs_scene_get_text(const hs_scene* scene, int32_t text) {
  if (!scene) return "";
  switch (text) {
    case HS_SCENE_TEXT_TOML:
      return scene->toml.c_str();
    case HS_SCENE_TEXT_NOTES:
      return scene->notes.c_str();
    case HS_SCENE_TEXT_NAMES:
      return scene->names.c_str();
    case HS_SCENE_TEXT_REPORT:
      return scene->report.c_str();
    case HS_SCENE_TEXT_TROUBLE:
      return scene->trouble.c_str();
    default:
      return "";
  }
}

hs_status hs_scene_read(hs_scene* scene, const char* toml, size_t size, const char* file,
                        const char* const settings[], int64_t setting_count) {
  return guarded(scene, [&] {
    require_given(toml, "toml");
    require_given(file, "file");
    if (setting_count < 0) throw Refusal(HS_ERROR_ARGUMENT, "setting_count is below 0");
    if (setting_count > 0) require_given(settings, "settings");
    SceneFile given{.path = file, .settings = texts(settings, setting_count), .content = {{toml, size}}};
    Faults faults;
    Scene found = read_scene_text(*given.content, given.path, faults, given.settings);
    if (!faults.none()) throw Refusal(HS_ERROR_FORMAT, faults.describe(given.path));
    std::string text = toml_of(given);
    *scene = hs_scene();
    scene->file = std::move(given);
    scene->scene = std::move(found);
    scene->toml = std::move(text);
    scene->is_read = true;
  });
}

hs_status hs_scene_get_properties(hs_scene* scene, hs_scene_properties* properties) {
  return guarded(scene, [&] {
    if (!scene->is_read) throw Refusal(HS_ERROR_STATE, "the scene is empty; read one first");
    require_given(properties, "properties");
    *properties = {.dimension = scene->scene.world.dimension,
                   .threads = scene->scene.threads,
                   .duration = scene->scene.duration,
                   .stage_count = static_cast<int64_t>(scene->scene.stages.size())};
  });
}

hs_status hs_scene_make_world(hs_scene* scene, hs_context* context, hs_world** world) {
  return guarded(scene, [&] {
    CheckedScene checked = checked_scene(*scene, context);
    Model model(checked.context, checked.scene, std::move(checked.layout));
    set_notes(*scene, checked, model);
    scene->names = lines_of(model.names());
    if (world) *world = model.release_world().release();
  });
}

hs_status hs_scene_make_shapes(hs_scene* scene, hs_context* context, int64_t* count) {
  return guarded(scene, [&] {
    require_given(count, "count");
    CheckedScene checked = checked_scene(*scene, context);
    scene->shapes.clear();
    for (LayoutBlock& block : checked.layout.blocks) scene->shapes.push_back(std::move(block.shape));
    *count = static_cast<int64_t>(scene->shapes.size());
  });
}

hs_status hs_scene_take_shape(hs_scene* scene, int64_t index, hs_shape** shape) {
  return guarded(scene, [&] {
    require_given(shape, "shape");
    if (index < 0 || index >= static_cast<int64_t>(scene->shapes.size()))
      throw Refusal(HS_ERROR_ARGUMENT, "index is " + std::to_string(index) + "; the scene has " +
                                           std::to_string(scene->shapes.size()) + " shapes");
    halfspace::cli::Shape& made = scene->shapes[static_cast<std::size_t>(index)];
    if (!made) throw Refusal(HS_ERROR_STATE, "shape " + std::to_string(index) + " was taken before");
    *shape = made.release();
  });
}
