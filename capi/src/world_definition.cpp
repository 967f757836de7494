#include <cstddef>

#include "halfspace/definition.h"
#include "law_numbers.h"
#include "sized_struct.h"
#include "strided_view.h"
#include "world_handle.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace halfspace::capi {
namespace {

template <int D>
hs_world_def as_given(const WorldSettings<D>& settings) {
  hs_world_def def{};
  def.dimension = D;
  write_vector(settings.gravity, def.gravity);
  def.time_step = settings.time_step;
  def.safety = settings.safety;
  def.local_damping = settings.local_damping;
  def.mass_damping = settings.mass_damping;
  def.skin = settings.skin;
  def.parallel_angle = settings.detect.parallel_angle;
  def.vertex_zone = settings.detect.vertex_zone;
  def.potential_length = settings.potential_length;
  def.fast_blocks = std::int32_t(settings.fast_blocks);
  def.sleep_tolerance = settings.sleep_tolerance;
  def.impulse_tolerance = settings.impulse_tolerance;
  def.max_impulse_iterations = settings.max_impulse_iterations;
  def.locate_impacts = settings.locate_impacts;
  return def;
}

hs_law_def as_given(const ContactLaw& law) {
  hs_law_def def{};
  def.stiffness_kind = std::int32_t(law.stiffness_kind);
  write_numbers(law.given, def);
  return def;
}

hs_elasticity_def as_given(const Elasticity& elasticity) {
  hs_elasticity_def def{};
  def.plane = elasticity.is_plane_stress ? HS_PLANE_STRESS : HS_PLANE_STRAIN;
  def.young_modulus = elasticity.young_modulus;
  def.poisson_ratio = elasticity.poisson_ratio;
  def.damping_time = elasticity.damping_time;
  return def;
}

/// The point that moves with a block is where it is now.
template <int D>
hs_action_def as_given(const Action<D>& action, const Blocks<D>& blocks) {
  hs_action_def def{};
  def.kind = std::int32_t(action.kind);
  def.table = action.table;
  def.place = std::int32_t(action.place);
  def.start = action.start;
  def.max_speed = action.max_speed;
  write_vector(action.scale, def.scale);
  Vector<D> point = action.point.template head<D>();
  if (action.place == ForcePlace::carried) {
    const std::size_t slot = std::size_t(action.slot);
    point = blocks.position[slot] + blocks.arm_to(slot, point);
  }
  write_vector(point, def.point);
  return def;
}

/// Writes a definition that can be passed on: it says the size of the caller's struct.
template <class Definition>
hs_status write_given(Definition given, Definition* out, std::size_t size, const char* name) {
  require_pointer(out, name);
  require_report_size(size, min_definition);
  given.struct_size = std::uint32_t(size);
  write_sized(given, out, size);
  return HS_OK;
}

}  // namespace
}  // namespace halfspace::capi

hs_status hs_world_get_def(const hs_world* world, hs_world_def* def, size_t size) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    return write_given(as_given(w.model().settings), def, size, "def");
  });
}

hs_status hs_world_get_densities(const hs_world* world, double densities[], int64_t capacity,
                                 int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(densities, "densities");
    if (count) *count = w.model().materials.count();
    return write_all(w.model().materials.count(), capacity,
                     [&](int i) { densities[i] = w.model().materials.density(i); });
  });
}

hs_status hs_world_get_elasticity(const hs_world* world, int32_t material, hs_elasticity_def* elasticity,
                                  size_t size) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_material(w, material, "material");
    return write_given(as_given(w.model().materials.elasticity(material)), elasticity, size, "elasticity");
  });
}

hs_status hs_world_get_default_law(const hs_world* world, hs_law_def* law, size_t size) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    return write_given(as_given(w.model().materials.laws().default_law()), law, size, "law");
  });
}

hs_status hs_world_get_law(const hs_world* world, int32_t material_a, int32_t material_b, hs_law_def* law,
                           size_t size) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_material(w, material_a, "material_a");
    require_material(w, material_b, "material_b");
    return write_given(as_given(w.model().materials.laws().between(material_a, material_b)), law, size,
                       "law");
  });
}

hs_status hs_world_get_table(const hs_world* world, int32_t table, double times[], hs_mutable_view values,
                             int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    if (table < 0 || table >= w.model().actions.tables().count())
      refuse(HS_ERROR_STALE_ID, "table is %d; the world has %d tables", table,
             w.model().actions.tables().count());
    require_view(values, "values");
    if (values.count > 0) require_pointer(times, "times");
    const Table rows = w.model().actions.tables()[table];
    const std::int64_t row_count = std::int64_t(rows.times().size());
    if (count) *count = row_count;
    return write_all(row_count, values.count, [&](int i) {
      times[i] = rows.times()[std::size_t(i)];
      write_point(values, i, rows.values()[std::size_t(i)]);
    });
  });
}

hs_status hs_world_get_actions(const hs_world* world, hs_block block, hs_action_def actions[], size_t size,
                               int64_t capacity, int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    const std::int32_t slot = block == 0 ? -1 : slot_of(w.blocks(), block, "block");
    require_report_size(size, min_definition);
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(actions, "actions");
    std::int64_t found = 0;
    for (const Action<D>& action : w.model().actions.on_blocks()) {
      if (action.slot != slot) continue;
      if (found < capacity) {
        std::byte* const room = reinterpret_cast<std::byte*>(actions) + std::size_t(found) * size;
        write_given(as_given(action, w.blocks()), reinterpret_cast<hs_action_def*>(room), size, "actions");
      }
      ++found;
    }
    if (count) *count = found;
    return fits(found, capacity);
  });
}
