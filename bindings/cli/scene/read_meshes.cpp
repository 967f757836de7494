#include "scene/read_meshes.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "common/text.h"
#include "scene/read_actions.h"
#include "scene/read_values.h"

namespace halfspace::cli {
namespace {

/// The two corners of a box; it may be flat unless it is solid.
std::optional<std::array<Point, 2>> read_box(Keys& keys, bool is_solid) {
  const std::vector<Point> box = keys.points("box", 2, required);
  if (box.empty()) return std::nullopt;  // a fault already
  bool is_box = box.size() == 2;
  for (std::size_t axis = 0; is_box && axis < static_cast<std::size_t>(keys.dimension()); ++axis)
    is_box = box[0][axis] <= box[1][axis];
  if (is_box && is_solid) is_box = spans(box[0], box[1], keys.dimension());
  if (is_box) return std::array{box[0], box[1]};
  keys.fault("box", "not a box; allowed: two points, [lowest corner, highest corner]");
  return std::nullopt;
}

MeshPart read_part(Keys& keys) {
  MeshPart part;
  if (keys.either("box", "group")) {
    part = {.group = {}, .box = read_box(keys, false), .key = keys.path("box"), .place = keys.place("box")};
    if (keys.has("group")) keys.fault("group", "a box is given as well; allowed: one of the two");
  } else {
    part = {.group = keys.nonempty_text("group"),
            .box = {},
            .key = keys.path("group"),
            .place = keys.place("group")};
  }
  return part;
}

int elastic_material(Keys& keys, const Scene& scene) {
  const std::string name = keys.text("material", required);
  if (!keys.has("material")) return 0;
  const std::optional<int> index = material_index(keys, "material", name, scene);
  if (index && !scene.materials[static_cast<std::size_t>(*index)].elasticity) {
    keys.fault("material", "the material \"" + name +
                               "\" is not elastic; allowed: with young_modulus and poisson_ratio in its "
                               "[[material]]");
  }
  return index.value_or(0);
}

/// The box of a mesh, the number of its cells along each axis, and their kind.
void read_cut(Keys& keys, Mesh& mesh) {
  mesh.box = read_box(keys, true);
  mesh.shape_place = keys.place("box");
  constexpr std::int64_t max_along = 100'000;
  const auto dimension = static_cast<std::size_t>(keys.dimension());
  const std::vector<std::int64_t> counts = keys.integers("cells", dimension, 1, max_along);
  double all = 1;
  for (std::size_t axis = 0; axis < std::min(counts.size(), dimension); ++axis) {
    mesh.counts[axis] = static_cast<int>(counts[axis]);
    all *= static_cast<double>(counts[axis]);
  }
  if (all > max_blocks)
    keys.fault("cells", rounded(all, 3) + " cells in all; allowed: at most " + std::to_string(max_blocks));
  if (dimension == 2) {
    mesh.cell_kind = keys.word("cell", {"triangle", "quad"}, HS_CELL_TRIANGLE);
  } else {
    mesh.cell_kind = HS_CELL_TETRAHEDRON + keys.word("cell", {"tetrahedron", "prism", "hexahedron"}, 0);
  }
}

Mesh read_mesh(Keys& keys, const Scene& scene) {
  Mesh mesh;
  mesh.making = {.name = read_name(keys), .key = keys.path("name"), .place = keys.place("name")};
  mesh.making.key.resize(mesh.making.key.size() - std::string_view(".name").size());
  mesh.making.kind = HS_BLOCK_MESH;
  mesh.making.material = elastic_material(keys, scene);
  if (keys.either("box", "file")) {
    read_cut(keys, mesh);
  } else {
    mesh.file = (std::filesystem::path(scene.folder) / keys.text("file", required)).string();
    mesh.scale = keys.number("scale", above(0), mesh.scale);
    mesh.shape_place = keys.place("file");
  }
  mesh.division = static_cast<MeshDivision>(keys.word("bodies", {"whole", "groups", "cells"}, 0));
  mesh.placing = {.rotation = rotation(keys, "rotation"), .shift = keys.point("shift", Point{})};
  mesh.velocity = keys.point("velocity", Point{});
  mesh.making.stress = read_stress(keys);
  const Point by_height = keys.point("normal_stress_by_height", Point{});
  for (std::size_t axis = 0; axis < 3; ++axis) mesh.stress_by_height[4 * axis] = by_height[axis];
  if (by_height != Point{} && !mesh.making.stress) mesh.making.stress = Tensor{};
  for (Keys& table : keys.tables("group", false)) {
    MeshMaterial part{.part = {.group = table.text("name", required),
                               .box = {},
                               .key = table.path("name"),
                               .place = table.place("name")},
                      .material = elastic_material(table, scene)};
    mesh.materials.push_back(std::move(part));
    table.finish();
  }
  for (Keys& table : keys.tables("support", false)) {
    MeshSupport support{.part = read_part(table),
                        .axes = read_axes(table, "axes", table.dimension() == 3 ? "xyz" : "xy", false),
                        .velocity = table.point("velocity", Point{}),
                        .table = read_factors(table),
                        .stage = read_stage_name(table, scene)};
    mesh.supports.push_back(std::move(support));
    table.finish();
  }
  for (Keys& table : keys.tables("load", false)) {
    MeshLoad load{.part = read_part(table)};
    load.pressure = table.number("pressure", any_number(), 0);
    load.traction = table.point("traction", Point{});
    if (load.pressure == 0 && load.traction == Point{})
      table.note(table.has("group") ? "group" : "box",
                 "no pressure and no traction: this load has no effect");
    load.table = read_factors(table);
    load.stage = read_stage_name(table, scene);
    mesh.loads.push_back(std::move(load));
    table.finish();
  }
  for (Keys& table : keys.tables("viscous", false)) {
    mesh.viscous.push_back(read_part(table));
    table.finish();
  }
  keys.finish();
  return mesh;
}

}  // namespace

void read_meshes(std::vector<Keys> tables, Scene& scene) {
  for (Keys& keys : tables) scene.meshes.push_back(read_mesh(keys, scene));
}

}  // namespace halfspace::cli
