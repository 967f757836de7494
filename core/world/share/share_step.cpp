#include <algorithm>
#include <limits>
#include <new>

#include "geometry/precise.h"
#include "world/world.h"

// A step of a share, in pieces, between which the host carries bytes. The pieces are those of World::step()
// in one motion: what would divide it is refused.

namespace halfspace {
namespace {

/// A sum beside that of its rounding errors: in any order of the terms accurate to the rounding of the result
/// [Dekker 1971].
template <class Value>
struct AccurateSum {
  Value rounded = Value::Zero();
  Value errors = Value::Zero();

  void add(const Value& term) {
    for (int i = 0; i < Value::SizeAtCompileTime; ++i) {
      const Precise sum = difference(rounded[i], -term[i]);
      rounded[i] = sum.high;
      errors[i] += sum.low;
    }
  }
  Value value() const { return rounded + errors; }
};

}  // namespace

template <int D>
void World<D>::set_keys(std::span<const std::int64_t> keys) {
  const Blocks<D>& blocks = model_.blocks;
  Array<std::int64_t> of_slots(blocks.kind.get_allocator());
  of_slots.reserve(blocks.slot_count());
  std::int64_t last = std::numeric_limits<std::int64_t>::min();  // free slots repeat the key before
  auto next = keys.begin();
  for (std::size_t i = 0; i < blocks.slot_count(); ++i)
    of_slots.push_back(last = blocks.lives(i) ? *next++ : last);
  share_.set_keys(of_slots);
}

template <int D>
StepResult World<D>::begin_in_share() {
  drop_plan();
  if (!edited_ && !contacts_.has_new_blocks()) return StepResult::ok;
  renew_neighbors_if_needed();
  if (contacts_.has_new_blocks()) make_bonds();
  return edited_ ? load_changed() : StepResult::ok;
}

/// Would the predicted motion have to be divided?
template <int D>
StepResult World<D>::division_in_share() {
  const auto goes_far = [&](std::size_t i) {
    return model_.blocks.moves(i) && contacts_.neighbors().announced_motion(i) > model_.blocks.radius[i];
  };
  bool is_far = integrator_.max_rotation() > max_turn;
  for (std::size_t i = 0; i < model_.blocks.slot_count() && !is_far; ++i) is_far = goes_far(i);
  const bool is_fast = is_far || (continuous_collision_.any() && continuous_collision_.safe_fraction() < 1);
  return is_fast ? StepResult::too_fast : StepResult::ok;
}

/// A planned motion is not made where the world changes before it: the next step plans another.
template <int D>
void World<D>::drop_plan() {
  if (share_.stage() != ShareStage::planned) return;
  drop_motion();
  share_.enter(ShareStage::ready);
}

template <int D>
SharedMotion World<D>::plan_in_share() {
  drop_plan();
  share_.enter(ShareStage::planned);
  try {
    const SharedMotion motion = predict_in_share();
    if (motion.result != StepResult::ok) drop_plan();
    return motion;
  } catch (const std::bad_alloc&) {
    drop_plan();
    throw;
  }
}

template <int D>
SharedMotion World<D>::predict_in_share() {
  SharedMotion motion;
  motion.needs_assembly = share_.needs_assembly();
  const double duration = clock_.rest();
  if (!model_.actions.empty()) predict_actions(duration);
  hard_contacts_.begin(duration);
  if (!integrator_.predict(duration)) {
    motion.result = StepResult::unstable;
    return motion;
  }
  motion.needs_list = contacts_.neighbors().needs_rebuild();
  if (!motion.needs_list) motion.result = division_in_share();
  return motion;
}

template <int D>
SharedMotion World<D>::renew_list_in_share() {
  renew_neighbors();
  share_.find_idle(contacts_.neighbors().pairs());
  SharedMotion motion;
  motion.result = division_in_share();
  if (motion.result != StepResult::ok) drop_plan();
  return motion;
}

template <int D>
void World<D>::end_step_in_share() {
  end_motion();
  clock_.complete_step();
}

template <int D>
void World<D>::set_loads(std::size_t slot, const Vector<D>& force, const Angular<D>& torque,
                         const Tensor<D>& virial) {
  forces_.set_load(slot, force, torque);
  if (model_.blocks.is_affine(slot)) model_.blocks.deformation(slot).virial = virial;
}

template <int D>
Momentum<D> World<D>::momentum() const {
  const Blocks<D>& blocks = model_.blocks;
  AccurateSum<Vector<D>> linear;
  AccurateSum<Angular<D>> angular;
  for (std::size_t i = 0; i < blocks.slot_count(); ++i) {
    if (!blocks.moves_freely(i) || !share_.is_own(i) || blocks.is_part(i) || blocks.is_of_mesh(i)) continue;
    const Vector<D> of_block = blocks.mass[i] * blocks.velocity[i];
    linear.add(of_block);
    angular.add(moment(blocks.position[i], of_block));
    angular.add(blocks.momentum[i]);
  }
  return {linear.value(), angular.value()};
}

/// Two pairs of the list away: Share says why. A pair holds blocks whose gap is at most both skins when the
/// list is made, and each moves by its skin while the list is in use.
template <int D>
double World<D>::halo() {
  const Blocks<D>& blocks = model_.blocks;
  NeighborList<D>& neighbors = contacts_.neighbors();
  const double typical = common_of_shares().typical_radius;
  double reach = 0;
  for (std::size_t i = 0; i < blocks.slot_count(); ++i) {
    if (!blocks.moves_freely(i)) continue;
    const double usual = model_.settings.skin * 2 * std::min(blocks.radius[i], typical);
    const double planned = i < neighbors.list_length() ? neighbors.announced_motion(i) : 0;
    reach = std::max(reach, blocks.radius[i] + 2 * std::max({usual, planned, neighbors.skin_of(i)}));
  }
  return 4 * reach;
}

#define HALFSPACE_MEMBERS(D)                                                                             \
  template void World<D>::set_keys(std::span<const std::int64_t>);                                       \
  template StepResult World<D>::begin_in_share();                                                        \
  template StepResult World<D>::division_in_share();                                                     \
  template void World<D>::drop_plan();                                                                   \
  template SharedMotion World<D>::plan_in_share();                                                       \
  template SharedMotion World<D>::predict_in_share();                                                    \
  template SharedMotion World<D>::renew_list_in_share();                                                 \
  template void World<D>::end_step_in_share();                                                           \
  template void World<D>::set_loads(std::size_t, const Vector<D>&, const Angular<D>&, const Tensor<D>&); \
  template Momentum<D> World<D>::momentum() const;                                                       \
  template double World<D>::halo();

HALFSPACE_MEMBERS(2)
HALFSPACE_MEMBERS(3)
#undef HALFSPACE_MEMBERS

}  // namespace halfspace
