#include <halfspace/box2d_impulse.hpp>
#include <stdexcept>

#include "impulses.h"
#include "mode.h"
#include "solver_veto.h"

namespace halfspace::box2d {
namespace {

/// Keeps all bodies awake: a sleeping body would hold others without a load of its own.
class NoSleep {
 public:
  explicit NoSleep(b2World& world) : world_(world), is_allowed_(world.GetAllowSleeping()) {
    world.SetAllowSleeping(false);
  }
  ~NoSleep() { world_.SetAllowSleeping(is_allowed_); }
  NoSleep(const NoSleep&) = delete;
  NoSleep& operator=(const NoSleep&) = delete;

 private:
  b2World& world_;
  bool is_allowed_;
};

void wake_all(b2World& world) {
  for (b2Body* body = world.GetBodyList(); body; body = body->GetNext()) {
    if (body->GetType() != b2_staticBody) body->SetAwake(true);
  }
}

}  // namespace

ImpulseMode::ImpulseMode(NarrowPhase& narrow_phase, const ImpulseOptions& options)
    : narrow_phase_(*narrow_phase.installation_), options_(options) {
  require_can_begin(narrow_phase_);
  impulses_ = make_impulses();
  narrow_phase_.has_mode = true;
}

ImpulseMode::~ImpulseMode() { narrow_phase_.has_mode = false; }

std::unique_ptr<ImpulseMode::Impulses> ImpulseMode::make_impulses() const {
  return std::make_unique<Impulses>(narrow_phase_, options_);
}

/// A new mirror replaces one that has stopped within a step, as after too fast a motion, and repeats the
/// step.
void ImpulseMode::advance(float time_step) {
  if (impulses_->is_within_step()) impulses_ = make_impulses();
  try {
    impulses_->advance(time_step);
  } catch (const std::invalid_argument&) {
    if (!impulses_->is_within_step()) throw;
    impulses_ = make_impulses();
    impulses_->advance(time_step);
  }
}

void ImpulseMode::step(float time_step, int velocity_iterations, int position_iterations) {
  b2World& world = narrow_phase_.world();
  require_unlocked(world);
  require_time_step(time_step);
  if (world.GetSubStepping())
    throw std::logic_error("sub-stepping is enabled; disable it (b2World::SetSubStepping)");
  const NoSleep no_sleep(world);
  wake_all(world);
  if (time_step > 0) advance(time_step);
  const SolverVeto veto(world, [&](const b2Contact& contact) { return impulses_->keep(contact); });
  world.Step(time_step, velocity_iterations, position_iterations);
  if (time_step > 0) impulses_->complete(time_step);
}

double ImpulseMode::unbalanced_velocity() const { return impulses_->unbalanced_velocity(); }

const hs_world* ImpulseMode::world() const { return impulses_->world(); }

hs_block ImpulseMode::block_of(const b2Fixture& fixture) const { return impulses_->block_of(fixture); }

}  // namespace halfspace::box2d
