#pragma once

#include "world/contact_list.h"
#include "world/model.h"

namespace halfspace {

/// Bounds the time step from above, by the stiffness of contacts and blocks against their masses.
template <int D>
class StableStep {
 public:
  StableStep(const Model<D>& model, const ContactList<D>& contacts, Memory* memory)
      : model_(model), blocks_(model.blocks), contacts_(contacts), hardness_(memory) {}

  /// The largest step that is stable for certain, infinite when nothing can touch. Contacts are known.
  double bound();
  void reserve(std::size_t slots) { hardness_.reserve(slots); }

 private:
  /// The hardness of a contact, or the sum of all that a block has.
  struct Hardness {
    int contacts = 0;
    double stiffness = 0;
    double turning_stiffness = 0;  // besides that by the springs' arms
    double viscosity = 0;

    void add(const Hardness& other, int times) {
      contacts += other.contacts;
      stiffness += times * other.stiffness;
      turning_stiffness += times * other.turning_stiffness;
      viscosity += times * other.viscosity;
    }
  };

  double largest_stiffness(const SpringLaw& law, std::size_t block, double potential_length) const;
  Hardness hardest_contact(std::size_t block, double potential_length) const;
  Hardness hardness_of(std::size_t contact, double potential_length) const;
  double wave_of(std::size_t block) const;

  const Model<D>& model_;
  const Blocks<D>& blocks_;
  const ContactList<D>& contacts_;
  Array<Hardness> hardness_;  // of each block's contacts
};

extern template class StableStep<2>;
extern template class StableStep<3>;

}  // namespace halfspace
