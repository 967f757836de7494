#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "world/contacts/contact_list.h"
#include "world/model/model.h"

namespace halfspace {

/// Computes the stable time step from the stiffness and the mass of contacts and blocks.
template <int D>
class StableStep {
 public:
  StableStep(const Model<D>& model, const ContactList<D>& contacts, Memory* memory)
      : model_(model), blocks_(model.blocks), contacts_(contacts), stiffness_of_block_(memory) {}

  /// The stable time step, a lower bound of the critical one, and the block that determines it.
  struct Limit {
    double step = HUGE_VAL;   // s; HUGE_VAL if nothing can touch
    std::int32_t block = -1;  // -1 then
    bool by_itself = false;   // its own or its body's vibration contributes more than contacts
  };

  /// Precondition: contacts are found.
  Limit limit();
  double bound() { return limit().step; }
  /// The other block of the stiffest contact or bond of a block, if it has any.
  struct Neighbor {
    std::int32_t block;
    std::int64_t bond;  // -1: a contact
  };
  std::optional<Neighbor> stiffest_neighbor_of(std::int32_t block) const;
  /// Stiffness and viscosity of a contact, or their sums over the contacts of a block.
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
  /// Upper bounds, as a contact may grow to the whole face of a block.
  StiffnessSum sum_over_contacts_of(std::int32_t block) const;
  void reserve(std::size_t slots) { stiffness_of_block_.reserve(slots); }

 private:
  double largest_stiffness(const ContactLaw& law, std::size_t block, double potential_length) const;
  StiffnessSum stiffest_contact(std::size_t block, double potential_length) const;
  StiffnessSum contact_stiffness_of(std::size_t contact, double potential_length) const;
  StiffnessSum contact_stiffness_of(const Bond<D>& bond) const;
  void add_bolt(const Bolt<D>& bolt);
  /// The maximum frequency of a deformable block, squared, and its damping time.
  struct Wave {
    double squared_frequency;
    double damping_time;
  };
  Wave wave_of(std::size_t block) const;

  const Model<D>& model_;
  const Blocks<D>& blocks_;
  const ContactList<D>& contacts_;
  Array<StiffnessSum> stiffness_of_block_;  // per block, over its contacts
};

extern template class StableStep<2>;
extern template class StableStep<3>;

}  // namespace halfspace
