#include "scene/read_water.h"

#include <cmath>

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

std::vector<Point> read_table(Keys& keys) {
  const char* other = keys.dimension() == 3 ? "plane" : "table";
  if (keys.either("level", other)) return read_level(keys);
  return keys.dimension() == 3 ? read_plane(keys) : read_line(keys);
}

}  // namespace

std::optional<Water> read_water(Keys& keys, const std::optional<Water>& before) {
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
  if (!before || table.has_any({"level", line})) water.table = read_table(table);
  table.finish();
  return water;
}

}  // namespace halfspace::cli
