#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "world/contacts/contact_list.h"
#include "world/model/model.h"

namespace halfspace {

/// Bounds the time step from above, by the stiffness of contacts and blocks against their masses.
template <int D>
class StableStep {
 public:
  StableStep(const Model<D>& model, const ContactList<D>& contacts, Memory* memory)
      : model_(model), blocks_(model.blocks), contacts_(contacts), stiffness_of_block_(memory) {}

  /// The largest step that is stable for certain, and the block that sets it.
  struct Limit {
    double step = HUGE_VAL;   // when nothing can touch
    std::int32_t block = -1;  // -1 then
    bool by_itself = false;   // its own vibration, or its body's, has more part in it than what it meets
  };

  /// Contacts are known.
  Limit limit();
  double bound() { return limit().step; }
  /// The other block of the stiffest contact or bond of a block, if it has any.
  struct Neighbor {
    std::int32_t block;
    std::int64_t bond;  // -1: it is a contact
  };
  std::optional<Neighbor> stiffest_neighbor_of(std::int32_t block) const;
  void reserve(std::size_t slots) { stiffness_of_block_.reserve(slots); }

 private:
  /// The hardness of a contact, or the sum of all that a block has.
  struct StiffnessSum {
    int contacts = 0;
    double stiffness = 0;
    double viscosity = 0;

    void add(const StiffnessSum& other, int times) {
      contacts += other.contacts;
      stiffness += times * other.stiffness;
      viscosity += times * other.viscosity;
    }
  };

  double largest_stiffness(const ContactLaw& law, std::size_t block, double potential_length) const;
  StiffnessSum stiffest_contact(std::size_t block, double potential_length) const;
  StiffnessSum contact_stiffness_of(std::size_t contact, double potential_length) const;
  StiffnessSum contact_stiffness_of(const Bond<D>& bond) const;
  /// The largest frequency of a deformable block, and how fast its damping acts.
  struct Wave {
    double squared_frequency;
    double damping_time;
  };
  Wave wave_of(std::size_t block) const;

  const Model<D>& model_;
  const Blocks<D>& blocks_;
  const ContactList<D>& contacts_;
  Array<StiffnessSum> stiffness_of_block_;  // of each block's contacts
};

extern template class StableStep<2>;
extern template class StableStep<3>;

}  // namespace halfspace
