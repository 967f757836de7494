#pragma once

#include <algorithm>

#include "world/contacts/contact_list.h"
#include "world/model/model.h"

namespace halfspace {

/// How deep springs let blocks come: springs that cannot stop one within a share of the thinner block's
/// thickness are too soft for its speed.
template <int D>
class PenetrationBound {
 public:
  PenetrationBound(const Model<D>& model, const ContactList<D>& contacts)
      : model_(model), blocks_(model.blocks), contacts_(contacts) {}

  /// The largest share of the thinner block's thickness up to which springs let two blocks come, the root of
  /// d^2 + v^2 m/k for those that approach at v where they are nearest and lie d deep: of all when they met,
  /// of those that divided a step in each part of it, and of those in the neighbour list now.
  double deepest() const;
  /// Notes a pair of blocks in touch.
  void note(const Candidate<D>& pair) { deepest_ = std::max(deepest_, of(pair)); }
  /// Notes a share found by of_meeting().
  void note(double share) { deepest_ = std::max(deepest_, share); }
  /// The share of two blocks that were apart and touch now, or less where another is known that comes deeper.
  double of_meeting(const Candidate<D>& pair) const { return most_of(pair) > deepest_ ? of(pair) : 0; }

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
  double most_of(const Candidate<D>& pair) const;

  const Model<D>& model_;
  const Blocks<D>& blocks_;
  const ContactList<D>& contacts_;
  double deepest_ = 0;  // of those noted
};

extern template class PenetrationBound<2>;
extern template class PenetrationBound<3>;

}  // namespace halfspace
