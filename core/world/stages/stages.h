#pragma once

#include <cstddef>
#include <cstdint>

#include "world/contacts/bond_pass.h"
#include "world/stages/contact_stage.h"
#include "world/stages/state.h"
#include "world/stages/step_result.h"
#include "world/stages/stopwatch.h"
#include "world/stages/water_pass.h"

namespace halfspace {

/// Maximum number of motions in one call of step().
constexpr int max_motions = 1 << 14;

// A motion takes a world from where forces are known to where they are known again, by velocity Verlet. Its
// stages are the rows of the table in stages.cpp, which a step, a step of a share, the evaluation of forces
// for a host, and the stopwatch follow:
//
//   actions .. divide   predict the motion; shortened, or with a new neighbour list, it is predicted again
//   drift               moves the blocks
//   contacts .. loads   the forces at the new positions
//   impacts .. book     velocities at the end, and the energies

/// A motion: a step, or a part of it where fast blocks divide the step.
struct Motion {
  double duration = 0;  // s
  double made = 0;      // duration if it has moved the blocks; 0 if forces are evaluated where they are, s
  int renewals = 0;     // of the neighbour list, in its prediction
  EnergySample sample = {};  // at its end
  StepResult result = StepResult::ok;
};

/// The stages, in their order. Ranges of them exclude the last.
enum class StageName {
  actions,
  predict,
  search,
  wake,
  impulses,
  divide,
  drift,
  contacts,
  gather,
  water,
  bolts,
  bonds,
  compounds,
  loads,
  impacts,
  kick,
  rebounds,
  book,
  end
};

/// The outcome of a stage. Predicting stages may have shortened the motion, or made a new neighbour list for
/// it, so that it is predicted again; or they refuse it.
enum class Outcome { done, shortened, relisted, refused };

/// The stages of the motions of a world, and their working memory.
template <int D>
class Stages {
 public:
  explicit Stages(State<D>& state);

  /// Runs stages from one up to another, or until one refuses the motion. Returns why, or that it is ok.
  StepResult run(StageName from, StageName to, Motion& motion);

  /// Computes the contacts and their forces where the blocks are. `elapsed`: time over which shear springs
  /// grow, s.
  void evaluate_forces(double elapsed) {
    Motion motion{.duration = elapsed};
    run(StageName::contacts, StageName::loads, motion);
  }
  /// Neighbour search, if the list needs a rebuild, and detection.
  void detect();
  /// Bonds new blocks to those that they touch, where a contact law bonds.
  void bond_new_blocks();
  /// Contacts and forces of a changed world.
  StepResult load_changed();
  /// Accelerations and ledger of a changed world, from its forces.
  void end_beginning();
  /// Makes a new neighbour list. `renewals`: how often the coming motion has had the list renewed. If memory
  /// runs out, nothing has changed: contacts, list and memory in use remain valid.
  void renew_neighbors(int renewals = 0);
  void renew_neighbors_if_needed();
  /// Finds what snapshots do not contain. Precondition: the state that was read is consistent.
  void end_reading();
  /// Reserves the working memory of pairs, laws, water and times of impact, which snapshots do not contain.
  void fit_rooms();

  /// Call before the first motion of a step.
  void begin_step() {
    motions_ = 0;
    first_iteration_ = state_.hard_contacts.iterations();
  }
  /// Call after a motion that is not the last of its step.
  void pass_part(double duration) {
    state_.clock.pass_part(duration);
    ++motions_;
  }
  /// Has the step taken too many motions, or too many iterations?
  bool is_overworked() const;
  /// Maximum number of iterations for the impulses of a divided step.
  std::int64_t max_divided_iterations() const;

  /// Stages report their times to the stopwatch; a null pointer removes it.
  void set_stopwatch(Stopwatch* stopwatch) { stopwatch_ = stopwatch; }

 private:
  /// A stage is left out if it is not used, and its time belongs to a pass.
  struct Stage {
    StageName name;
    Pass pass;
    bool (*is_used)(const State<D>& state);
    Outcome (Stages::*run)(Motion& motion);
  };
  static const Stage& stage_of(StageName name);

  // stages/predict.cpp
  Outcome predict_actions(Motion& motion);
  Outcome predict(Motion& motion);
  Outcome search(Motion& motion);
  Outcome wake_met(Motion& motion);
  Outcome predict_impulses(Motion& motion);
  Outcome divide(Motion& motion);
  Outcome diverged(Motion& motion) const;

  // stages/move.cpp
  Outcome drift(Motion& motion);
  Outcome find_impacts(Motion& motion);
  Outcome kick(Motion& motion);
  Outcome stop_approach(Motion& motion);
  Outcome book(Motion& motion);

  // stages/load.cpp
  Outcome load_contacts(Motion& motion);
  Outcome gather(Motion& motion);
  Outcome load_by_water(Motion& motion);
  Outcome load_by_bolts(Motion& motion);
  Outcome load_by_bonds(Motion& motion);
  Outcome load_compounds(Motion& motion);
  Outcome place_loads(Motion& motion);

  bool choose_time_step();

  State<D>& state_;
  ContactStage<D> contacts_;
  BondPass<D> bonds_;
  WaterPass<D> water_;
  Stopwatch* stopwatch_ = nullptr;
  int motions_ = 0;                   // that the present step has made
  std::int64_t first_iteration_ = 0;  // of the present step
};

extern template class Stages<2>;
extern template class Stages<3>;

}  // namespace halfspace
