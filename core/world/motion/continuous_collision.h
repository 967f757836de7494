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

/// Two blocks that meet, or are in touch, too fast for a step against the thinner of them.
struct FastPair {
  std::int32_t a = 0;
  std::int32_t b = 0;
  double speed = 0;      // of the fastest point of one against the other, at most
  double thickness = 0;  // of the thinner
  double time_step = 0;  // that would do
};

// A step in which all pairs move little against the thinner of their blocks is one motion. Where one does
// not, its time of impact tells how far the motion may go: until just before the first touch, and from there
// on by small shares of the thickness, and stable ones, for as long as the two are fast in touch. What is
// left of the step comes after that, by the same rule. The pair that is first in time is the one through
// which blocks meet: when detection finds the contact it is remembered as what kept them apart. A world that
// shall not divide its steps refuses one that it would have to.

/// Which blocks are fast against what they may meet, how far they may move at once, and through what they
/// met.
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

  /// The longest step in which no listed pair is fast, at present speeds.
  double safe_time_step() const;
  /// Takes note of how fast blocks are now.
  void note_speeds(const EnergySample& sample);
  /// Does any block move far in the planned motion against what it may meet?
  bool any() const;
  /// The part of the planned motion that all pairs may make at once. Where one meets in that part, it is told
  /// through what.
  double safe_fraction();
  /// The pair that has divided a step most, or for which it was refused.
  const FastPair& pair() const { return pair_; }

  /// Two blocks have met in the motion of such a duration just made. Of the pairs that kept them apart at its
  /// start the last to close is the one through which they met, also where others are less deep by now. It is
  /// remembered.
  void find_entrance(Candidate<D>& pair, double made, int worker);

  /// Takes the room that times of impact need, which a snapshot does not hold.
  void fit_room() {
    room_of_one_ = 2 * blocks_.most_components();
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
  Array<double> impact_room_;          // of each worker, for two of the largest blocks
  double fastest_squared_ = HUGE_VAL;  // bound of the speed of all points now; not saved
  FastPair pair_;
};

extern template class ContinuousCollision<2>;
extern template class ContinuousCollision<3>;

}  // namespace halfspace
