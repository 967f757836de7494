#pragma once

// Water and bolts through the C API. No test logic.

#include "capi/meshes.h"

namespace halfspace_test {

inline hs_water_def water_def(double density = 1000, double factor = 1) {
  hs_water_def def;
  if (hs_water_def_init(&def, sizeof def) != HS_OK) throw std::runtime_error("no water definition");
  def.density = density;
  def.factor = factor;
  return def;
}

inline void set_water(hs_context* context, hs_world* world, const Points3& table, double density = 1000) {
  const hs_water_def def = water_def(density);
  require_ok(hs_world_set_water(world, &def, view_of(table)), context);
}

inline void set_water_map(hs_context* context, hs_world* world, const Points3& map, std::int32_t columns) {
  hs_water_def def = water_def();
  def.columns = columns;
  require_ok(hs_world_set_water(world, &def, view_of(map)), context);
}

inline hs_bolt_def bolt_def(hs_block a, const Point3& at_a, hs_block b, const Point3& at_b,
                            double stiffness) {
  hs_bolt_def def;
  if (hs_bolt_def_init(&def, sizeof def) != HS_OK) throw std::runtime_error("no bolt definition");
  def.block_a = a;
  def.block_b = b;
  const double places[2][3] = {{at_a.x, at_a.y, at_a.z}, {at_b.x, at_b.y, at_b.z}};
  std::copy(places[0], places[0] + 3, def.place_a);
  std::copy(places[1], places[1] + 3, def.place_b);
  def.stiffness = stiffness;
  return def;
}

inline std::int64_t add_bolt(hs_context* context, hs_world* world, const hs_bolt_def& def) {
  std::int64_t number = -1;
  require_ok(hs_world_add_bolt(world, &def, &number), context);
  return number;
}

inline std::vector<hs_bolt> bolts_of(const hs_world* world) {
  std::int64_t count = 0;
  (void)hs_world_get_bolts(world, nullptr, 0, &count);
  std::vector<hs_bolt> bolts(static_cast<std::size_t>(count));
  if (hs_world_get_bolts(world, bolts.data(), count, nullptr) != HS_OK) throw std::runtime_error("no bolts");
  return bolts;
}

/// The factor of safety, to this resolution. Blocks that slide leave the water table and stretch bolts, so a
/// small displacement is failure.
inline double factor_of_safety(hs_context* context, const hs_world* world, double resolution) {
  hs_strength_def def;
  require_ok(hs_strength_def_init(&def, sizeof def), context);
  def.resolution = resolution;
  def.low = 0.2;
  def.max_displacement = 1e-3;
  hs_strength_report report{};
  require_ok(hs_world_find_strength_factor(world, &def, &report, sizeof report, nullptr), context);
  if (!report.stands_at_low || !report.falls_at_high) throw std::runtime_error("no factor in the bracket");
  return report.factor;
}

}  // namespace halfspace_test
