#include "halfspace/water.h"
#include "sized_struct.h"
#include "strided_view.h"
#include "world_handle.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace halfspace::capi {

template <>
hs_water_def default_definition() {
  hs_water_def def{};
  def.density = 1000;
  def.factor = 1;
  return def;
}

namespace {

/// Refuses corners that are not those of a table.
void require_table(const Array<Vector<2>>& corners, std::int32_t columns) {
  if (columns != 0) refuse(HS_ERROR_ARGUMENT, "def.columns is %d; it must be 0 in 2D", columns);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (corners[i].x() < corners[i - 1].x()) {
      refuse(HS_ERROR_ARGUMENT, "table[%zu] is %s; its x must be at least that of the corner before, %.17g",
             i, PointText(corners[i]).characters, corners[i - 1].x());
    }
  }
}
void require_table(const Array<Vector<3>>& corners, std::int32_t columns) {
  if (columns == 0) {
    if (corners.size() == 2 || corners.size() > 3) {
      refuse(HS_ERROR_ARGUMENT, "table.count is %zu; it must be 0, 1 or 3 without def.columns",
             corners.size());
    }
    return;
  }
  if (columns < 2) refuse(HS_ERROR_ARGUMENT, "def.columns is %d; it must be 0 or at least 2", columns);
  const std::size_t per_row = std::size_t(columns);
  if (corners.size() < 2 * per_row || corners.size() % per_row != 0) {
    refuse(HS_ERROR_ARGUMENT, "table.count is %zu; it must be at least 2 rows of def.columns, %d",
           corners.size(), columns);
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t column = i % per_row, row = i / per_row;
    const bool is_right = column == 0 || corners[i].x() > corners[i - 1].x();
    const bool is_behind = row == 0 || corners[i].y() > corners[i - per_row].y();
    if (is_right && is_behind && corners[i].x() == corners[column].x() &&
        corners[i].y() == corners[row * per_row].y())
      continue;
    refuse(
        HS_ERROR_ARGUMENT,
        "table[%zu] is %s; x must ascend in each row and be the same in each column, y must ascend from row "
        "to row and be the same in each row",
        i, PointText(corners[i]).characters);
  }
}

}  // namespace
}  // namespace halfspace::capi

hs_status hs_water_def_init(hs_water_def* def, size_t size) { return write_definition(def, size); }

hs_status hs_world_set_water(hs_world* world, const hs_water_def* given, hs_view table) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    const hs_water_def def = read_definition(given, "def");
    require_from_zero(def.density, "def.density");
    require_from_zero(def.factor, "def.factor");
    const double density = def.density * def.factor;
    require(is_within_limits(density), density, "def.density times def.factor", "at most 1e75");
    WaterTable<D> known(&world->context->memory);
    Array<Vector<D>> corners = read_finite_points<D>(world->context, table, "table");
    require_table(corners, def.columns);
    known.set(std::move(corners), def.columns);
    if (!known.is_table())
      refuse(HS_ERROR_ARGUMENT, "table is steeper than %g; make it level or less steep", max_water_slope);
    w.set_water(std::move(known), density);
    return HS_OK;
  });
}

hs_status hs_world_get_water_loads(const hs_world* world, hs_mutable_view forces, hs_mutable_view torques) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_view<D>(forces, "forces");
    require_angular_view<D>(torques, "torques");
    const Blocks<D>& blocks = w.blocks();
    Memory* memory = &world->context->memory;
    Array<Vector<D>> force(blocks.slot_count(), Vector<D>::Zero(), memory);
    Array<Angular<D>> torque(blocks.slot_count(), Angular<D>::Zero(), memory);
    for_each_block(blocks, [&](std::int64_t, std::int32_t slot) {
      const std::size_t i = std::size_t(slot);
      if (w.model().water.empty() || !blocks.moves(i)) return;
      const WaterLoad<D> load = w.model().water_load_on(i);
      force[i] = load.force;
      torque[i] = moment(load.virial);
    });
    return write_blocks(blocks, force, forces, torque, torques);
  });
}
