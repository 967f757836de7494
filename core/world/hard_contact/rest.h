#pragma once

#include <span>

#include "world/hard_contact/impulse_problem.h"
#include "world/hard_contact/islands.h"
#include "world/model/model.h"
#include "world/motion/integrator.h"

namespace halfspace {

/// The two halves of a motion, each with its impulse problem.
enum class Half { first, second };

/// Blocks that stand. Impulses within the tolerance leave blocks velocities within it: an island of contacts
/// in which all are as slow is held, so that it does not move at all. Where that is the whole world, the next
/// motion begins as the last one did, and while no load changes it would end as that one: it is not computed
/// again.
template <int D>
class Rest {
 public:
  Rest(const Model<D>& model, Integrator<D>& integrator, Memory* memory)
      : model_(model), blocks_(model.blocks), integrator_(integrator), islands_(memory), state_(memory) {}

  /// Is the coming motion of this duration the last one again?
  bool lasts(double duration) const;
  /// Holds all blocks as in the last motion.
  void repeat();

  // The stages of a motion that is computed.
  void begin() { standing_halves_ = repeated_halves_ = 0; }
  /// Has no block been faster than this so far?
  bool may_hold_all(Half half, double speed) const;
  /// Holds all blocks if none is faster than this in the problem, whose motions contain the impulses. False
  /// otherwise.
  bool hold_all(Half half, const ImpulseProblem<D>& problem, double speed);
  /// Holds the islands of which no block is faster.
  void hold_islands(Half half, const ImpulseProblem<D>& problem, double speed);
  /// A block has been moved after all.
  void forget_halves() { standing_halves_ = repeated_halves_ = 0; }
  /// Have all blocks been held, so that nothing has moved?
  bool holds_all() const { return standing_halves_ == 2; }
  /// `are_contacts_kept`: the contacts are those of the motion before.
  void end(double duration, bool are_contacts_kept) {
    lasts_ = repeated_halves_ == 2 && are_contacts_kept;
    duration_ = duration;
  }
  /// Something has changed.
  void forget() { lasts_ = false; }

  void reserve(std::size_t blocks) {
    islands_.reserve(blocks);
    state_.reserve(blocks);
  }
  bool is_consistent() const { return is_nonnegative(duration_) && (lasts_ == 0 || lasts_ == 1); }
  template <class Archive>
  void visit(Archive& archive) {
    archive(lasts_, duration_);
  }

 private:
  template <class Visit>
  bool for_all_movers(Visit visit) const;
  bool is_slow(std::size_t block, const BlockMotion<D>& motion, double speed) const;
  void find_islands(const ImpulseProblem<D>& problem, double speed);
  bool are_slow(const ImpulseContact<D>& contact, const ImpulseProblem<D>& problem, double speed) const;
  bool stands(std::size_t block);

  const Model<D>& model_;
  const Blocks<D>& blocks_;
  Integrator<D>& integrator_;
  enum class State : std::uint8_t { without_contacts, stands, moves };
  Islands islands_;
  Array<State> state_;       // of each block; of an island that of its head
  int standing_halves_ = 0;  // in which all blocks were held
  int repeated_halves_ = 0;  // in which they were held by impulses that have not changed
  std::int32_t lasts_ = 0;   // in the whole last motion
  double duration_ = 0;      // of the last motion
};

extern template class Rest<2>;
extern template class Rest<3>;

}  // namespace halfspace
