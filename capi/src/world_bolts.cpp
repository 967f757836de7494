#include "halfspace/bolt.h"
#include "sized_struct.h"
#include "strided_view.h"
#include "world_handle.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace halfspace::capi {

template <>
hs_bolt_def default_definition() {
  hs_bolt_def def{};
  def.is_tension_only = 1;
  def.stiffness = 1e8;
  return def;
}

namespace {

/// The block of an end; -1 for the ground.
template <int D>
std::int32_t read_end(const Blocks<D>& blocks, hs_block block, const char* name) {
  return block == 0 ? -1 : slot_of(blocks, block, name);
}

template <int D>
bool moves(const Blocks<D>& blocks, std::int32_t slot) {
  return slot >= 0 && blocks.moves(std::size_t(slot));
}

template <int D>
void require_ends(const Blocks<D>& blocks, const Bolt<D>& bolt, const hs_bolt_def& def) {
  const auto name = [](hs_block block) { return static_cast<unsigned long long>(block); };
  if (bolt.a >= 0 && bolt.a == bolt.b)
    refuse(HS_ERROR_ARGUMENT, "def.block_a and def.block_b are both %#llx", name(def.block_a));
  if (!moves(blocks, bolt.a) && !moves(blocks, bolt.b)) {
    refuse(HS_ERROR_STATE, "neither def.block_a %#llx nor def.block_b %#llx moves", name(def.block_a),
           name(def.block_b));
  }
}

template <int D>
void read_forces(const hs_bolt_def& def, Bolt<D>& bolt) {
  bolt.is_tension_only = def.is_tension_only;
  if (def.is_tension_only != 0 && def.is_tension_only != 1)
    refuse(HS_ERROR_ARGUMENT, "def.is_tension_only is %d; it must be 0 or 1", def.is_tension_only);
  bolt.stiffness = require_above_zero(def.stiffness, "def.stiffness");
  bolt.yield_force = require_from_zero(def.yield_force, "def.yield_force");
  bolt.rupture_elongation = require_from_zero(def.rupture_elongation, "def.rupture_elongation");
  require(is_within_limits(def.pretension), def.pretension, "def.pretension", "finite and at most 1e75");
  if (def.is_tension_only)
    require(def.pretension >= 0, def.pretension, "def.pretension",
            "at least 0 for a bolt under tension only");
  if (def.yield_force > 0) {
    require(std::abs(def.pretension) <= def.yield_force, def.pretension, "def.pretension",
            "at most def.yield_force");
  }
  if (def.rupture_elongation > 0) {
    require(def.rupture_elongation > def.pretension / def.stiffness, def.rupture_elongation,
            "def.rupture_elongation", "above def.pretension / def.stiffness");
  }
}

/// Refuses stiffnesses that could overflow for a block that moves freely.
template <int D>
void require_borne(const Blocks<D>& blocks, std::int32_t slot, const Vector<D>& place, double stiffness) {
  constexpr double largest = 1e300;
  if (slot < 0 || !blocks.moves_freely(std::size_t(slot))) return;
  const std::size_t i = std::size_t(slot);
  const double ratio = std::max((place - blocks.position[i]).norm() / blocks.radius[i], 1.0);
  const double mobility = (1 / blocks.mass[i] + blocks.strain_mobility(i)) * ratio;
  if (stiffness * mobility * ratio <= largest) return;
  refuse(HS_ERROR_ARGUMENT, "def.stiffness is %g: too large for block %#llx of mass %g; decrease it",
         stiffness, static_cast<unsigned long long>(id_of(blocks, i)), blocks.mass[i]);
}

template <int D>
hs_bolt bolt_of(const Blocks<D>& blocks, const Bolt<D>& bolt) {
  const auto block = [&](std::int32_t slot) { return slot < 0 ? 0 : id_of(blocks, std::size_t(slot)); };
  const BoltEnds<D> ends(blocks, bolt);
  hs_bolt out{};
  out.number = bolt.number;
  out.block_a = block(bolt.a);
  out.block_b = block(bolt.b);
  write_vector(ends.a, out.place_a);
  write_vector(ends.b, out.place_b);
  out.tension = bolt.tension;
  out.elongation = bolt.elongation;
  out.plastic_elongation = bolt.plastic_elongation;
  out.strain_energy = bolt.strain_energy();
  out.loss = bolt.dissipated;
  out.is_ruptured = bolt.is_ruptured;
  return out;
}

}  // namespace
}  // namespace halfspace::capi

hs_status hs_bolt_def_init(hs_bolt_def* def, size_t size) { return write_definition(def, size); }

hs_status hs_world_add_bolt(hs_world* world, const hs_bolt_def* given, int64_t* number) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_joined(w);
    const hs_bolt_def def = read_definition(given, "def");
    Bolt<D> bolt;
    read_forces(def, bolt);
    bolt.a = read_end(w.blocks(), def.block_a, "def.block_a");
    bolt.b = read_end(w.blocks(), def.block_b, "def.block_b");
    require_ends(w.blocks(), bolt, def);
    const Vector<D> a = read_finite_vector<D>(def.place_a, "def.place_a"),
                    b = read_finite_vector<D>(def.place_b, "def.place_b");
    if (a == b) {
      refuse(HS_ERROR_ARGUMENT, "def.place_a and def.place_b are both %s; a bolt has a length",
             PointText(a).characters);
    }
    require_borne(w.blocks(), bolt.a, a, def.stiffness);
    require_borne(w.blocks(), bolt.b, b, def.stiffness);
    const std::int64_t added = w.add_bolt(bolt, a, b, def.pretension);
    if (number) *number = added;
    return HS_OK;
  });
}

hs_status hs_world_remove_bolt(hs_world* world, int64_t number) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    const std::optional<std::size_t> index = w.model().bolts.index_of(number);
    if (!index) {
      refuse(HS_ERROR_STALE_ID, "number is %lld; the world has no such bolt", static_cast<long long>(number));
    }
    w.remove_bolt(*index);
    return HS_OK;
  });
}

hs_status hs_world_get_block_at(const hs_world* world, const double place[3], hs_block* block) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    const Vector<D> at = read_finite_vector<D>(place, "place");
    require_pointer(block, "block");
    const std::int32_t slot = w.blocks().containing(at);
    *block = slot < 0 ? 0 : id_of(w.blocks(), std::size_t(slot));
    return HS_OK;
  });
}

hs_status hs_world_get_bolts(const hs_world* world, hs_bolt bolts[], int64_t capacity, int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(bolts, "bolts");
    const Array<Bolt<D>>& all = w.model().bolts.all();
    if (count) *count = std::int64_t(all.size());
    return write_all(std::int64_t(all.size()), capacity,
                     [&](int i) { bolts[i] = bolt_of(w.blocks(), all[std::size_t(i)]); });
  });
}
