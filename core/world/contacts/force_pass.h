#pragma once

#include <span>

#include "force/potential/potential_force.h"
#include "force/spring/spring.h"
#include "threads/threads.h"
#include "world/contacts/contact_list.h"
#include "world/model/model.h"

namespace halfspace {

/// Loads the blocks with the forces of their contacts, by the laws of their materials. Each contact writes
/// what is its own; then the blocks gather it, each in ascending order of its contacts. So the sums have the
/// same bits, whoever has worked out which contact.
template <int D>
class ForcePass {
 public:
  ForcePass(Model<D>& model, ContactList<D>& contacts, Threads* threads, Memory* memory)
      : model_(model),
        blocks_(model.blocks),
        contacts_(contacts),
        neighbors_(contacts.neighbors()),
        threads_(threads),
        forces_(memory),
        dashpots_(memory),
        virials_(memory),
        dashpot_load_(memory),
        is_loaded_(memory),
        potential_rooms_(memory) {
    const int workers = worker_count(threads);
    potential_rooms_.reserve(std::size_t(workers));
    for (int worker = 0; worker < workers; ++worker) potential_rooms_.emplace_back(memory);
  }

  /// The common part of the forces of a chunk of contacts, and their sums.
  struct Evaluation {
    double elapsed;
    double potential_length;
    int worker = 0;
    ContactEnergy energy{};
    std::int32_t last_block = -1;
    // These are of the contact at hand, where a block is affine.
    Stretch<D> stretch{};
    StrainRates<D> strain_rates{};
  };

  /// Shear springs will grow over `elapsed`.
  Evaluation begin(double elapsed) const;
  /// Works out what the contact of a pair in the list does to its two blocks.
  void load(std::size_t k, const Contact<D>& contact, Evaluation& evaluation);
  /// Loads the blocks with that of all contacts. `chunks` are those whose pairs have been loaded.
  void gather(std::span<const PairSums> chunks);
  void forget() { known_ = false; }

  bool are_known() const { return known_; }
  const ContactForce<D>& of_contact(std::size_t c) const { return forces_[contacts_.touching()[c]]; }
  /// Rate of what a block loses to the dashpots of its contacts, by its present velocity.
  double dashpot_power(std::size_t block) const;

  /// Takes the room that laws need, which a snapshot does not hold, and that for a contact at every pair,
  /// also of a list that is to be taken into use.
  void fit_rooms();

  /// All that a step of a changed world writes to before it moves the blocks.
  auto state() { return std::tie(forces_, known_, blocks_.force, blocks_.torque); }

  template <class Archive>
  void visit(Archive& archive) {
    archive(known_);
    if constexpr (Archive::reads) forces_.resize(neighbors_.room());
    if (!known_ || !contacts_.names_pairs()) return;
    for (const std::uint32_t k : contacts_.touching()) archive(forces_[k]);
  }

 private:
  static constexpr std::size_t blocks_per_strip = 256;

  /// The load of a block by the dashpots of its contacts: their loss is known with its velocity at the end of
  /// the step.
  struct DashpotLoad {
    Vector<D> force = Vector<D>::Zero();
    Angular<D> torque = Angular<D>::Zero();

    void add(const Vector<D>& more_force, const Angular<D>& more_torque) {
      force += more_force;
      torque += more_torque;
    }
  };

  /// The virials by which a contact strains affine blocks, and the part of them that its dashpots make.
  struct Virials {
    Tensor<D> on_a = Tensor<D>::Zero();
    Tensor<D> on_b = Tensor<D>::Zero();
    Tensor<D> of_dashpots_on_a = Tensor<D>::Zero();
    Tensor<D> of_dashpots_on_b = Tensor<D>::Zero();
  };

  PairMotion<D> motion_of(const Candidate<D>& pair, Evaluation& evaluation) const;
  const StrainRates<D>* strain_rates_of(std::size_t a, std::size_t b, Evaluation& evaluation) const;
  PairLoad<D> spring_load(Candidate<D>& pair, const Contact<D>& contact, const ContactLaw& law,
                          const Spring<D>& spring, ShearSpring<D>& shear, Evaluation& evaluation) const;
  PotentialForce<D> potential_between(Candidate<D>& pair, const PlacedBlocks<D>& at, int worker,
                                      bool is_step);
  PairLoad<D> potential_load(Candidate<D>& pair, const ContactLaw& law, const Spring<D>& spring,
                             ShearSpring<D>& shear, Evaluation& evaluation);
  Virials virials_of(const Candidate<D>& pair, const PairLoad<D>& load, bool is_damped,
                     Evaluation& evaluation) const;
  void gather_row(std::size_t first_block, std::size_t last_block, std::span<const PairSums> chunks);
  void gather_contacts(std::size_t first_block, std::size_t last_block,
                       std::span<const std::uint32_t> contacts);
  void unload(std::size_t first_block, std::size_t last_block);
  void unload_strip(std::size_t first_block, std::size_t last_block);
  void strain(std::size_t block, const Tensor<D>& virial, const Tensor<D>& of_dashpots);

  Model<D>& model_;
  Blocks<D>& blocks_;
  const ContactList<D>& contacts_;
  NeighborList<D>& neighbors_;
  Threads* threads_;
  Array<ContactForce<D>> forces_;            // at the pairs that are in contact
  Array<DashpotForce<D>> dashpots_;          // likewise, when a law is damped
  Array<Virials> virials_;                   // likewise, when a block is affine
  Array<DashpotLoad> dashpot_load_;          // of each block, when a law is damped
  Array<std::uint8_t> is_loaded_;            // of each strip of blocks: some block may bear a load
  Array<PotentialRoom<D>> potential_rooms_;  // of each worker, for the largest blocks
  std::int32_t known_ = 0;                   // forces belong to the contacts
};

extern template class ForcePass<2>;
extern template class ForcePass<3>;

}  // namespace halfspace
