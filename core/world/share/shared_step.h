#pragma once

#include "world/stages/stages.h"

namespace halfspace {

/// The needs of the next motion of a share.
struct SharedMotion {
  StepResult result = StepResult::ok;  // too_fast: it would have to be divided
  bool needs_list = false;             // blocks may meet others that are not in the list in use
  bool needs_assembly = false;         // an entry face has to be told to other shares
};

/// A step of a share, in pieces between which the host carries bytes. The pieces are ranges of the stages of
/// World::step(), in one motion: what would divide it is refused.
template <int D>
class SharedStep {
 public:
  SharedStep(State<D>& state, Stages<D>& stages) : state_(state), stages_(stages) {}

  /// World::prepare() in pieces: contacts and forces; then, with the loads of copies set, accelerations.
  StepResult begin();
  void end_beginning() { stages_.end_beginning(); }
  /// A prediction, then a new list where any share needs one.
  SharedMotion predict();
  SharedMotion renew_list();
  /// The motion and its forces; then, with the loads of copies set, the velocities at its end.
  void move();
  void end();
  /// Replaces the loads of a copy's contacts by those that its owner has computed. `virial`: of an affine
  /// one.
  void set_loads(std::size_t slot, const Vector<D>& force, const Angular<D>& torque, const Tensor<D>& virial);

 private:
  SharedMotion needs_of_motion();
  StepResult division();

  State<D>& state_;
  Stages<D>& stages_;
};

extern template class SharedStep<2>;
extern template class SharedStep<3>;

}  // namespace halfspace
