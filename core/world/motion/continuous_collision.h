#pragma once

#include <cmath>

#include "narrow_phase/sweep.h"
#include "world/contacts/contact_list.h"
#include "world/model/model.h"
#include "world/motion/clock.h"
#include "world/motion/integrator.h"
#include "world/motion/penetration_bound.h"
#include "world/motion/stable_step.h"

namespace halfspace {

/// Two blocks that meet or touch at a relative speed too large for the step and the thinner block.
struct FastPair {
  std::int32_t a = 0;
  std::int32_t b = 0;
  double speed = 0;      // upper bound of the relative speed of their points, m/s
  double thickness = 0;  // of the thinner block, m
  double time_step = 0;  // a sufficient one, s
};

// A step is one motion if all pairs move little relative to their thinner block. Otherwise the time of impact
// limits the motion: first to just before the touch, then, while the two touch and are fast, to stable
// motions of a small fraction of the thickness. The rest of the step follows by the same rule. The pair of
// features that closes at the time of impact is cached as the separating one, so that detection takes it as
// the entry. A world with FastBlocks::refuse refuses a step that would have to be divided.

/// Finds fast blocks, the fraction of a motion that is safe for them, and the features through which they
/// meet.
template <int D>
class ContinuousCollision {
 public:
  ContinuousCollision(const Model<D>& model, ContactList<D>& contacts, const Integrator<D>& integrator,
                      const Clock& clock, StableStep<D>& stable_step, PenetrationBound<D>& stop, int workers,
                      Memory* memory)
      : model_(model),
        blocks_(model.blocks),
        contacts_(contacts),
        integrator_(integrator),
        clock_(clock),
        stable_step_(stable_step),
        stop_(stop),
        workers_(workers),
        impact_room_(memory) {}

  /// The largest step in which no listed pair is fast, at the current speeds.
  double safe_time_step() const;
  /// Updates the bound of all speeds.
  void note_speeds(const EnergySample& sample);
  /// True when any block is fast in the predicted motion.
  bool any() const;
  /// The fraction of the predicted motion that is safe for all pairs. Caches the features through which pairs
  /// meet.
  double safe_fraction();
  /// The pair with the smallest safe fraction, or for which a step was refused.
  const FastPair& pair() const { return pair_; }

  /// Caches the entry of two blocks that met in the last motion, of duration `made`: of the pairs of features
  /// that separated them at its start, the last to close, even if another is less deep now.
  void find_entrance(Candidate<D>& pair, double made, int worker);

  /// Reserves the working memory of times of impact, which snapshots do not contain.
  void fit_room() {
    room_of_one_ = 2 * blocks_.max_components();
    impact_room_.resize(std::size_t(workers_) * room_of_one_);
  }

 private:
  bool is_fast(std::size_t block) const;
  double safe_fraction_of(Candidate<D>& pair, double& stable_duration);
  double* room_of(int worker) { return impact_room_.data() + std::size_t(worker) * room_of_one_; }
  Sweep<D> predicted_sweep(std::size_t block) const;
  Sweep<D> made_sweep(std::size_t block, double made) const;

  const Model<D>& model_;
  const Blocks<D>& blocks_;
  ContactList<D>& contacts_;
  const Integrator<D>& integrator_;
  const Clock& clock_;
  StableStep<D>& stable_step_;
  PenetrationBound<D>& stop_;
  int workers_;
  std::size_t room_of_one_ = 0;
  Array<double> impact_room_;          // per worker, for two of the largest blocks
  double fastest_squared_ = HUGE_VAL;  // bound of the squared speed of all points; not saved
  FastPair pair_;
};

extern template class ContinuousCollision<2>;
extern template class ContinuousCollision<3>;

}  // namespace halfspace
