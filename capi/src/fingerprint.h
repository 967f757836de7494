#pragma once

#include <bit>
#include <cstdint>

#include "geometry/outline.h"

namespace halfspace::capi {

/// A number that tells shapes apart, the same in every process. Odd.
inline std::uint64_t fingerprint_of(const Outline<2>& outline) {
  std::uint64_t hash = std::uint64_t(outline.count);
  const auto mix = [&](double value) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15;  // 2^64 / golden ratio
    hash ^= hash >> 32;
  };
  for (int i = 0; i < outline.count; ++i) {
    mix(outline.x[i]);
    mix(outline.y[i]);
  }
  return hash | 1;
}

}  // namespace halfspace::capi
