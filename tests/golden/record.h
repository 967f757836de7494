#pragma once

// All that a run shows, in one number: any bit of any pose, contact, force or energy that differs makes it
// another.

#include <cstring>

#include "capi/world_fixture.h"

namespace halfspace_test {

/// FNV-1a of 64 bits.
class Hash {
 public:
  void operator()(std::int64_t value) { bits(std::uint64_t(value)); }
  void operator()(std::uint64_t value) { bits(value); }
  void operator()(std::int32_t value) { bits(std::uint64_t(std::int64_t(value))); }
  void operator()(double value) {
    std::uint64_t of_value;
    std::memcpy(&of_value, &value, sizeof of_value);
    bits(of_value);
  }
  template <class T, std::size_t Count>
  void operator()(const T (&values)[Count]) {
    first(values, Count);
  }
  /// The first so many of an array; no more of it is meant.
  template <class T>
  void first(const T values[], std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) (*this)(values[i]);
  }
  template <class... Values>
  void all(const Values&... values) {
    ((*this)(values), ...);
  }

  std::uint64_t value() const { return value_; }

 private:
  void bits(std::uint64_t of_value) {
    for (int shift = 0; shift < 64; shift += 8) {
      value_ ^= of_value >> shift & 0xff;
      value_ *= 0x100000001b3;
    }
  }

  std::uint64_t value_ = 0xcbf29ce484222325;
};

inline void record(Hash& hash, const hs_block_state& state) {
  hash.all(state.kind, state.pose.position, state.pose.rotation, state.angle, state.velocity,
           state.angular_velocity, state.force, state.torque, state.mass);
}

inline void record(Hash& hash, const hs_deformation& d) {
  hash.all(d.gradient, d.rate, d.strain, d.stress, d.strain_energy);
}

/// The answer of detection about a pair.
inline void record_detected(Hash& hash, const hs_contact& c) {
  hash.all(c.type, c.pair_kind, c.feature_a, c.feature_b, c.normal, c.gap);
  if (c.point_count == 0) return;
  hash.all(c.point_count, c.area, c.length, c.center, c.center_gap);
  hash.first(c.points, std::size_t(c.point_count));
  hash.first(c.gaps, std::size_t(c.point_count));
}

inline void record(Hash& hash, const hs_contact& c) {
  hash.all(c.block_a, c.block_b);
  record_detected(hash, c);
  hash.all(c.force, c.torque, c.force_point, c.normal_force, c.shear_force, c.twist);
}

inline void record(Hash& hash, const hs_world_report& r) {
  hash.all(r.steps, r.time, r.time_step, r.stable_time_step, r.block_count, r.contact_count,
           r.largest_overlap, r.largest_speed, r.potential_length, r.block_strain_energy,
           r.block_damping_loss, r.divided_steps, r.max_penetration_ratio);
  const hs_energy& e = r.energy;
  hash.all(e.kinetic, e.gravity, e.strain, e.friction_loss, e.contact_damping_loss, e.local_damping_loss,
           e.mass_damping_loss, e.outer_work, e.residual);
}

inline void record(Hash& hash, const hs_impact& i) {
  hash.all(i.state, i.pair_kind, i.feature_a, i.feature_b, i.time, i.gap, i.normal, i.point);
}

/// Every block, every contact, and the report.
inline void record(Hash& hash, hs_world* world, const std::vector<hs_block>& blocks) {
  for (const hs_block block : blocks) {
    record(hash, state_of(world, block));
    record(hash, deformation_of(world, block));
  }
  for (const hs_contact& contact : contacts_of(world)) record(hash, contact);
  record(hash, report_of(world));
}

}  // namespace halfspace_test
