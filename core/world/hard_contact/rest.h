#pragma once

#include <span>

#include "world/model/model.h"
#include "world/motion/integrator.h"

namespace halfspace {

/// The two halves of a motion, each with its impulse problem.
enum class Half { first, second };

/// A world in which every block stands. Impulses within the tolerance leave blocks velocities within it:
/// where all are, blocks are held, so that they do not move at all. The next motion then begins as the last
/// one did, and while no load changes it would end as that one: it is not computed again.
template <int D>
class Rest {
 public:
  Rest(const Model<D>& model, Integrator<D>& integrator)
      : model_(model), blocks_(model.blocks), integrator_(integrator) {}

  /// Is the coming motion of this duration the last one again?
  bool lasts(double duration) const;
  /// Holds all blocks, whose motions without impulses are those of the last motion.
  void repeat();

  // A motion that is computed.
  void begin() { held_halves_ = 0; }
  /// Holds all blocks if their points are slower than this in the given motions, which contain the impulses.
  bool hold(Half half, std::span<const BlockMotion<D>> motions, double speed);
  /// A block has been moved after all.
  void forget_halves() { held_halves_ = 0; }
  /// `are_contacts_kept`: the contacts are those of the motion before.
  void end(double duration, bool are_contacts_kept) {
    lasts_ = held_halves_ == 2 && are_contacts_kept;
    duration_ = duration;
  }
  /// Something has changed.
  void forget() { lasts_ = false; }

  bool is_consistent() const { return is_nonnegative(duration_) && (lasts_ == 0 || lasts_ == 1); }
  template <class Archive>
  void visit(Archive& archive) {
    archive(lasts_, duration_);
  }

 private:
  template <class Visit>
  bool for_all_movers(Visit visit) const;

  const Model<D>& model_;
  const Blocks<D>& blocks_;
  Integrator<D>& integrator_;
  int held_halves_ = 0;     // of the motion that is computed
  std::int32_t lasts_ = 0;  // blocks were held throughout the last motion
  double duration_ = 0;     // of the last motion
};

extern template class Rest<2>;
extern template class Rest<3>;

}  // namespace halfspace
