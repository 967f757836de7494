#include "scene/read_terrains.h"

#include <filesystem>
#include <string>
#include <utility>

#include "scene/read_values.h"

namespace halfspace::cli {
namespace {

bool has_extension(const std::string& file, std::string_view lower, std::string_view upper) {
  return file.ends_with(lower) || file.ends_with(upper);
}

void read_grid(Keys& keys, bool is_image, Terrain& terrain) {
  terrain.spacing = keys.number("spacing", above(0), required);
  if (!is_image) return;
  terrain.lowest = keys.number("lowest", any_number(), required);
  terrain.highest = keys.number("highest", above(terrain.lowest), required);
}

}  // namespace

void read_terrains(std::vector<Keys> tables, Scene& scene) {
  for (Keys& keys : tables) {
    Terrain terrain;
    terrain.making = {.name = read_name(keys), .key = keys.path("name"), .place = keys.place("name")};
    terrain.making.key.resize(terrain.making.key.size() - std::string_view(".name").size());
    const std::string material = keys.text("material", required);
    if (keys.has("material"))
      terrain.making.material = material_index(keys, "material", material, scene).value_or(0);
    terrain.making.kind = HS_BLOCK_FIXED;
    const std::string file = keys.text("file", required);
    terrain.file = (std::filesystem::path(scene.folder) / file).string();
    terrain.shape_place = keys.place("file");
    terrain.shift = keys.point("shift", Point{});
    terrain.depth = keys.number("depth", above(0), required);
    const bool is_image = has_extension(file, ".png", ".PNG");
    if (is_image || has_extension(file, ".csv", ".CSV")) {
      read_grid(keys, is_image, terrain);
    } else {
      terrain.scale = keys.number("scale", above(0), terrain.scale);
    }
    keys.finish();
    scene.terrains.push_back(std::move(terrain));
  }
}

}  // namespace halfspace::cli
