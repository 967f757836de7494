#include <cstddef>

#include "halfspace/strength.h"
#include "refuse_step.h"
#include "sized_struct.h"
#include "world/relaxation/relax.h"
#include "world/relaxation/strength.h"
#include "world_bytes.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace halfspace::capi {

template <>
hs_strength_def default_definition() {
  const StrengthSearch defaults;
  hs_strength_def def{};
  def.low = defaults.low;
  def.high = defaults.high;
  def.resolution = defaults.resolution;
  def.ratio = 1e-5;
  def.max_displacement = 0.1;
  def.max_steps = 100000;
  return def;
}

namespace {

double require_factor(double value, const char* name) {
  return require(is_strength_factor(value), value, name, "from 1e-75 to 1e75");
}

struct Search {
  StrengthSearch bracket;
  Relaxation relaxation;
};

Search read_search(const hs_strength_def* given) {
  const hs_strength_def def = read_definition(given, "def");
  if (def.reserved != 0) refuse(HS_ERROR_ARGUMENT, "def.reserved is %d; it must be 0", def.reserved);
  Search search;
  search.bracket.low = require_factor(def.low, "def.low");
  search.bracket.high = require(def.high > def.low && is_within_limits(def.high), def.high, "def.high",
                                "above def.low and at most 1e75");
  search.bracket.resolution = require_above_zero(def.resolution, "def.resolution");
  search.relaxation.ratio = require_above_zero(def.ratio, "def.ratio");
  search.relaxation.max_displacement = require_above_zero(def.max_displacement, "def.max_displacement");
  if (def.max_steps < 1) {
    refuse(HS_ERROR_ARGUMENT, "def.max_steps is %lld; it must be at least 1",
           static_cast<long long>(def.max_steps));
  }
  search.relaxation.max_steps = def.max_steps;
  search.relaxation.holds_bonds = false;
  return search;
}

/// Relaxes copies of a world with reduced strength, one after the other. Keeps the last one that failed.
template <int D>
class Trials {
 public:
  Trials(hs_context* context, const World<D>& world, const Relaxation& relaxation)
      : context_(context),
        relaxation_(relaxation),
        state_(snapshot::state_size(world.state()), &context->memory) {
    snapshot::write_state(world.state(), state_.data());
  }
  Trials(const Trials&) = delete;
  Trials& operator=(const Trials&) = delete;
  ~Trials() { end(fallen_); }

  bool stands_at(double factor) {
    WorldHandle<D>* copy = restore<D>(context_, state_);
    try {
      copy->world.set_strength_factor(factor);
      copy->world.hold_bonds(false);
      const Relaxed relaxed = relax(copy->world, relaxation_);
      if (relaxed.result == StepResult::no_time_step) require_stepped(copy->world, relaxed.result);
      if (!relaxed.is_at_rest) std::swap(copy, fallen_);
      end(copy);
      return relaxed.is_at_rest;
    } catch (...) {
      end(copy);
      throw;
    }
  }

  hs_world* release() { return std::exchange(fallen_, nullptr); }

 private:
  void end(WorldHandle<D>* world) {
    if (world) destroy(context_, world);
  }

  hs_context* context_;
  Relaxation relaxation_;
  Array<std::byte> state_;
  WorldHandle<D>* fallen_ = nullptr;
};

}  // namespace
}  // namespace halfspace::capi

hs_status hs_strength_def_init(hs_strength_def* def, size_t size) { return write_definition(def, size); }

hs_status hs_world_set_strength_factor(hs_world* world, double factor) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    w.set_strength_factor(require_factor(factor, "factor"));
    return HS_OK;
  });
}

hs_status hs_world_find_strength_factor(const hs_world* world, const hs_strength_def* def,
                                        hs_strength_report* report, size_t size, hs_world** fallen) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_joined(w);
    const Search search = read_search(def);
    require_pointer(report, "report");
    require_report_size(size, sizeof(hs_strength_report));
    Trials<D> trials(world->context, w, search.relaxation);
    const StrengthFound found =
        find_strength_factor(search.bracket, [&](double factor) { return trials.stands_at(factor); });
    const hs_strength_report ours = {0.5 * (found.low + found.high),
                                     found.low,
                                     found.high,
                                     found.stands_at_low,
                                     found.falls_at_high,
                                     found.trials,
                                     0};
    write_sized(ours, report, size);
    if (fallen) *fallen = trials.release();
    return HS_OK;
  });
}
