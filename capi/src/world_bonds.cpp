#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/angle.h"
#include "halfspace/bond.h"
#include "sized_struct.h"
#include "world_handle.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace halfspace::capi {

template <>
hs_bond_def default_definition() {
  hs_bond_def def{};
  def.normal_stiffness = 1e11;
  def.residual_friction_angle = -1;
  return def;
}

namespace {

double read_tangent(double angle, const char* name) {
  return tangent_of(
      require(angle >= 0 && angle < std::numbers::pi / 2, angle, name, "at least 0 and below pi/2"));
}

BondLaw read_bond(const hs_bond_def* given) {
  const hs_bond_def def = read_definition(given, "def");
  if (def.reserved != 0) refuse(HS_ERROR_ARGUMENT, "def.reserved is %d; it must be 0", def.reserved);
  BondLaw law;
  law.normal_stiffness = require_above_zero(def.normal_stiffness, "def.normal_stiffness");
  law.shear_stiffness = require_from_zero(def.shear_stiffness, "def.shear_stiffness");
  if (law.shear_stiffness == 0) law.shear_stiffness = law.normal_stiffness;
  law.tensile_strength = require_from_zero(def.tensile_strength, "def.tensile_strength");
  law.cohesion = require_from_zero(def.cohesion, "def.cohesion");
  law.tan_friction = read_tangent(def.friction_angle, "def.friction_angle");
  law.residual_cohesion = require(def.residual_cohesion >= 0 && def.residual_cohesion <= law.cohesion,
                                  def.residual_cohesion, "def.residual_cohesion", "from 0 to def.cohesion");
  law.residual_tan_friction = def.residual_friction_angle < 0
                                  ? law.tan_friction
                                  : read_tangent(def.residual_friction_angle, "def.residual_friction_angle");
  law.tensile_fracture_energy = require_from_zero(def.tensile_fracture_energy, "def.tensile_fracture_energy");
  law.shear_fracture_energy = require_from_zero(def.shear_fracture_energy, "def.shear_fracture_energy");
  return law;
}

template <int D>
hs_bond bond_of(const World<D>& world, const Bond<D>& bond) {
  hs_bond out{};
  if (bond.a >= 0) {
    out.block_a = id_of(world.blocks(), std::size_t(bond.a));
    out.block_b = id_of(world.blocks(), std::size_t(bond.b));
  }
  out.is_joint = bond.is_joint;
  out.point_count = std::int32_t(bond.point_count);
  Vector<D> shear = Vector<D>::Zero();
  for (const BondPoint<D>& point : world.blocks().bonds().points_of(bond)) {
    out.broken_count += point.is_broken();
    out.area += point.area;
    out.damage += point.area * point.damage;
    if (!bond.is_joint) continue;
    out.normal_force += point.area * point.normal_traction;
    shear += point.area * point.shear;
  }
  out.damage /= out.area;
  write_vector(shear, out.shear_force);
  return out;
}

template <int D>
hs_bond_event event_of(const BondEvent<D>& event) {
  hs_bond_event out{};
  out.bond = event.bond;
  out.step = event.step;
  out.failure = std::int32_t(event.failure);
  out.point = std::int32_t(event.point);
  out.time = event.time;
  write_vector(event.position, out.position);
  write_vector(event.normal, out.normal);
  out.area = event.area;
  out.normal_traction = event.normal_traction;
  out.shear_traction = event.shear_traction;
  out.energy = event.energy;
  return out;
}

/// Refuses stiffnesses that could overflow for a block that moves freely. Its largest face bounds the area of
/// any common face.
template <int D>
void require_borne(const Blocks<D>& blocks, std::size_t slot, const BondLaw& law) {
  constexpr double largest = 1e300;  // so that sums over bonds stay finite
  if (!blocks.moves_freely(slot)) return;
  const double stiffness = std::max(law.normal_stiffness, law.shear_stiffness) * blocks.largest_face[slot];
  const std::size_t mover = blocks.mover_of(slot);
  if (stiffness * (1 / blocks.mass[mover] + blocks.strain_mobility(mover)) <= largest) return;
  refuse(
      HS_ERROR_ARGUMENT,
      "def.normal_stiffness is %g, def.shear_stiffness is %g: too large for block %#llx of mass %g; decrease "
      "them",
      law.normal_stiffness, law.shear_stiffness, static_cast<unsigned long long>(id_of(blocks, slot)),
      blocks.mass[mover]);
}

}  // namespace
}  // namespace halfspace::capi

hs_status hs_bond_def_init(hs_bond_def* def, size_t size) { return write_definition(def, size); }

hs_status hs_world_bond_blocks(hs_world* world, hs_block block_a, hs_block block_b, const hs_bond_def* def) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_joined(w);
    const std::int32_t a = slot_of(w.blocks(), block_a, "block_a"),
                       b = slot_of(w.blocks(), block_b, "block_b");
    const BondLaw law = read_bond(def);
    const auto name = [](hs_block block) { return static_cast<unsigned long long>(block); };
    if (a == b) refuse(HS_ERROR_ARGUMENT, "block_a and block_b are both %#llx", name(block_a));
    if (!w.blocks().moves_freely(std::size_t(a)) && !w.blocks().moves_freely(std::size_t(b)))
      refuse(HS_ERROR_STATE, "neither block_a %#llx nor block_b %#llx moves", name(block_a), name(block_b));
    require_borne(w.blocks(), std::size_t(a), law);
    require_borne(w.blocks(), std::size_t(b), law);
    if (!w.bond_pair(a, b, law)) {
      refuse(HS_ERROR_STATE, "block_a %#llx and block_b %#llx have no common face or are bonded already",
             name(block_a), name(block_b));
    }
    return HS_OK;
  });
}

hs_status hs_world_bond_materials(hs_world* world, int32_t material_a, int32_t material_b,
                                  const hs_bond_def* def, int64_t* count) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_joined(w);
    require_material(w, material_a, "material_a");
    require_material(w, material_b, "material_b");
    const BondLaw law = read_bond(def);
    for_each_block(w.blocks(), [&](std::int64_t, std::int32_t slot) {
      const std::int32_t material = w.blocks().material[std::size_t(slot)];
      if (material == material_a || material == material_b) require_borne(w.blocks(), std::size_t(slot), law);
    });
    const std::int64_t made = w.bond_materials(material_a, material_b, law);
    if (count) *count = made;
    return HS_OK;
  });
}

hs_status hs_world_hold_bonds(hs_world* world, int32_t are_held) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    if (are_held != 0 && are_held != 1)
      refuse(HS_ERROR_ARGUMENT, "are_held is %d; it must be 0 or 1", are_held);
    w.hold_bonds(are_held == 1);
    return HS_OK;
  });
}

hs_status hs_world_get_bonds(const hs_world* world, hs_bond bonds[], int64_t capacity, int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(bonds, "bonds");
    const Array<Bond<D>>& all = w.blocks().bonds().all();
    if (count) *count = std::int64_t(all.size());
    for (std::size_t i = 0; i < all.size() && std::int64_t(i) < capacity; ++i) bonds[i] = bond_of(w, all[i]);
    return fits(std::int64_t(all.size()), capacity);
  });
}

hs_status hs_world_get_bond_events(const hs_world* world, int64_t first, hs_bond_event events[],
                                   int64_t capacity, int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_count(first, "first");
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(events, "events");
    const Array<BondEvent<D>>& all = w.blocks().bonds().events();
    const std::int64_t left = std::max(std::int64_t(all.size()) - first, std::int64_t(0));
    if (count) *count = left;
    for (std::int64_t i = 0; i < left && i < capacity; ++i) events[i] = event_of(all[std::size_t(first + i)]);
    return fits(left, capacity);
  });
}

hs_status hs_world_get_bond_report(const hs_world* world, hs_bond_report* report, size_t size) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_pointer(report, "report");
    require_report_size(size, sizeof(hs_bond_report));
    hs_bond_report ours{};
    ours.bond_count = std::int64_t(w.blocks().bonds().all().size());
    for (const Bond<D>& bond : w.blocks().bonds().all()) ours.joint_count += bond.is_joint;
    ours.event_count = std::int64_t(w.blocks().bonds().events().size());
    for (const BondEvent<D>& event : w.blocks().bonds().events()) ours.crack_area += event.area;
    ours.strain_energy = w.state().bond_strain;
    ours.fracture_loss = w.state().ledger.entries().fracture_loss;
    write_sized(ours, report, size);
    return HS_OK;
  });
}
