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
// See docs/concepts/contact.md.

/// Determines the entry faces of blocks that have met.
template <int D>
class Entrances {
 public:
  Entrances(const Model<D>& model, ContactList<D>& contacts, Memory* memory)
      : model_(model), contacts_(contacts), answers_(memory) {}

  /// Another entry face of a pair than the one through which it has met.
  struct Answer {
    std::uint32_t pair;
    PotentialPair<D> face;
  };
  /// Reserves memory for an answer of every pair.
  void fit_room() { answers_.reserve(contacts_.neighbors().room()); }
  /// `made`: the duration of the motion that pairs have met in, s, or 0.
  void begin(double made) {
    answers_.clear();
    made_ = made;
  }
  /// Asks the other contacts of its blocks for the entry face of a pair that has met. Answers do not depend
  /// on the order of questions.
  void ask(std::uint32_t k);
  std::span<const Answer> answers() const { return answers_; }
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
    bool is_older;  // the blocks touched before the last motion
  };
  bool touched_before(const Candidate<D>& pair, double gap, const Vector<D>& normal) const;
  Lift lift(const Candidate<D>& pair, std::int32_t lifted, const Candidate<D>& known) const;
  Way way_along(const Candidate<D>& pair, const PlacedBlocks<D>& at, const Vector<D>& normal) const;
  double smaller_radius(const Candidate<D>& pair) const {
    return std::min(model_.blocks.radius[std::size_t(pair.a)], model_.blocks.radius[std::size_t(pair.b)]);
  }

  const Model<D>& model_;
  ContactList<D>& contacts_;
  Array<Answer> answers_;
  double made_ = 0;
};

extern template class Entrances<2>;
extern template class Entrances<3>;

}  // namespace halfspace
