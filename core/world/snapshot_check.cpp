#include <algorithm>
#include <cmath>

#include "force/potential/space/planned_force.h"
#include "world/world.h"

// What a snapshot must fulfil so that running it never leads out of an array. Numbers may be wrong in value:
// that is what the checksum is for; here the question is what a wrong index could do, or what is no number.

namespace halfspace {
namespace {

bool is_finite(double value) { return std::isfinite(value); }
bool is_positive(double value) { return value > 0 && std::isfinite(value); }
bool is_from_zero(double value) { return value >= 0 && std::isfinite(value); }

template <class Values, class Condition>
bool all(const Values& values, Condition condition) {
  return std::all_of(values.begin(), values.end(), condition);
}

template <int D>
bool is_turn(const Rotation<D>& rotation) {
  const Tensor<D> turn = rotation.tensor();
  return (turn.transpose() * turn - Tensor<D>::Identity()).norm() <= 1e-6;
}

bool is_law(const SpringLaw& law) {
  return law.stiffness_kind >= StiffnessKind::per_contact && law.stiffness_kind <= StiffnessKind::potential &&
         is_positive(law.normal_stiffness) && is_from_zero(law.shear_stiffness) &&
         is_from_zero(law.tan_friction) && is_from_zero(law.cohesion) && is_from_zero(law.tensile_strength) &&
         is_from_zero(law.normal_damping) && is_from_zero(law.shear_damping);
}

bool is_elasticity(const Elasticity& elasticity) {
  return is_finite(elasticity.lame) && is_from_zero(elasticity.shear_modulus) &&
         is_from_zero(elasticity.damping_time);
}

template <int D>
bool are_settings(const WorldSettings<D>& settings) {
  const auto is_share = [](double value, double most) { return value >= 0 && value <= most; };
  return settings.gravity.allFinite() && is_from_zero(settings.time_step) && is_share(settings.safety, 1) &&
         is_share(settings.local_damping, 1) && is_from_zero(settings.mass_damping) &&
         is_share(settings.skin, 1) && is_from_zero(settings.potential_length) &&
         is_share(settings.detect.parallel_angle, 0.5) && is_share(settings.detect.vertex_zone, 0.5) &&
         (settings.fast_blocks == FastBlocks::divide || settings.fast_blocks == FastBlocks::refuse);
}

template <int D>
bool is_deformation(const Deformation<D>& deformation) {
  return is_positive(deformation.volume) && is_positive(deformation.least_moment) &&
         is_positive(deformation.yield) && deformation.gradient.allFinite() &&
         deformation.gradient.determinant() > 0 && deformation.rate.allFinite();
}

}  // namespace

bool LawTable::is_consistent() const {
  const std::size_t materials = std::size_t(material_count_);
  const auto names_a_law = [&](std::int32_t index) {
    return index >= -1 && index < std::int64_t(own_.size());
  };
  const auto is_known = [&](const SpringLaw& law) {
    return is_law(law) && (knows_potential_ || !law.is_potential());
  };
  return material_count_ >= 0 && law_of_pair_.size() == materials * (materials + 1) / 2 &&
         all(law_of_pair_, names_a_law) && is_known(default_) && all(own_, is_known);
}

template <int D>
bool Blocks<D>::is_consistent(std::int32_t material_count) const {
  const std::size_t slots = slot_count();
  const std::size_t sizes[] = {
      material.size(),  generation.size(),     position.size(), velocity.size(), force.size(),
      rotation.size(),  applied_force.size(),  spin.size(),     momentum.size(), torque.size(),
      mass.size(),      applied_torque.size(), inertia.size(),  radius.size(),   largest_face.size(),
      thickness.size(), outlines_.slot_count()};
  if (std::any_of(std::begin(sizes), std::end(sizes), [&](std::size_t size) { return size != slots; }))
    return false;
  if (angle.size() != (D == 2 ? slots : 0)) return false;
  Array<std::int32_t> living(kind.get_allocator().resource());
  for (std::size_t i = 0; i < slots; ++i) {
    if (kind[i] == BlockKind::none) continue;
    living.push_back(std::int32_t(i));
    if (kind[i] < BlockKind::fixed || kind[i] > BlockKind::affine) return false;
    if (material[i] < 0 || material[i] >= material_count) return false;
    const bool is_placed = position[i].allFinite() && is_turn<D>(rotation[i]);
    const bool moves = velocity[i].allFinite() && spin[i].allFinite() && momentum[i].allFinite();
    const bool is_driven = applied_force[i].allFinite() && applied_torque[i].allFinite();
    const bool resists = is_positive(mass[i]) && is_positive(inertia[i].least_moment());
    if (!(is_placed && moves && is_driven && resists)) return false;
    if (!is_positive(radius[i]) || !is_finite(thickness[i])) return false;
  }
  Array<std::uint8_t> is_taken(slots, 0, kind.get_allocator());
  const auto is_free = [&](std::int32_t slot) {
    return slot >= 0 && std::size_t(slot) < slots && !lives(std::size_t(slot)) &&
           !is_taken[std::size_t(slot)]++;
  };
  return std::int64_t(living.size()) == living_ && free_slots_.size() == slots - living.size() &&
         all(free_slots_, is_free) && outlines_.is_consistent(living) &&
         all(deformations_.all(), is_deformation<D>) &&
         deformations_.is_consistent(slots, [&](std::size_t slot) { return is_affine(slot); });
}

namespace {

bool is_below(std::int32_t index, std::int32_t count) { return index >= 0 && index < count; }

bool names_features(const PotentialPair<2>& pair, const Outline<2>& a, const Outline<2>& b) {
  if (pair.owner != 0 && pair.owner != 1) return false;
  return is_below(pair.edge, (pair.owner == 0 ? a : b).count) &&
         is_below(pair.vertex, (pair.owner == 0 ? b : a).count);
}

/// Two vertices may keep blocks apart, but no contact is described by them.
bool has_a_plane(const PotentialPair<2>&) { return true; }
bool has_a_plane(const PotentialPair<3>& pair) { return pair.kind != PotentialPair<3>::vertex_vertex; }

bool names_features(const PotentialPair<3>& pair, const Outline<3>& a, const Outline<3>& b) {
  using Pair = PotentialPair<3>;
  const Topology &of_a = *a.topology, &of_b = *b.topology;
  switch (pair.kind) {
    case Pair::face_vertex:
      return is_below(pair.a, of_a.face_count) && is_below(pair.b, of_b.vertex_count);
    case Pair::vertex_face:
      return is_below(pair.a, of_a.vertex_count) && is_below(pair.b, of_b.face_count);
    case Pair::edge_edge:
      return is_below(pair.a, of_a.edge_count) && is_below(pair.b, of_b.edge_count);
    case Pair::vertex_vertex:
      return is_below(pair.a, of_a.vertex_count) && is_below(pair.b, of_b.vertex_count);
  }
  return false;
}

bool knows_its_plan(const Candidate<2>&, const DivisionPlans&, const Outline<2>&, const Outline<2>&) {
  return true;
}
bool knows_its_plan(const Candidate<3>& pair, const DivisionPlans& plans, const Outline<3>& a,
                    const Outline<3>& b) {
  return !pair.plan.knows() || is_plan(plans[pair.plan], a, b);
}

}  // namespace

template <int D>
bool Candidates<D>::is_consistent(const Blocks<D>& blocks) const {
  const std::size_t slots = blocks.slot_count();
  const std::size_t listed = list_length();
  if (listed > slots || planned_.size() != listed || calm_motion_.size() != listed ||
      (!used_up_ && listed != slots))
    return false;
  if (reference_position_.size() != listed || reference_rotation_.size() != listed) return false;
  if (!shear_.empty() && shear_.size() != pairs_.size()) return false;
  if constexpr (D == 3) {
    if (!plans_.are_of(pairs_)) return false;
  }
  if (!reference_gradient_.empty() && reference_gradient_.size() > slots) return false;
  const auto lives = [&](std::int32_t slot) {
    return slot >= 0 && std::size_t(slot) < slots && blocks.lives(std::size_t(slot));
  };
  const auto follows = [](const Candidate<D>& p, const Candidate<D>& q) {
    return p.a > q.a || (p.a == q.a && p.b >= q.b);
  };
  if (std::adjacent_find(pairs_.begin(), pairs_.end(), follows) != pairs_.end()) return false;
  return all(pairs_, [&](const Candidate<D>& pair) {
    if (!lives(pair.a) || !lives(pair.b) || pair.a >= pair.b) return false;
    const PairMemory<D>& memory = pair.memory;
    constexpr auto last = D == 2 ? PairMemory<D>::touching : PairMemory<D>::overlapping;
    if (memory.state < PairMemory<D>::unknown || memory.state > last) return false;
    if (!knows_its_plan(pair, plans_, blocks.outline(pair.a), blocks.outline(pair.b))) return false;
    const bool separated = memory.state == PairMemory<D>::separated;
    return (separated || has_a_plane(memory.pair)) &&
           names_features(memory.pair, blocks.outline(pair.a), blocks.outline(pair.b));
  });
}

template <int D>
bool World<D>::is_consistent() const {
  if (!laws_.is_consistent() || laws_.material_count() != material_count()) return false;
  if (!are_settings(settings_) || !all(density_, is_positive) || !all(elasticity_, is_elasticity))
    return false;
  if (elasticity_.size() != density_.size()) return false;
  if (!blocks_.is_consistent(material_count()) || !candidates_.is_consistent(blocks_)) return false;
  const std::size_t slots = blocks_.slot_count();
  if ((detected_ || !edited_) && candidates_.list_length() != slots) return false;
  if (fresh_.size() > slots || (any_fresh_ && fresh_.size() != slots)) return false;
  if (!edited_ && (acceleration_.size() != slots || momentum_rate_.size() != slots)) return false;
  if (acceleration_.size() > slots || momentum_rate_.size() > slots) return false;
  if (!forces_.empty() && forces_.size() != touching_.size()) return false;
  constexpr std::int64_t most_steps = std::int64_t(1) << 62;
  if (!is_from_zero(time_step_) || !is_finite(epoch_time_) || !is_from_zero(fixed_length_)) return false;
  if (epoch_step_ < 0 || steps_ < epoch_step_ || steps_ > most_steps) return false;
  if (!is_from_zero(deepest_stop_) || !is_from_zero(peak_overlap_) || !is_from_zero(peak_speed_))
    return false;
  if (divided_steps_ < 0 || divided_steps_ > steps_ + 1) return false;
  if (!(passed_ >= 0 && passed_ <= time_step_)) return false;
  const auto wants_spring = [&](const Candidate<D>& pair) { return law_of(pair).resists_shear(); };
  const bool is_list_in_use = detected_ || !candidates_.used_up();
  if (is_list_in_use && !candidates_.has_springs() &&
      std::any_of(candidates_.pairs().begin(), candidates_.pairs().end(), wants_spring))
    return false;
  const auto names_a_pair = [&](std::uint32_t candidate) {
    const Array<Candidate<D>>& pairs = candidates_.pairs();
    return candidate < pairs.size() && has_a_plane(pairs[candidate].memory.pair);
  };
  return all(touching_, names_a_pair);
}

template bool Blocks<2>::is_consistent(std::int32_t) const;
template bool Blocks<3>::is_consistent(std::int32_t) const;
template bool Candidates<2>::is_consistent(const Blocks<2>&) const;
template bool Candidates<3>::is_consistent(const Blocks<3>&) const;
template bool World<2>::is_consistent() const;
template bool World<3>::is_consistent() const;

}  // namespace halfspace
