#pragma once

#include <array>

#include "world/hard_contact/impulse_problem.h"
#include "world/model/model.h"
#include "world/motion/integrator.h"
#include "world/motion/islands.h"

namespace halfspace {

/// The two halves of a motion, each with its impulse problem.
enum class Half { first, second };

/// Blocks that stand. Impulses within the tolerance leave blocks velocities within it. An island of contacts
/// stands where all blocks are as slow, and where contacts that bear and stick, one after the other, connect
/// each of them with a block that does not move: then only the tolerance is in the way of no motion. Its
/// blocks are held, so that they do not move at all. Where that is the whole world, the next motion begins as
/// the last one did, and while no load changes it would end as that one: it is not computed again.
template <int D>
class Rest {
 public:
  Rest(const Model<D>& model, Integrator<D>& integrator, Memory* memory)
      : model_(model), blocks_(model.blocks), integrator_(integrator), stuck_(memory), moves_(memory) {}

  /// Is the coming motion of this duration the last one again?
  bool lasts(double duration) const;
  /// Holds all blocks as in the last motion.
  void repeat();

  // The stages of a motion that is computed.
  /// No half has been solved, or a block has been moved after all.
  void begin() { holds_all_ = is_repeated_ = {false, false}; }
  /// Notes which blocks are no faster than this.
  void note_slow(double speed, Array<std::uint8_t>& is_slow) const;
  /// Has no block been faster than this so far?
  bool may_hold_all(Half half, double speed) const;
  /// Do all blocks stand, none faster than this in the problem, whose motions contain the impulses? Then
  /// holds them; the impulses are those of the motion before.
  bool hold_all(Half half, ImpulseProblem<D>& problem, double speed);
  /// Holds the blocks that stand.
  void hold_islands(Half half, ImpulseProblem<D>& problem, double speed);
  /// Have all blocks been held, so that nothing has moved?
  bool holds_all() const { return holds_all_[0] && holds_all_[1]; }
  /// `are_contacts_kept`: the contacts are those of the motion before.
  void end(double duration, bool are_contacts_kept) {
    lasts_ = is_repeated_[0] && is_repeated_[1] && are_contacts_kept;
    duration_ = duration;
  }
  /// Something has changed.
  void forget() { lasts_ = false; }

  void reserve(std::size_t blocks) {
    stuck_.reserve(blocks + 1);
    moves_.reserve(blocks);
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
  bool is_slow(const ImpulseContact<D>& contact, const ImpulseProblem<D>& problem, double speed) const;
  bool is_guided(std::size_t block) const;
  void find_standing(ImpulseProblem<D>& problem, double speed);
  bool stands(const ImpulseProblem<D>& problem, std::size_t block) const {
    const std::int32_t island = problem.islands.of_block(std::int32_t(block));
    return island >= 0 && !moves_[std::size_t(island)];
  }
  void hold_standing(Half half, const ImpulseProblem<D>& problem);
  bool all_stand(const ImpulseProblem<D>& problem, double speed);

  const Model<D>& model_;
  const Blocks<D>& blocks_;
  Integrator<D>& integrator_;
  Islands stuck_;              // by contacts that bear and stick; the last number is that of all that stays
  Array<std::uint8_t> moves_;  // each island
  // By half of the motion: have all blocks been held, and by impulses that have not changed?
  std::array<bool, 2> holds_all_{}, is_repeated_{};
  std::int32_t lasts_ = 0;  // in the whole last motion impulses were repeated
  double duration_ = 0;     // of the last motion
};

extern template class Rest<2>;
extern template class Rest<3>;

}  // namespace halfspace
