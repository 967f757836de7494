#pragma once

#include <algorithm>
#include <span>

#include "world/contacts/contact_list.h"
#include "world/hard_contact/rigid_contact.h"
#include "world/model/model.h"
#include "world/motion/integrator.h"

namespace halfspace {

/// Finds the manifolds of rigid blocks without springs that touch or may touch in the predicted motion.
template <int D>
class ManifoldSearch {
 public:
  ManifoldSearch(const Model<D>& model, const ContactList<D>& contacts, const Integrator<D>& integrator,
                 Memory* memory)
      : model_(model),
        blocks_(model.blocks),
        contacts_(contacts),
        integrator_(integrator),
        ahead_(memory),
        allowance_(memory) {}

  void find(double duration, std::span<const RigidContact<D>> known, Array<PredictedContact<D>>& found);
  bool find_more(Array<PredictedContact<D>>& found) const;

  /// Calls `visit(a, b)` for a moving and a sleeping block that touch at the end of their motion by present
  /// velocities.
  template <class Visit>
  void for_each_meeting(double duration, Visit visit) {
    pose_ahead(duration);
    for (const Candidate<D>& pair : contacts_.neighbors().pairs()) {
      if (!model_.has_manifold(pair) || !integrator_.sleep().may_wake(pair)) continue;
      RigidContact<D> contact;
      contact.a = pair.a;
      contact.b = pair.b;
      const PosedBlock<D> a = ahead(std::size_t(pair.a)), b = ahead(std::size_t(pair.b));
      if (find_manifold(a, b, reach(contact), contact.manifold)) visit(pair.a, pair.b);
    }
  }
  /// Do impulses move a block? They do not while it sleeps.
  bool is_free(std::size_t slot) const { return blocks_.moves_freely(slot) && !integrator_.is_asleep(slot); }
  PosedBlock<D> now(std::size_t slot) const;
  /// At the end of the predicted motion.
  PosedBlock<D> predicted(std::size_t slot) const;
  /// Sets normal and gaps to those of now.
  void set_gaps(PredictedContact<D>& contact) const;
  Gaps<D> predicted_gaps(const PredictedContact<D>& contact) const;
  /// The displacement of b against a in the predicted motion, where friction acts.
  Vector<D> predicted_slip(const PredictedContact<D>& contact) const;
  double smaller_radius(const RigidContact<D>& contact) const {
    return std::min(blocks_.radius[std::size_t(contact.a)], blocks_.radius[std::size_t(contact.b)]);
  }
  /// A point nearer to a face than this is on it.
  double reach(const RigidContact<D>& contact) const;
  /// A point less deep than this does not recover. Friction acts at the centroid of the points within
  /// this distance of the lowest one.
  double settled_gap(const RigidContact<D>& contact) const;
  /// A loaded point this close to its face stays as it is.
  double resting_gap(const RigidContact<D>& contact) const;

 private:
  bool may_touch(const Candidate<D>& pair) const;
  bool moves(std::size_t slot, double duration) const;
  void pose_ahead(double duration);
  PosedBlock<D> ahead(std::size_t slot) const { return slot < ahead_.size() ? ahead_[slot] : now(slot); }
  const Vector<D>& place_ahead(std::size_t slot) const {
    return slot < ahead_.size() ? ahead_[slot].position : blocks_.position[slot];
  }
  /// How far a block may deviate from the pose ahead, m.
  double allowance(std::size_t slot) const;

  const Model<D>& model_;
  const Blocks<D>& blocks_;
  const ContactList<D>& contacts_;
  const Integrator<D>& integrator_;
  // Both arrays end at the last block that moves. The others stay.
  Array<PosedBlock<D>> ahead_;  // at the end of the motion, by its velocity now
  Array<double> allowance_;     // m
};

extern template class ManifoldSearch<2>;
extern template class ManifoldSearch<3>;

}  // namespace halfspace
