#pragma once

#include "world/contacts/contact_list.h"
#include "world/model/model.h"

namespace halfspace {

// Internal edges. A block that slides over the joint of two others penetrates the first slightly, so it meets
// the second below the surface, apparently through the face in the joint, which is covered. Detection
// therefore lifts a block out of each block that it already touches. If the lift separates the two that have
// met, the entry face is one that faces the lift. See docs/concepts/contact.md.

/// Determines the entry faces of blocks that have met.
template <int D>
class Entrances {
 public:
  Entrances(const Model<D>& model, ContactList<D>& contacts) : model_(model), contacts_(contacts) {}

  /// Caches the entry face of a pair that has met, if other contacts of its blocks decide it. Returns whether
  /// they do. `found`: the sums of all chunks of pairs, after detection.
  bool find(std::size_t k, std::span<const PairSums> found);
  /// Computes the contact of a pair that has met.
  void describe(std::size_t k, Contact<D>& contact);

 private:
  struct Way {
    PotentialPair<D> pair{};
    double gap = -HUGE_VAL;  // of the blocks after the lift
  };
  Way free_way(const Candidate<D>& met, std::span<const PairSums> found) const;
  bool has_met(std::size_t k, std::span<const PairSums> found) const;
  Way way_beside(const Candidate<D>& met, std::int32_t lifted, const Candidate<D>& known) const;

  const Model<D>& model_;
  ContactList<D>& contacts_;
};

extern template class Entrances<2>;
extern template class Entrances<3>;

}  // namespace halfspace
