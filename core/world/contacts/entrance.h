#pragma once

#include <algorithm>

#include "world/contacts/contact_list.h"
#include "world/model/model.h"

namespace halfspace {

// Internal edges. A block that slides over the joint of two others penetrates the first slightly, so it meets
// the second below the surface, apparently through the face in the joint, which is covered. Detection
// therefore lifts a block out of each block that it already touches. If the lift separates the two that have
// met, the entry face is one that faces the lift.
//
// Where joints cross, corners of a cut rock often meet before any of them rests on a third block, and nothing
// tells the face in the joint then. So a contact at a corner is asked about again now and then: a lift that
// leaves less of its overlap than all lifts along its own face shows the entry face. The lift of a meeting
// counts only if this question agrees, or contacts would swing. See docs/concepts/contact.md.

/// Determines the entry faces of blocks that have met.
template <int D>
class Entrances {
 public:
  Entrances(const Model<D>& model, ContactList<D>& contacts, Memory* memory)
      : model_(model), contacts_(contacts), answers_(memory) {}

  /// Caches the entry face of a pair that has met, if other contacts of its blocks decide it. Returns whether
  /// they do. `found`: the sums of all chunks of pairs, after detection. `made`: the duration of the motion
  /// that has brought them together, s, or 0.
  bool find(std::size_t k, std::span<const PairSums> found, double made);
  /// Steps between two questions about contacts at corners: less than a period of springs.
  static constexpr std::int64_t steps_between = 16;
  /// The entry face of a pair, where the contacts of both blocks with a third show another than the cached
  /// one.
  struct Answer {
    std::uint32_t pair;
    PotentialPair<D> face;
  };
  /// Looks for such a face if a pair is in contact at a corner. Answers do not depend on the order of
  /// questions.
  void ask_again(std::uint32_t k);
  std::span<const Answer> answers() const { return answers_; }
  void forget_answers() { answers_.clear(); }
  /// Reserves memory for an answer of every pair.
  void fit_room() { answers_.reserve(contacts_.neighbors().room()); }
  /// Computes the contact of a pair that has met.
  void describe(std::size_t k, Contact<D>& contact);

 private:
  struct Way {
    PotentialPair<D> pair{};
    double gap = -HUGE_VAL;  // of the blocks after the lift
  };
  /// A displacement of block b relative to block a.
  struct Lift {
    Vector<D> normal;
    double depth;
  };
  Way free_way(const Candidate<D>& met, std::span<const PairSums> found, double made) const;
  bool was_overlapped(const Candidate<D>& met, PotentialPair<D> face, double made) const;
  bool does_touch(std::size_t k, std::span<const PairSums> found) const;
  std::optional<PotentialPair<D>> better_face(std::size_t k, std::span<const PairSums> found) const;
  Lift lift(const Candidate<D>& pair, std::int32_t lifted, const Candidate<D>& known) const;
  Way way_along(const Candidate<D>& pair, const PlacedBlocks<D>& at, const Vector<D>& normal) const;
  double smaller_radius(const Candidate<D>& pair) const {
    return std::min(model_.blocks.radius[std::size_t(pair.a)], model_.blocks.radius[std::size_t(pair.b)]);
  }

  const Model<D>& model_;
  ContactList<D>& contacts_;
  Array<Answer> answers_;
};

extern template class Entrances<2>;
extern template class Entrances<3>;

}  // namespace halfspace
