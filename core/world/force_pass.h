#pragma once

#include <span>

#include "force/potential/potential_force.h"
#include "force/spring/spring.h"
#include "world/model.h"
#include "world/neighbor_list.h"

namespace halfspace {

/// Loads the blocks with the forces of their contacts, by the laws of their materials. Each contact writes
/// what is its own; then the blocks gather it, each in ascending order of its contacts. So the sums have the
/// same bits, whoever has worked out which contact.
template <int D>
class ForcePass {
 public:
  ForcePass(Model<D>& model, NeighborList<D>& neighbors, Memory* memory)
      : model_(model),
        blocks_(model.blocks),
        neighbors_(neighbors),
        forces_(memory),
        dashpots_(memory),
        virials_(memory),
        dashpot_load_(memory),
        potential_room_(memory) {}

  /// What the forces of all contacts have in common, and what they sum up to.
  struct Evaluation {
    double elapsed;
    double potential_length;
    ContactEnergy energy{};
    // Of the contact at hand, where a block is affine.
    Stretch<D> stretch{};
    StrainRates<D> strain_rates{};
  };

  /// Unloads all blocks. Shear springs will grow over `elapsed`.
  Evaluation begin(double elapsed);
  /// Works out what the next contact does to its two blocks, of a pair in the list.
  void load(std::size_t k, const Contact<D>& contact, Evaluation& evaluation);
  /// Adds it to the blocks; the pair of each contact is given.
  void gather(const Array<std::uint32_t>& contacts);
  void forget() {
    forces_.clear();
    dashpots_.clear();
    virials_.clear();
  }

  /// As many as contacts, or none before forces are evaluated.
  std::span<const ContactForce<D>> forces() const { return forces_; }
  /// Rate of what a block loses to the dashpots of its contacts, by its present velocity.
  double dashpot_power(std::size_t block) const;

  /// Takes the room that laws need, which a snapshot does not hold, and that for a contact at every pair,
  /// also of a list that is to be taken into use.
  void fit_rooms();

  /// All that a step of a changed world writes to before it moves the blocks.
  auto state() { return std::tie(forces_, blocks_.force, blocks_.torque); }

  template <class Archive>
  void visit(Archive& archive) {
    archive(forces_);
  }

 private:
  /// What the dashpots of its contacts do to a block: what they lose is known with its velocity at the end of
  /// the step.
  struct DashpotLoad {
    Vector<D> force = Vector<D>::Zero();
    Angular<D> torque = Angular<D>::Zero();

    void add(const Vector<D>& more_force, const Angular<D>& more_torque) {
      force += more_force;
      torque += more_torque;
    }
  };

  /// What a contact does to the strain of affine blocks, and what of that its dashpots do.
  struct Virials {
    Tensor<D> on_a = Tensor<D>::Zero();
    Tensor<D> on_b = Tensor<D>::Zero();
    Tensor<D> of_dashpots_on_a = Tensor<D>::Zero();
    Tensor<D> of_dashpots_on_b = Tensor<D>::Zero();
  };

  PairMotion<D> motion_of(const Candidate<D>& pair, Evaluation& evaluation) const;
  const StrainRates<D>* strain_rates_of(std::size_t a, std::size_t b, Evaluation& evaluation) const;
  PairLoad<D> spring_load(Candidate<D>& pair, const Contact<D>& contact, const SpringLaw& law,
                          const Spring<D>& spring, ShearSpring<D>& shear, Evaluation& evaluation) const;
  PotentialForce<D> potential_between(Candidate<D>& pair, const PlacedBlocks<D>& at, bool is_step);
  PairLoad<D> potential_load(Candidate<D>& pair, const SpringLaw& law, const Spring<D>& spring,
                             ShearSpring<D>& shear, Evaluation& evaluation);
  Virials virials_of(const Candidate<D>& pair, const PairLoad<D>& load, bool is_damped,
                     Evaluation& evaluation) const;
  void strain(std::size_t a, std::size_t b, const Virials& virials);

  Model<D>& model_;
  Blocks<D>& blocks_;
  NeighborList<D>& neighbors_;
  Array<ContactForce<D>> forces_;    // of each contact
  Array<DashpotForce<D>> dashpots_;  // of each contact, when a law is damped
  Array<Virials> virials_;           // of each contact, when a block is affine
  Array<DashpotLoad> dashpot_load_;  // of each block, when a law is damped
  PotentialRoom<D> potential_room_;  // for the largest blocks, when a law is of potentials
};

extern template class ForcePass<2>;
extern template class ForcePass<3>;

}  // namespace halfspace
