#pragma once

#include <cstdint>

namespace halfspace {

/// Strength reduction: the factor of safety is the number by which all strengths can be divided before blocks
/// move (Zienkiewicz, Humpheson and Lewis 1975).
struct StrengthSearch {
  double low = 0.5;
  double high = 5;
  double resolution = 0.005;
};

/// The world stands at `low` and fails at `high`, unless these are the given limits.
struct StrengthFound {
  double low = 0;
  double high = 0;
  bool stands_at_low = false;
  bool falls_at_high = false;
  std::int32_t trials = 0;
};

/// Bisects between two factors. stands_at(factor) runs a trial, each time from the same initial state.
template <class StandsAt>
StrengthFound find_strength_factor(const StrengthSearch& search, StandsAt stands_at) {
  StrengthFound found{search.low, search.high};
  const auto tried = [&](double factor) {
    ++found.trials;
    return stands_at(factor);
  };
  found.stands_at_low = tried(found.low);
  if (!found.stands_at_low) return found;
  found.falls_at_high = !tried(found.high);
  while (found.falls_at_high && found.high - found.low > search.resolution) {
    const double middle = 0.5 * (found.low + found.high);
    if (middle <= found.low || middle >= found.high) break;  // no number lies between them
    (tried(middle) ? found.low : found.high) = middle;
  }
  return found;
}

}  // namespace halfspace
