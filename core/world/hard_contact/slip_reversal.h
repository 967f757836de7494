#pragma once

#include "simd/four_lanes.h"

namespace halfspace {

/// Numbers are doubles or lanes.
inline double select_less(double a, double b, double then, double otherwise) {
  return a < b ? then : otherwise;
}

/// No reversal: see below.
constexpr double no_reversal = 2;

/// Slip that is reversed within half a step has friction of one sign before it stops and of the other sign
/// afterwards: friction that opposed the slip at the end alone would come too early, and be of first order.
/// At constant acceleration the slip stops after the fraction s = slip / (strength - change) of the time, and
/// the mean friction along the slip at the beginning is 1 - 2 s times its bound, which is returned.
///
/// `slip`: the velocity at the beginning, >= 0. `change`: of the velocity along it without friction; less
/// than 0 against it. `strength`: the change by the whole friction. Returns no_reversal where slip goes on,
/// or stops and stays.
template <class Number>
[[gnu::always_inline]] inline Number reversed_friction(const Number& slip, const Number& change,
                                                       const Number& strength, const Number& none,
                                                       const Number& one) {
  const Number stopping_time = slip / (strength - change), no = (one + one);
  const Number mean = one - (stopping_time + stopping_time);
  const Number before_end = select_less(stopping_time, one, mean, no);
  return select_less(none, slip, select_less(strength, none - change, before_end, no), no);
}

}  // namespace halfspace
