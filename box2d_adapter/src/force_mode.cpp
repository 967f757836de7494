#include <algorithm>
#include <cmath>
#include <halfspace/box2d_force.hpp>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "contact.h"
#include "forces.h"
#include "mode.h"
#include "solver_veto.h"

namespace halfspace::box2d {
namespace {

/// Keeps forces of the host over all sub-steps, and clears them afterwards if Box2D clears them after a step.
class KeptForces {
 public:
  explicit KeptForces(b2World& world) : world_(world), are_cleared_(world.GetAutoClearForces()) {
    world.SetAutoClearForces(false);
  }
  ~KeptForces() {
    world_.SetAutoClearForces(are_cleared_);
    if (are_cleared_) world_.ClearForces();
  }
  KeptForces(const KeptForces&) = delete;
  KeptForces& operator=(const KeptForces&) = delete;

 private:
  b2World& world_;
  bool are_cleared_;
};

/// Box2D updates contacts of sleeping bodies only one step after they wake.
void set_enabled(b2World& world, bool are_enabled) {
  for (b2Contact* contact = world.GetContactList(); contact; contact = contact->GetNext()) {
    if (judged_pair_of(*contact)) contact->SetEnabled(are_enabled);
  }
}

/// 0 means that no contact is possible.
void require_stable(float sub_step, double stable) {
  if (stable == 0 || sub_step <= stable) return;
  std::ostringstream reason;
  reason << "sub-steps of " << sub_step << " s are longer than the stable sub-step of " << stable << " s";
  throw std::invalid_argument(reason.str());
}

}  // namespace

ForceMode::ForceMode(NarrowPhase& narrow_phase, const hs_law_def& law)
    : world_(narrow_phase.installation_->world()) {
  NarrowPhase::Installation& installation = *narrow_phase.installation_;
  require_can_begin(installation);
  if (law.stiffness_kind == HS_STIFFNESS_NONE)
    throw std::invalid_argument(
        "law.stiffness_kind is HS_STIFFNESS_NONE; force mode needs springs, use ImpulseMode");
  forces_ = std::make_unique<Forces>(installation, law);
  set_enabled(world_, false);
  installation.has_mode = true;
}

ForceMode::~ForceMode() {
  forces_->narrow_phase().has_mode = false;
  set_enabled(world_, true);
}

void ForceMode::step(float time_step, int sub_steps, int velocity_iterations, int position_iterations) {
  require_time_step(time_step);
  if (sub_steps < 1) throw std::invalid_argument("sub_steps must be at least 1");
  const float sub_step = time_step / float(sub_steps);
  require_stable(sub_step, stable_sub_step());
  const KeptForces kept(world_);
  for (int i = 0; i < sub_steps; ++i) {
    if (forces_->is_awake()) {
      forces_->evaluate();
      forces_->push(sub_step);
    }
    const SolverVeto veto(world_);
    world_.Step(sub_step, velocity_iterations, position_iterations);
    forces_->carry_on(sub_step);
  }
}

double ForceMode::stable_sub_step() {
  require_unlocked(world_);
  forces_->follow();
  forces_->evaluate();
  return forces_->stable_sub_step();
}

int ForceMode::sub_steps_for(float time_step) {
  require_time_step(time_step);
  const double stable = stable_sub_step();
  if (stable == 0) return 1;
  const double wanted = std::ceil(time_step / (0.5 * stable));
  return int(std::clamp(wanted, 1.0, double(std::numeric_limits<int>::max())));
}

const hs_world* ForceMode::world() const { return forces_->world(); }

hs_block ForceMode::block_of(const b2Fixture& fixture) const { return forces_->block_of(fixture); }

}  // namespace halfspace::box2d
