#include "scene/read_water.h"

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "blocks/mesh/mesh_fault.h"
#include "blocks/terrain/height_map.h"
#include "common/files.h"
#include "common/text.h"

namespace halfspace::cli {
namespace {

/// A level table is one point.
std::vector<Point> read_level(Keys& keys) {
  Point at{};
  at[up_axis(keys.dimension())] = keys.number("level", any_number(), required);
  return {at};
}

std::vector<Point> read_line(Keys& keys) {
  const std::vector<Point> table = keys.points("table", 2, required);
  for (std::size_t i = 1; i < table.size(); ++i) {
    if (table[i][0] >= table[i - 1][0]) continue;
    keys.fault("table", "point " + std::to_string(i) + " is to the left of the one before; allowed: points " +
                            "in ascending order of x");
    break;
  }
  return table;
}

std::vector<Point> read_plane(Keys& keys) {
  const std::vector<Point> plane = keys.points("plane", 3, required);
  if (plane.size() > 3) keys.fault("plane", std::to_string(plane.size()) + " points; allowed: three");
  return plane;
}

/// The heights of a CSV file, whose first row is the northernmost, as points with ascending x and y.
void read_map(Keys& keys, const std::string& folder, Water& water) {
  const std::string name = keys.nonempty_text("file");
  const bool is_grid = extension_of(name) == ".asc";
  const double given = keys.number("spacing", above(0), is_grid ? std::optional(0.0) : required);
  const Point shift = keys.point("shift", Point{});
  if (keys.has_any({"level", "plane"}))
    keys.fault("file", "beside level or plane; allowed: one of level, plane and file");
  if (name.empty() || !std::isfinite(given)) return;  // a fault already
  try {
    const HeightMap map = read_heights(name, content_of((std::filesystem::path(folder) / name).string()));
    const double spacing = spacing_of(map, name, given);
    water.def.columns = static_cast<int32_t>(map.columns);
    water.table.clear();
    for (std::size_t row = map.rows; row-- > 0;) {
      for (std::size_t column = 0; column < map.columns; ++column) {
        const Point node = map.node(column, row, spacing);
        if (std::isnan(node[2]))
          throw MeshFault(
              name, "no data at [" + shortest(node[0]) + ", " + shortest(node[1]) + "]; allowed: heights");
        water.table.push_back(plus(shift, node));
      }
    }
  } catch (const std::runtime_error& error) {
    keys.fault("file", error.what());
  }
}

std::vector<Point> read_table(Keys& keys) {
  const char* other = keys.dimension() == 3 ? "plane" : "table";
  if (keys.either("level", other)) return read_level(keys);
  return keys.dimension() == 3 ? read_plane(keys) : read_line(keys);
}

}  // namespace

std::optional<Water> read_water(Keys& keys, const std::optional<Water>& before, const std::string& folder) {
  if (!keys.has_any({"water"})) return std::nullopt;
  Keys table = keys.table("water", true);
  Water water;
  if (before) {
    water = *before;
  } else {
    hs_water_def_init(&water.def, sizeof water.def);
  }
  water.def.density = table.number("density", at_least(0), water.def.density);
  water.def.factor = table.number("factor", at_least(0), water.def.factor);
  const char* line = table.dimension() == 3 ? "plane" : "table";
  if (table.dimension() == 3 && table.has_any({"file"})) {
    read_map(table, folder, water);
  } else if (!before || table.has_any({"level", line})) {
    water.table = read_table(table);
    water.def.columns = 0;
  }
  table.finish();
  return water;
}

}  // namespace halfspace::cli
