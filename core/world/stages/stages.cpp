#include "world/stages/stages.h"

#include <algorithm>
#include <iterator>

namespace halfspace {
namespace {

/// Maximum number of iterations for the impulses of a divided step, over those that one solve may take.
constexpr std::int64_t max_divided_solves = 1 << 10;

template <int D>
bool always(const State<D>&) {
  return true;
}
template <int D>
bool has_actions(const State<D>& state) {
  return !state.model.actions.empty();
}
template <int D>
bool may_meet_sleepers(const State<D>& state) {
  return state.hard_contacts.is_used() && state.sleep.any();
}
template <int D>
bool has_laws_without_spring(const State<D>& state) {
  return state.hard_contacts.is_used();
}
template <int D>
bool has_water(const State<D>& state) {
  return !state.model.water.empty();
}
template <int D>
bool has_bolts(const State<D>& state) {
  return !state.model.bolts.empty();
}
template <int D>
bool has_bonds(const State<D>& state) {
  return !state.model.blocks.bonds().empty();
}
template <int D>
bool has_compounds(const State<D>& state) {
  return !state.model.blocks.compounds().parts().empty();
}

}  // namespace

template <int D>
const typename Stages<D>::Stage& Stages<D>::stage_of(StageName name) {
  static constexpr Stage all[] = {
      {StageName::actions, Pass::motion, has_actions, &Stages::predict_actions},
      {StageName::predict, Pass::motion, always, &Stages::predict},
      {StageName::search, Pass::search, always, &Stages::search},
      {StageName::wake, Pass::hard_contacts, may_meet_sleepers, &Stages::wake_met},
      {StageName::impulses, Pass::hard_contacts, has_laws_without_spring, &Stages::predict_impulses},
      {StageName::divide, Pass::motion, always, &Stages::divide},
      {StageName::drift, Pass::motion, always, &Stages::drift},
      {StageName::contacts, Pass::pairs, always, &Stages::load_contacts},
      {StageName::gather, Pass::gather, always, &Stages::gather},
      {StageName::water, Pass::water, has_water, &Stages::load_by_water},
      {StageName::bolts, Pass::bolts, has_bolts, &Stages::load_by_bolts},
      {StageName::bonds, Pass::bonds, has_bonds, &Stages::load_by_bonds},
      {StageName::compounds, Pass::gather, has_compounds, &Stages::load_compounds},
      {StageName::loads, Pass::motion, has_actions, &Stages::place_loads},
      {StageName::impacts, Pass::hard_contacts, has_laws_without_spring, &Stages::find_impacts},
      {StageName::kick, Pass::motion, always, &Stages::kick},
      {StageName::rebounds, Pass::hard_contacts, has_laws_without_spring, &Stages::stop_approach},
      {StageName::book, Pass::book, always, &Stages::book},
  };
  constexpr auto follows = [](const Stage& s, const Stage& t) { return t.name <= s.name; };
  static_assert(std::size(all) == std::size_t(StageName::end) &&
                std::adjacent_find(std::begin(all), std::end(all), follows) == std::end(all));
  return all[std::size_t(name)];
}

template <int D>
Stages<D>::Stages(State<D>& state)
    : state_(state),
      contacts_(state),
      bonds_(state.model),
      water_(state.model, state.forces, state.share, state.threads, state.memory()) {}

template <int D>
StepResult Stages<D>::run(StageName from, StageName to, Motion& motion) {
  for (StageName next = from; next != to;) {
    const Stage& stage = stage_of(next);
    next = StageName(std::size_t(next) + 1);
    if (!stage.is_used(state_)) continue;
    const Outcome outcome = (this->*stage.run)(motion);
    if (stopwatch_) stopwatch_->lap(stage.pass);
    if (outcome == Outcome::refused) break;
    if (outcome == Outcome::shortened) next = StageName::actions;
    if (outcome == Outcome::relisted) next = StageName::predict;
  }
  return motion.result;
}

template <int D>
std::int64_t Stages<D>::max_divided_iterations() const {
  return max_divided_solves * state_.model.settings.max_impulse_iterations;
}

template <int D>
bool Stages<D>::is_overworked() const {
  return motions_ >= max_motions ||
         state_.hard_contacts.iterations() - first_iteration_ > max_divided_iterations();
}

template <int D>
void Stages<D>::end_reading() {
  Model<D>& model = state_.model;
  model.actions.renew(model.blocks);
  model.viscous_nodes.renew(model.blocks.meshes());
  state_.integrator.reserve(model.blocks.slot_count());
  state_.share.find_rings(state_.contacts.neighbors().pairs());
  fit_rooms();
}

template <int D>
void Stages<D>::fit_rooms() {
  state_.continuous_collision.fit_room();
  state_.forces.fit_rooms();
  state_.hard_contacts.fit_room();
  water_.fit_room();  // a table may come while the list stays
  contacts_.fit_room();
}

/// Reserves memory for a contact of every pair, so that detection allocates nothing. Impulses move blocks
/// farther than the motion without them: skins have a reserve, and grow until they cover both.
template <int D>
void Stages<D>::renew_neighbors(int renewals) {
  Model<D>& model = state_.model;
  NeighborList<D>& neighbors = state_.contacts.neighbors();
  Bonds<D>& bonds = model.blocks.bonds();
  if (!bonds.rings().is_current()) bonds.rings().find(model.blocks);
  const bool with_shear =
      model.materials.laws().any([](const ContactLaw& law) { return law.resists_shear(); });
  const SkinRule skins{model.settings.skin, has_laws_without_spring(state_) ? 4.0 : 1.0, renewals == 0,
                       state_.share.common().typical_radius};
  neighbors.search_again(model.blocks, skins, with_shear);
  state_.contacts.fit_room();
  fit_rooms();
  neighbors.renew(model.blocks, with_shear);
  state_.share.find_rings(neighbors.pairs());
  if (has_bonds(state_)) bonds_.hand_over(state_.contacts);
  state_.forget_contacts();
}

/// Detection requires a valid neighbour list.
template <int D>
void Stages<D>::renew_neighbors_if_needed() {
  if (!state_.contacts.are_found() && state_.contacts.neighbors().needs_rebuild()) renew_neighbors();
}

template <int D>
void Stages<D>::detect() {
  renew_neighbors_if_needed();
  contacts_.find();
}

template <int D>
void Stages<D>::bond_new_blocks() {
  if (state_.model.materials.laws().any([](const ContactLaw& law) { return law.bonds(); })) {
    detect();
    state_.contacts.bond_fresh();
    state_.change_contacts();  // bonded pairs count from now on
  }
  state_.contacts.end_fresh();
}

/// A given one, or the stable one.
template <int D>
bool Stages<D>::choose_time_step() {
  const WorldSettings<D>& settings = state_.model.settings;
  if (settings.time_step != 0) return state_.clock.choose(settings.time_step);
  detect();  // the present contacts count
  const double stable = settings.safety * state_.stable_step.bound();
  // A step that is divided where blocks are fast does not depend on speeds.
  return state_.clock.choose(settings.fast_blocks == FastBlocks::refuse
                                 ? std::min(stable, state_.continuous_collision.safe_time_step())
                                 : stable);
}

/// Memory of blocks is taken first, that of pairs by detection: contacts are found only when all of it is
/// there.
template <int D>
StepResult Stages<D>::load_changed() {
  Model<D>& model = state_.model;
  const std::size_t slots = model.blocks.slot_count();
  const bool may_sleep = model.settings.sleep_tolerance > 0;
  model.actions.renew(model.blocks);
  state_.stable_step.reserve(slots);
  state_.integrator.reserve(slots);
  if (may_sleep) state_.sleep.reserve(slots);
  if (!choose_time_step()) return StepResult::no_time_step;
  state_.integrator.resize(slots);
  if (!model.viscous_nodes.empty()) model.viscous_nodes.renew(model.blocks.meshes());
  if (may_sleep) state_.sleep.resize(slots);
  evaluate_forces(0);
  return StepResult::ok;
}

template <int D>
void Stages<D>::end_beginning() {
  double noise = 0;
  const EnergySample sample = state_.integrator.begin(state_.clock.time_step(), noise);
  state_.note_speeds(sample);
  state_.ledger.begin(sample, noise);
  state_.edited = false;
}

template class Stages<2>;
template class Stages<3>;

}  // namespace halfspace
