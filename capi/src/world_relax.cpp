#include <cstddef>

#include "halfspace/relax.h"
#include "prepared_world.h"
#include "refuse_step.h"
#include "sized_struct.h"
#include "world/relaxation/relax.h"
#include "world_handle.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace halfspace::capi {

template <>
hs_relaxation_def default_definition() {
  const Relaxation defaults;
  hs_relaxation_def def{};
  def.measure = HS_UNBALANCED_MEAN;
  def.ratio = defaults.ratio;
  def.max_steps = defaults.max_steps;
  def.local_damping = defaults.local_damping;
  def.is_adaptive = defaults.is_adaptive;
  def.hold_bonds = defaults.holds_bonds;
  return def;
}

namespace {

Relaxation read_relaxation(const hs_relaxation_def* given) {
  const hs_relaxation_def def = read_definition(given, "def");
  if (def.measure != HS_UNBALANCED_MEAN && def.measure != HS_UNBALANCED_LARGEST)
    refuse(HS_ERROR_ARGUMENT, "def.measure is %d; it must be an HS_UNBALANCED_ value", def.measure);
  if (def.max_steps < 1) {
    refuse(HS_ERROR_ARGUMENT, "def.max_steps is %lld; it must be at least 1",
           static_cast<long long>(def.max_steps));
  }
  if (def.is_adaptive != 0 && def.is_adaptive != 1)
    refuse(HS_ERROR_ARGUMENT, "def.is_adaptive is %d; it must be 0 or 1", def.is_adaptive);
  if (def.hold_bonds != 0 && def.hold_bonds != 1)
    refuse(HS_ERROR_ARGUMENT, "def.hold_bonds is %d; it must be 0 or 1", def.hold_bonds);
  Relaxation relaxation;
  relaxation.by_largest = def.measure == HS_UNBALANCED_LARGEST;
  relaxation.ratio = require_above_zero(def.ratio, "def.ratio");
  relaxation.max_steps = def.max_steps;
  relaxation.local_damping = require(def.local_damping >= 0 && def.local_damping < 1, def.local_damping,
                                     "def.local_damping", "at least 0 and below 1");
  relaxation.is_adaptive = def.is_adaptive == 1;
  relaxation.holds_bonds = def.hold_bonds == 1;
  return relaxation;
}

template <int D>
void write_balance(const World<D>& world, const Balance& balance, std::int64_t steps, hs_balance* out,
                   std::size_t size) {
  const hs_block block = balance.block < 0 ? 0 : id_of(world.blocks(), std::size_t(balance.block));
  const hs_balance ours = {balance.mean, balance.largest, balance.largest_force, steps, block};
  write_sized(ours, out, size);
}

}  // namespace
}  // namespace halfspace::capi

hs_status hs_relaxation_def_init(hs_relaxation_def* def, size_t size) { return write_definition(def, size); }

hs_status hs_world_relax(hs_world* world, const hs_relaxation_def* def, hs_balance* balance, size_t size) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_joined(w);
    const Relaxation relaxation = read_relaxation(def);
    if (balance) require_report_size(size, sizeof(hs_balance));
    const Relaxed relaxed = relax(w, relaxation);
    require_stepped(w, relaxed.result);
    if (balance) write_balance(w, relaxed.balance, relaxed.steps, balance, size);
    return relaxed.is_at_rest ? HS_OK : HS_NOTE_NOT_AT_REST;
  });
}

hs_status hs_world_get_balance(hs_world* world, hs_balance* balance, size_t size) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_joined(w);
    require_pointer(balance, "balance");
    require_report_size(size, sizeof(hs_balance));
    query_prepared(*world, w, [&](World<D>& prepared) {
      write_balance(prepared, balance_of(prepared), 0, balance, size);
    });
    return HS_OK;
  });
}

hs_status hs_world_set_gravity(hs_world* world, const double gravity[3]) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    w.set_gravity(read_finite_vector<D>(gravity, "gravity"));
    return HS_OK;
  });
}

hs_status hs_world_set_damping(hs_world* world, double local_damping, double mass_damping) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    require(local_damping >= 0 && local_damping < 1, local_damping, "local_damping",
            "at least 0 and below 1");
    require_from_zero(mass_damping, "mass_damping");
    w.set_damping(local_damping, mass_damping);
    return HS_OK;
  });
}

hs_status hs_world_set_time_step(hs_world* world, double time_step) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    w.set_time_step(require_from_zero(time_step, "time_step"));
    return HS_OK;
  });
}
