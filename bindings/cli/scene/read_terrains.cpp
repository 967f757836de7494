#include "scene/read_terrains.h"

#include <filesystem>
#include <string>
#include <utility>

#include "common/files.h"
#include "scene/read_values.h"

namespace halfspace::cli {
namespace {

/// The keys that belong to the kind of the file; those of any kind while that is unknown.
void read_keys_of_file(Keys& keys, const std::string& extension, Terrain& terrain) {
  const bool is_image = extension == ".png", is_grid = extension == ".asc";
  if (is_image || is_grid || extension == ".csv") {
    terrain.spacing = keys.number("spacing", above(0), is_grid ? std::optional(0.0) : required);
    if (!is_image) return;
    terrain.lowest = keys.number("lowest", any_number(), required);
    terrain.highest = keys.number("highest", above(terrain.lowest), required);
  } else {
    terrain.scale = keys.number("scale", above(0), terrain.scale);
    if (extension != ".stl" && extension != ".obj") keys.has_any({"spacing", "lowest", "highest"});
  }
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
    read_keys_of_file(keys, extension_of(file), terrain);
    keys.finish();
    scene.terrains.push_back(std::move(terrain));
  }
}

}  // namespace halfspace::cli
