#pragma once

#include "simd/four_lanes.h"

namespace halfspace {

/// What a reversal of slip needs of a friction row. Numbers are doubles or lanes.
template <class Number>
struct SlippingRow {
  Number part;  // of the slip at the beginning of the half step, over its size
  Number inverse_mass;
  Number impulse;
  Number excess;  // velocity beyond its target
};

/// The mean friction along the slip at the beginning, over its bound, of a half step in which slip is
/// reversed; 2 where it goes on, or stops and stays. Friction has one sign before the slip stops and the
/// other afterwards: friction that opposed the slip at the end alone would come too early, and be of first
/// order. At constant acceleration the slip stops after the fraction s = slip / (strength - change) of the
/// time, and the mean is 1 - 2 s.
///
/// `slip`: the velocity at the beginning, >= 0. `change`: of the velocity along it without friction; less
/// than 0 against it. `strength`: the change by the whole friction.
template <class Number>
[[gnu::always_inline]] inline Number mean_of_reversed(const Number& slip, const Number& change,
                                                      const Number& strength, const Number& none,
                                                      const Number& one) {
  const Number stopping_time = slip / (strength - change), no_reversal = one + one;
  const Number mean = one - (stopping_time + stopping_time);
  const Number before_end = select_less(stopping_time, one, mean, no_reversal);
  return select_less(none, slip, select_less(strength, none - change, before_end, no_reversal), no_reversal);
}

/// Replaces the impulses that would stop each friction row of a contact by those of a slip that is reversed,
/// where it is; returns 1 there, else 0. Friction then moves both blocks along the slip without a turn, since
/// their normal impulses follow. `slip`: its size. `row_of(k)`: a SlippingRow. `of_translation`: the sum of
/// the inverse masses.
template <class Number, class RowOf>
[[gnu::always_inline]] inline Number reverse_slip(int count, const Number& slip, RowOf row_of,
                                                  const Number& of_translation, const Number& bound,
                                                  Number* impulse, const Number& none, const Number& one,
                                                  const Number& least) {
  Number inverse_mass = none, velocity = none, along = none, replaced = none, size = none;
  for (int k = 0; k < count; ++k) {
    const SlippingRow<Number> row = row_of(k);
    inverse_mass = inverse_mass + row.part * row.part * row.inverse_mass;
    velocity = velocity + row.part * row.excess;
    along = along + row.part * row.impulse;
    replaced = replaced + row.part * impulse[k];
  }
  const Number mean = mean_of_reversed<Number>(slip, velocity - of_translation * along - slip,
                                               bound * of_translation, none, one);
  const Number next = along + (mean * bound - along) * of_translation / max(inverse_mass, least);
  for (int k = 0; k < count; ++k) {
    impulse[k] = impulse[k] + select_less(mean, one, (next - replaced) * row_of(k).part, none);
    size = size + impulse[k] * impulse[k];
  }
  const Number scale = select_less(mean, one, min(one, max(none, bound) / max(sqrt(size), least)), one);
  for (int k = 0; k < count; ++k) impulse[k] = impulse[k] * scale;
  return select_less(mean, one, one, none);
}

}  // namespace halfspace
