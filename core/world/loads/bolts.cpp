#include "world/loads/bolts.h"

#include <algorithm>
#include <cmath>

#include "geometry/finite.h"
#include "geometry/numbers.h"

namespace halfspace {
namespace {

template <int D>
bool is_end(const Blocks<D>& blocks, std::int32_t slot) {
  return slot == -1 ||
         (slot >= 0 && std::size_t(slot) < blocks.slot_count() && blocks.lives(std::size_t(slot)));
}

bool is_flag(std::int32_t value) { return value == 0 || value == 1; }

template <int D>
bool is_sound(const Bolt<D>& bolt) {
  return is_flag(bolt.is_tension_only) && is_flag(bolt.is_ruptured) && all_finite(bolt.on_a) &&
         all_finite(bolt.on_b) && is_positive(bolt.stiffness) && is_finite(bolt.unstressed_length) &&
         is_nonnegative(bolt.yield_force) && is_nonnegative(bolt.rupture_elongation) &&
         is_finite(bolt.plastic_elongation) && is_finite(bolt.elongation) && is_finite(bolt.tension) &&
         is_nonnegative(bolt.dissipated);
}

}  // namespace

template <int D>
std::int64_t Bolts<D>::add(const Bolt<D>& bolt) {
  bolts_.push_back(bolt);
  bolts_.back().number = next_number_;
  return next_number_++;
}

template <int D>
std::optional<std::size_t> Bolts<D>::index_of(std::int64_t number) const {
  const auto at = std::partition_point(bolts_.begin(), bolts_.end(),
                                       [=](const Bolt<D>& bolt) { return bolt.number < number; });
  if (at == bolts_.end() || at->number != number) return std::nullopt;
  return std::size_t(at - bolts_.begin());
}

template <int D>
bool Bolts<D>::is_consistent(const Blocks<D>& blocks) const {
  std::int64_t before = -1;
  for (const Bolt<D>& bolt : bolts_) {
    if (bolt.number <= before || !is_end(blocks, bolt.a) || !is_end(blocks, bolt.b) || bolt.a == bolt.b ||
        !is_sound(bolt))
      return false;
    before = bolt.number;
  }
  return before < next_number_;
}

/// Ideal plasticity. A bolt that ruptures within a motion has been stretched up to its limit before.
template <int D>
void stretch(Bolt<D>& bolt, double elongation, bool are_held) {
  bolt.elongation = elongation;
  if (bolt.is_ruptured) return;
  const double limit = bolt.rupture_elongation, yield = bolt.yield_force;
  const bool ruptures = !are_held && limit > 0 && elongation > limit;
  bolt.tension = bolt.stiffness * ((ruptures ? limit : elongation) - bolt.plastic_elongation);
  if (bolt.is_tension_only) bolt.tension = std::max(bolt.tension, 0.0);
  const double excess = std::abs(bolt.tension) - yield;
  if (!are_held && yield > 0 && excess > 0) {
    bolt.plastic_elongation += std::copysign(excess / bolt.stiffness, bolt.tension);
    bolt.dissipated += yield * excess / bolt.stiffness;
    bolt.tension = std::copysign(yield, bolt.tension);
  }
  if (!ruptures) return;
  bolt.dissipated += bolt.strain_energy();
  bolt.tension = 0;
  bolt.is_ruptured = 1;
}

/// Along the line it is that of the bolt, across it the tension over the length.
template <int D>
double stiffness_of(const Blocks<D>& blocks, const Bolt<D>& bolt) {
  if (bolt.is_ruptured) return 0;
  const BoltEnds<D> ends(blocks, bolt);
  const double length = (ends.b - ends.a).norm();
  return length > 0 ? std::max(bolt.stiffness, std::abs(bolt.tension) / length) : bolt.stiffness;
}

template class Bolts<2>;
template class Bolts<3>;
template void stretch(Bolt<2>&, double, bool);
template void stretch(Bolt<3>&, double, bool);
template double stiffness_of(const Blocks<2>&, const Bolt<2>&);
template double stiffness_of(const Blocks<3>&, const Bolt<3>&);

}  // namespace halfspace
