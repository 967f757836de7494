#pragma once

#include <cstdint>
#include <span>
#include <tuple>

#include "block/blocks.h"
#include "force/law.h"
#include "force/potential/potential_force.h"
#include "force/spring/spring.h"
#include "narrow_phase/contact.h"
#include "narrow_phase/sweep.h"
#include "world/candidates.h"
#include "world/ledger.h"

namespace halfspace {

/// What becomes of a step in which two blocks would move far against the thinner of them.
enum class FastBlocks : std::int32_t { divide = 0, refuse = 1 };

/// How a world is stepped.
template <int D>
struct WorldSettings {
  Vector<D> gravity = Vector<D>::Zero();
  double time_step = 0;  // 0: safety times the stable one
  double safety = 0.5;
  double local_damping = 0;
  double mass_damping = 0;
  double skin = 0.1;
  double potential_length = 0;  // H of potential laws; 0: mean length of the edges when forces are first used
  DetectOptions detect;
  FastBlocks fast_blocks = FastBlocks::divide;

  template <class Archive>
  void visit(Archive& archive) {
    archive(gravity, time_step, safety, local_damping, mass_damping, skin, potential_length, detect,
            fast_blocks);
  }
};

enum class StepResult { ok, unstable, no_time_step, too_fast };

/// Two blocks that meet, or are in touch, too fast for a step against the thinner of them.
struct FastPair {
  std::int32_t a = 0;
  std::int32_t b = 0;
  double speed = 0;      // of the fastest point of one against the other, at most
  double thickness = 0;  // of the thinner
  double time_step = 0;  // that would do
};

/// The most motions in one call of step().
constexpr int most_motions = 1 << 14;

/// No block turns farther at once, in rad, and no affine one changes its gradient more.
constexpr double most_turn = 1;

/// Blocks, their contacts, and time.
template <int D>
class World {
 public:
  World(const WorldSettings<D>& settings, Memory* memory);

  // Making and changing.
  std::int32_t add_material(double density);
  double density(std::int32_t material) const { return density_[std::size_t(material)]; }
  std::int32_t material_count() const { return std::int32_t(density_.size()); }
  void set_elasticity(std::int32_t material, const Elasticity& elasticity);
  const Elasticity& elasticity(std::int32_t material) const { return elasticity_[std::size_t(material)]; }
  void set_default_law(const SpringLaw& law);
  void set_law(std::int32_t a, std::int32_t b, const SpringLaw& law);
  std::int32_t add_block(const Shape<D>& shape, BlockKind kind, std::int32_t material,
                         const Vector<D>& position, const Rotation<D>& rotation);
  void remove_block(std::int32_t slot);
  void set_pose(std::int32_t slot, const Vector<D>& position, const Rotation<D>& rotation);
  void set_velocity(std::int32_t slot, const Vector<D>& velocity, const Angular<D>& spin);
  /// Of an affine block.
  void set_deformation(std::int32_t slot, const Tensor<D>& gradient, const Tensor<D>& rate);
  void set_stress(std::int32_t slot, const Tensor<D>& stress);
  /// Force per area of a face, in the plane of an edge, as the shape was given.
  void add_surface_load(std::int32_t slot, int face, const Vector<D>& traction);
  void clear_surface_loads(std::int32_t slot);
  void set_applied_force(std::int32_t slot, const Vector<D>& force, const Angular<D>& torque);

  // Stages.
  /// Neighbour search, when motion has used the list up, and detection.
  void detect();
  bool is_detected() const { return detected_; }
  /// Contact forces into the blocks; shear springs grow over `elapsed`.
  void evaluate_forces_for_host(double elapsed);
  /// One step of velocity Verlet. When memory runs out the world is as it was before; when the motion is not
  /// stable no block has moved.
  StepResult step();
  /// Brings time step, contacts, forces and ledger up to date after changes.
  StepResult prepare();

  // Reading.
  const Blocks<D>& blocks() const { return blocks_; }
  std::size_t contact_count() const { return touching_.size(); }
  /// Described anew from the present poses and the remembered pair: reading contacts costs time, but stepping
  /// no memory for them.
  Contact<D> contact(std::size_t c) const;
  /// As many as contacts, or none before forces are evaluated.
  std::span<const ContactForce<D>> contact_forces() const { return forces_; }
  const Candidate<D>& candidate_of(std::size_t contact) const {
    return candidates_.pairs()[touching_[contact]];
  }
  const Candidates<D>& candidates() const { return candidates_; }
  const Ledger& ledger() const { return ledger_; }
  double time() const { return epoch_time_ + double(steps_ - epoch_step_) * time_step_ + passed_; }
  std::int64_t steps() const { return steps_; }
  double time_step() const { return time_step_; }
  /// So many steps have been divided.
  std::int64_t divided_steps() const { return divided_steps_; }
  /// After StepResult::too_fast.
  const FastPair& fast_pair() const { return fast_pair_; }
  /// The largest share of the thinner block's thickness up to which springs let two blocks come, the root of
  /// d^2 + v^2 m/k for those that approach at v where they are nearest and lie d deep: of all when they met,
  /// of those that divided a step in each part of it, and of those in the neighbour list now.
  double deepest_stop() const;
  /// The largest of all contacts found so far that were described, which those of potentials in space are
  /// not.
  double peak_overlap() const { return peak_overlap_; }
  /// The largest of all blocks that move freely, at the ends of all motions so far.
  double peak_speed() const { return peak_speed_; }
  /// H of potential laws: one length for all blocks (Zheng et al. 2020, section 3.2).
  double potential_length() const;
  bool knows_potential() const { return laws_.knows_potential(); }
  /// Largest stable step by Gershgorin's bound, infinite when nothing can touch.
  double stable_time_step();
  /// Sets the shear spring of a contact in force on b, of which what lies in the contact plane counts. False
  /// when it has none.
  bool set_shear_force(std::size_t contact, const Vector<D>& force);

  /// Takes the room that laws and times of impact need, which a snapshot does not hold.
  void fit_rooms();
  /// False for what no world can be, after reading a snapshot: a damaged one is refused and not run.
  bool is_consistent() const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(settings_, density_, elasticity_, fresh_, any_fresh_, laws_, blocks_, candidates_, touching_,
            forces_, acceleration_, momentum_rate_, ledger_, noise_energy_, residual_before_edit_, power_,
            epoch_time_, epoch_step_, time_step_, passed_, fixed_length_, steps_, divided_steps_,
            deepest_stop_, peak_overlap_, peak_speed_, detected_, edited_);
    if constexpr (Archive::reads) {  // steps find contacts until the next search, and ask for no memory
      touching_.reserve(candidates_.room());
      forces_.reserve(candidates_.room());
    }
  }

 private:
  /// What drives a block, before damping.
  struct Drive {
    Vector<D> force;
    Angular<D> torque;
  };

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

  /// Rates at which prescribed motion, and torques on affine blocks, put energy in and damping takes it out.
  struct Power {
    double outer = 0;
    double contact_damping = 0;
    double local_damping = 0;
    double mass_damping = 0;
    double block_damping = 0;
  };

  /// What is summed over the blocks.
  struct Stock {
    double kinetic = 0;
    double gravity = 0;
    double block_strain = 0;
    double squared_speed = 0;  // of the fastest
    double squared_swing = 0;  // of the points that move fastest about their centroid
    Power power;
  };

  /// What the forces of all contacts have in common, and what they sum up to.
  struct Evaluation {
    double elapsed;
    double potential_length;
    ContactEnergy energy{};
    // Of the contact at hand, where a block is affine.
    Stretch<D> stretch{};
    StrainRates<D> strain_rates{};
  };

  /// Of a contact, or of all that a block has.
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

  /// All that a step of a changed world writes to before it moves the blocks, but for the pairs and what is
  /// worked out anew from the rest.
  auto preparation() {
    return std::tuple_cat(
        candidates_.skins(),
        std::tie(touching_, forces_, blocks_.force, blocks_.torque, fresh_, any_fresh_, ledger_,
                 noise_energy_, residual_before_edit_, power_, epoch_time_, epoch_step_, time_step_, passed_,
                 peak_overlap_, peak_speed_, detected_, edited_));
  }

  void edit();
  void change_laws();
  const SpringLaw& law_of(const Candidate<D>& pair) const {
    return laws_.between(blocks_.material[std::size_t(pair.a)], blocks_.material[std::size_t(pair.b)]);
  }
  void describe(const Candidate<D>& pair, Contact<D>& contact) const;
  bool is_described(const Candidate<D>& pair) const;
  void remember_overlap(const Candidate<D>& pair, const Contact<D>& contact);
  double rounding_of_touch(const Candidate<D>& pair) const;
  bool find_contact(std::size_t k, Contact<D>& contact);
  template <class OnContact>
  void find_contacts(OnContact on_contact);
  double mean_edge_length() const;
  void fix_potential_length();
  PairMotion<D> motion_of(const Candidate<D>& pair, Evaluation& evaluation) const;
  const StrainRates<D>* strain_rates_of(std::size_t a, std::size_t b, Evaluation& evaluation) const;
  PairLoad<D> spring_load(Candidate<D>& pair, const Contact<D>& contact, const SpringLaw& law,
                          const Spring<D>& spring, ShearSpring<D>& shear, Evaluation& evaluation) const;
  PotentialForce<D> potential_between(Candidate<D>& pair, const PlacedBlocks<D>& at, bool is_step);
  PairLoad<D> potential_load(Candidate<D>& pair, const SpringLaw& law, const Spring<D>& spring,
                             ShearSpring<D>& shear, Evaluation& evaluation);
  void load_blocks(std::size_t candidate, const Contact<D>& contact, Evaluation& evaluation);
  void strain_blocks(const Candidate<D>& pair, const PairLoad<D>& load, bool is_damped,
                     Evaluation& evaluation);
  void release_shear(std::size_t candidate);
  void make_bonds();
  void forget_contacts();
  /// Finds the contacts on the way, unless they are known.
  void evaluate_forces(double elapsed);
  bool choose_time_step();
  void start_ledger();
  bool plan_motion(double duration);
  bool plan_block(std::size_t slot, const Vector<D>& velocity, double turn);
  StepResult prepare_and_plan();
  StepResult plan_changed();
  StepResult plan_rest();
  StepResult divide();
  double swing(std::size_t slot) const;
  double thinner(const Candidate<D>& pair) const;
  double speed_between(const Candidate<D>& pair) const;
  double calm_time_step() const;
  void note_speeds(const Stock& stock);
  bool is_fast(std::size_t slot) const;
  bool any_fast() const;
  double calm_part();
  double calm_part_of(Candidate<D>& pair, double& stable_duration);
  double section(std::size_t slot) const;
  double stiffness_between(const Candidate<D>& pair) const;
  Contact<D> nearest_of(const Candidate<D>& pair) const;
  Vector<D> velocity_at(std::size_t slot, const Vector<D>& arm) const;
  double stop_from(const Candidate<D>& pair, double speed, double depth) const;
  double stop_of(const Candidate<D>& pair) const;
  double most_of_stop(const Candidate<D>& pair) const;
  void note_meeting(const Candidate<D>& pair);
  Sweep<D> planned_sweep(std::size_t slot) const;
  Sweep<D> made_sweep(std::size_t slot) const;
  void describe_entrance(Candidate<D>& pair, Contact<D>& contact);
  void move();
  std::size_t most_edges() const;
  std::size_t most_components() const;
  void renew_candidates();
  void renew_used_up_candidates();
  void kick_and_drift();
  void kick_and_book();
  void take_stock(std::size_t slot, const Vector<D>& opposed, const Angular<D>& opposed_spin,
                  Stock& stock) const;
  double reduced_mass(std::size_t a, std::size_t b) const;
  double dashpot_power(std::size_t slot) const;
  double largest_stiffness(const SpringLaw& law, std::size_t slot, double potential_length) const;
  Hardness hardest_contact(std::size_t slot, double potential_length) const;
  Hardness hardness_of(std::size_t contact, double potential_length) const;
  double wave_of(std::size_t slot) const;
  bool makes_energy() const;
  Drive drive(std::size_t slot) const;
  void accelerate(std::size_t slot);
  void accelerate_rigid(std::size_t slot);
  Vector<D> affine_drive(std::size_t slot) const;
  Tensor<D> strain_drive(std::size_t slot) const;
  void accelerate_affine(std::size_t slot);
  bool plan_affine(std::size_t slot);
  void kick_and_drift_affine(std::size_t slot);
  void take_affine_stock(std::size_t slot, const Vector<D>& opposed, const Tensor<D>& opposed_rate,
                         Stock& stock) const;
  void kick_and_book_affine(std::size_t slot, Stock& stock, double& applied_power);
  const Elasticity& elasticity_of(std::size_t slot) const { return elasticity(blocks_.material[slot]); }

  WorldSettings<D> settings_;
  Array<double> density_;
  Array<Elasticity> elasticity_;  // of each material
  Array<std::uint8_t> fresh_;     // of each block: its first step has not begun
  std::int32_t any_fresh_ = 0;
  LawTable laws_;
  Blocks<D> blocks_;
  Candidates<D> candidates_;
  Array<std::uint32_t> touching_;     // the candidate of each contact
  Array<ContactForce<D>> forces_;     // of each contact
  Array<DashpotLoad> dashpot_load_;   // of each block, when a law is damped
  PotentialRoom<D> potential_room_;   // for the largest blocks, when a law is of potentials
  Array<double> impact_room_;         // for two of the largest blocks
  Array<Hardness> hardness_;          // of each block's contacts, when the stable step is asked for
  Array<Vector<D>> acceleration_;     // of each block, from the last forces
  Array<Angular<D>> momentum_rate_;   // of the angular momentum, likewise
  Array<Rotation<D>> next_rotation_;  // planned for the coming step
  Ledger ledger_;
  double noise_energy_ = 0;  // of the whole, below which energy made by the numbers is not judged
  double residual_before_edit_ = 0;
  Power power_;            // at the last forces
  double epoch_time_ = 0;  // when the time step was last chosen
  std::int64_t epoch_step_ = 0;
  double time_step_ = 0;
  double passed_ = 0;                  // of a step that is divided and not at its end
  double duration_ = 0;                // of the coming motion: the step or a part of it
  double made_ = 0;                    // of the motion just made, while contacts are found that it has led to
  double longest_motion_ = 0;          // of all blocks in the coming motion
  double fastest_squared_ = HUGE_VAL;  // bound of the speed of all points now; not saved
  double most_turned_ = 0;             // of all blocks in the coming motion
  double fixed_length_ = 0;            // H, once the first forces have been used
  std::int64_t steps_ = 0;
  std::int64_t divided_steps_ = 0;
  double deepest_stop_ = 0;  // of pairs that have met, and that have divided a step
  double peak_overlap_ = 0;
  double peak_speed_ = 0;
  FastPair fast_pair_;         // that has divided the step most, or for which it was refused
  std::int32_t detected_ = 0;  // contacts belong to the present poses
  std::int32_t edited_ = 1;    // since the last step: forces, accelerations and ledger are of another state
};

extern template class World<2>;
extern template class World<3>;

}  // namespace halfspace
