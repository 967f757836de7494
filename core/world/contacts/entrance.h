#pragma once

#include "world/contacts/contact_list.h"
#include "world/model/model.h"

namespace halfspace {

// A block that slides over the joint of two others is pressed a little into the one that it leaves, and meets
// the next one below the surface: through the face in the joint, as it seems, where nothing can ever come in.
// So an entrance counts only where it is free: where a block, lifted out of one that it is pressed against
// already, is out of the other as well, they meet through what lies that way. Game engines call such a face
// an internal edge.

/// Through which of their faces two blocks have met.
template <int D>
class Entrances {
 public:
  Entrances(const Model<D>& model, ContactList<D>& contacts) : model_(model), contacts_(contacts) {}

  /// A pair of the list that has met: it is remembered, and its contact described, as of the free entrance.
  /// `found` are the sums of the chunks of pairs, all of which have been gone through.
  void describe(std::size_t k, std::span<const PairSums> found, Contact<D>& contact);

 private:
  struct Way {
    PotentialPair<D> pair{};
    double gap = -HUGE_VAL;  // that it leaves of the lifted blocks
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
