#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "block/blocks.h"
#include "geometry/tolerances.h"
#include "world/hard_contact/impulse_problem.h"

namespace halfspace {

/// Two blocks in contact, and the size of the force between them.
struct PressedPair {
  std::int32_t a = -1;
  std::int32_t b = -1;
  double force = 0;  // N

  void note(std::int32_t one, std::int32_t other, double size) {
    if (size > force) *this = {one, other, size};
  }
};

/// A prescribed block that presses others against blocks that do not yield. The pair has the largest force.
struct Jam {
  std::int32_t block = -1;
  PressedPair pair;
};

/// Enough sweeps for the impulses of a suspected jam to grow to those of one.
constexpr int sweeps_of_suspect = 1000;

/// Finds the jam in the impulses of a solver that has not converged. The problem's motions contain them. No
/// impulses keep the gaps of a jam open: those of a solver grow against each other, with little effect on any
/// block, and the work that they still lack becomes any multiple of the energy of the changes that they make.
/// `free(i)`: the motion of a block without impulses. `duration`: over which the impulses act, s. `ratio`: of
/// lacking work to energy.
template <int D, class Free>
std::optional<Jam> find_jam(ImpulseProblem<D>& problem, const Blocks<D>& blocks, Free free, double duration,
                            double ratio) {
  const auto given = [&](std::int32_t block) {
    const bool is_prescribed = blocks.kind[std::size_t(block)] == BlockKind::prescribed;
    return is_prescribed ? free(std::size_t(block)) : BlockMotion<D>();
  };
  const auto is_driven = [](const BlockMotion<D>& motion) {
    return !motion.velocity.isZero(0) || !motion.spin.isZero(0);
  };
  if (std::none_of(blocks.kind.begin(), blocks.kind.end(),
                   [](BlockKind kind) { return kind == BlockKind::prescribed; }))
    return {};
  Jam jam;
  double lacking = 0, made = 0, driven = 0, driven_size = 0, largest_impulse = 0;
  for (const ImpulseContact<D>& contact : problem.contacts) {
    const BlockMotion<D> a = free(std::size_t(contact.a)), b = free(std::size_t(contact.b));
    const BlockMotion<D> given_a = given(contact.a), given_b = given(contact.b);
    double impulse = 0;
    for (const ImpulseRow<D>& row : problem.rows_of(contact))
      made += row.impulse * (problem.velocity_along(contact, row) - row.velocity(a, b));
    for (const ImpulseRow<D>& row : problem.normals_of(contact)) {
      if (row.impulse == 0) continue;  // it may have no target
      impulse += row.impulse;
      lacking += row.impulse * (row.target - problem.velocity_along(contact, row));
      const double driven_by_row = -row.impulse * row.velocity(given_a, given_b);
      driven += driven_by_row;
      driven_size += std::abs(driven_by_row);
    }
    jam.pair.note(contact.a, contact.b, impulse / duration);
    const bool drives_a = is_driven(given_a);
    if (!(drives_a || is_driven(given_b)) || !(impulse > largest_impulse)) continue;
    largest_impulse = impulse;
    jam.block = drives_a ? contact.a : contact.b;
  }
  const bool is_jam = lacking > ratio * made && driven > jamming_work_fraction * driven_size;
  return is_jam ? std::optional(jam) : std::nullopt;
}

}  // namespace halfspace
