#pragma once

// Tables and actions of a scene's world.

#include <functional>

#include "validation/scene.h"

namespace halfspace_test {

/// Rows of a table: a time and three components.
struct TableRow {
  double time;
  double x = 0, y = 0, z = 0;
};
using TableRows = std::vector<TableRow>;

inline int32_t add_table(const Scene& scene, const TableRows& rows) {
  std::vector<double> times;
  for (const TableRow& row : rows) times.push_back(row.time);
  int32_t table = -1;
  scene.check(hs_world_add_table(
      scene.world(), times.data(),
      {&rows[0].x, &rows[0].y, &rows[0].z, sizeof(TableRow), std::int64_t(rows.size())}, &table));
  return table;
}

inline hs_action_def action_def(int32_t kind, int32_t table) {
  hs_action_def def;
  if (hs_action_def_init(&def, sizeof def) != HS_OK) throw std::runtime_error("no action definition");
  def.kind = kind;
  def.table = table;
  return def;
}

inline void act(const Scene& scene, hs_block block, int32_t kind, const TableRows& rows,
                const std::function<void(hs_action_def&)>& change = {}) {
  hs_action_def def = action_def(kind, add_table(scene, rows));
  if (change) change(def);
  scene.check(hs_world_add_action(scene.world(), block, &def));
}

/// Changes only the x component.
inline void only_x(hs_action_def& def) { def.scale[1] = def.scale[2] = 0; }

inline void hold(const Scene& scene, hs_block block, int32_t axes) {
  scene.check(hs_world_hold_block(scene.world(), block, axes));
}

}  // namespace halfspace_test
