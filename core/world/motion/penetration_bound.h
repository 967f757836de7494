#pragma once

#include <algorithm>

#include "world/contacts/contact_list.h"
#include "world/model/model.h"

namespace halfspace {

/// Bounds the penetration that springs allow. They are too soft for a block's speed if they allow a large
/// fraction of the thinner block's thickness.
template <int D>
class PenetrationBound {
 public:
  PenetrationBound(const Model<D>& model, const ContactList<D>& contacts)
      : model_(model), blocks_(model.blocks), contacts_(contacts) {}

  /// Maximum penetration ratio so far: sqrt(d^2 + v^2 m/k), for blocks at depth d that approach at speed v at
  /// the contact, over the thinner block's thickness. Computed when two blocks meet, in each motion of a
  /// divided step, and now for all pairs of the neighbour list.
  double deepest() const;
  /// Notes a pair of blocks in touch.
  void note(const Candidate<D>& pair) { deepest_ = std::max(deepest_, of(pair)); }
  /// Notes a ratio, such as that of of_meeting().
  void note(double share) { deepest_ = std::max(deepest_, share); }
  /// The ratio of two blocks that have just met; 0 if it cannot exceed the maximum noted so far.
  double of_meeting(const Candidate<D>& pair) const { return max_of(pair) > deepest_ ? of(pair) : 0; }

  double noted() const { return deepest_; }

  bool is_consistent() const { return is_nonnegative(deepest_); }
  template <class Archive>
  void visit(Archive& archive) {
    archive(deepest_);
  }

 private:
  double section(std::size_t block) const;
  double stiffness_between(const Candidate<D>& pair) const;
  Contact<D> nearest_of(const Candidate<D>& pair) const;
  double from(const Candidate<D>& pair, double speed, double depth) const;
  double of(const Candidate<D>& pair) const;
  double max_of(const Candidate<D>& pair) const;

  const Model<D>& model_;
  const Blocks<D>& blocks_;
  const ContactList<D>& contacts_;
  double deepest_ = 0;  // maximum noted
};

extern template class PenetrationBound<2>;
extern template class PenetrationBound<3>;

}  // namespace halfspace
