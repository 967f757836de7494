#pragma once

#include <span>

#include "force/potential/potential_force.h"
#include "force/spring/pressure_room.h"
#include "force/spring/spring.h"
#include "threads/threads.h"
#include "world/contacts/contact_list.h"
#include "world/model/model.h"

namespace halfspace {

/// Computes contact forces by the laws of the materials, and sums them per block. Each contact writes its own
/// load; then each block adds up its loads in ascending order of contacts. So the sums have the same bits for
/// any number of threads.
template <int D>
class ForcePass {
 public:
  /// A strip is unloaded as a whole.
  static constexpr std::size_t blocks_per_strip = 256;

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
        pressure_rooms_(memory),
        potential_rooms_(memory) {
    const int workers = worker_count(threads);
    pressure_rooms_.reserve(std::size_t(workers));
    potential_rooms_.reserve(std::size_t(workers));
    for (int worker = 0; worker < workers; ++worker) {
      pressure_rooms_.emplace_back(memory);
      potential_rooms_.emplace_back(memory);
    }
  }

  /// Input common to a chunk of contacts, and the sums over it.
  struct Evaluation {
    double elapsed;
    double potential_length;
    int worker = 0;
    ContactEnergy energy{};
    std::int32_t last_block = -1;
    double peak_overlap = 0;  // of pressures
    // The current contact's strains, if one of its blocks is deformable.
    Stretch<D> stretch{};
    StrainRates<D> strain_rates{};
  };

  /// `elapsed`: time over which shear springs grow, s. If it is not 0, velocities are those of its middle.
  Evaluation begin(double elapsed) const;
  /// Computes the load of a pair's contact on its two blocks, by a law of this kind.
  template <StiffnessKind kind>
  void load(std::size_t k, const Contact<D>& contact, Evaluation& evaluation);
  /// Sums the loads of all contacts per block. `chunks`: those whose pairs have been loaded.
  void gather(std::span<const PairSums> chunks);
  /// Adds another load to those of a block's contacts, after gather(). `virial`: force times arm^T.
  void add_load(std::size_t block, const Vector<D>& force, const Tensor<D>& virial) {
    is_loaded_[block / blocks_per_strip] = true;
    blocks_.force[block] += force;
    blocks_.torque[block] += moment(virial);
    if (blocks_.is_deformable(block)) blocks_.deformation(block).virial += virial;
  }
  /// Adds the loads of parts, of contacts and bonds, to those of their compounds.
  void load_compounds();
  void forget() { known_ = false; }

  bool are_known() const { return known_; }
  const ContactForce<D>& of_contact(std::size_t c) const { return forces_[contacts_.touching()[c]]; }
  /// Power that a block loses to the dashpots of its contacts at its current velocity, W.
  double dashpot_power(std::size_t block) const;

  /// Reserves working memory of laws, which snapshots do not contain, and memory for a contact of every pair,
  /// including those of the next list.
  void fit_rooms();

  /// The force of a pair in contact.
  const ContactForce<D>& of_pair(std::size_t k) const { return forces_[k]; }
  // Taking over the forces of another world, after fit_rooms().
  void set_force(std::size_t k, const ContactForce<D>& force) { forces_[k] = force; }
  void end_taking_over(const ForcePass& from) { known_ = from.known_; }

  /// Replaces the sum of a block's loads.
  void set_load(std::size_t block, const Vector<D>& force, const Angular<D>& torque) {
    is_loaded_[block / blocks_per_strip] = true;
    blocks_.force[block] = force;
    blocks_.torque[block] = torque;
  }

  /// State that a step after an edit writes before it moves the blocks.
  auto state() { return std::tie(forces_, known_, is_loaded_, blocks_.force, blocks_.torque); }

  template <class Archive>
  void visit(Archive& archive) {
    archive(known_);
    if constexpr (Archive::reads) forces_.resize(neighbors_.room());
    if (!known_ || !contacts_.names_pairs()) return;
    for (const std::uint32_t k : contacts_.touching()) archive(forces_[k]);
  }

 private:
  /// The load of a block by the dashpots of its contacts. Their loss follows from the velocity at the end of
  /// the step.
  struct DashpotLoad {
    Vector<D> force = Vector<D>::Zero();
    Angular<D> torque = Angular<D>::Zero();

    void add(const Vector<D>& more_force, const Angular<D>& more_torque) {
      force += more_force;
      torque += more_torque;
    }
  };

  /// The virials of a contact on deformable blocks, and the part due to its dashpots.
  struct Virials {
    Tensor<D> on_a = Tensor<D>::Zero();
    Tensor<D> on_b = Tensor<D>::Zero();
    Tensor<D> of_dashpots_on_a = Tensor<D>::Zero();
    Tensor<D> of_dashpots_on_b = Tensor<D>::Zero();
  };

  [[gnu::always_inline]] inline PairMotion<D> motion_of(const Candidate<D>& pair,
                                                        Evaluation& evaluation) const;
  const StrainRates<D>* strain_rates_of(std::size_t a, std::size_t b, Evaluation& evaluation) const;
  PairLoad<D> pressure_load(Candidate<D>& pair, const Contact<D>& contact, const PlacedBlocks<D>& at,
                            const ContactLaw& law, const Spring<D>& spring, ShearSpring<D>& shear,
                            Evaluation& evaluation);
  PairLoad<D> potential_load(Candidate<D>& pair, const PlacedBlocks<D>& at, const ContactLaw& law,
                             const Spring<D>& spring, ShearSpring<D>& shear, Evaluation& evaluation);
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
  Array<ContactForce<D>> forces_;            // per pair, valid for those in contact
  Array<DashpotForce<D>> dashpots_;          // likewise, when a law is damped
  Array<Virials> virials_;                   // likewise, when a block is deformable
  Array<DashpotLoad> dashpot_load_;          // per block, when a law is damped
  Array<std::uint8_t> is_loaded_;            // per strip of blocks: 1 if some load may not be 0
  Array<PressureRoom<D>> pressure_rooms_;    // per worker, for the largest blocks
  Array<PotentialRoom<D>> potential_rooms_;  // per worker, for the largest blocks
  std::int32_t known_ = 0;                   // 1: forces are those of the current contacts
};

extern template class ForcePass<2>;
extern template class ForcePass<3>;

}  // namespace halfspace
