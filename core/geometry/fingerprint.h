#pragma once

#include <bit>
#include <cstdint>

#include "geometry/outline.h"

namespace halfspace {

/// A hash that identifies a shape, the same in every process. Odd.
class Fingerprint {
 public:
  void mix(std::uint64_t bits) {
    hash_ = (hash_ ^ bits) * 0x9e3779b97f4a7c15;  // 2^64 / golden ratio
    hash_ ^= hash_ >> 32;
  }
  void mix(const double* values, int count) {
    for (int i = 0; i < count; ++i) mix(std::bit_cast<std::uint64_t>(values[i]));
  }
  std::uint64_t value() const { return hash_ | 1; }

 private:
  std::uint64_t hash_ = 0;
};

inline std::uint64_t fingerprint_of(const Outline<2>& outline) {
  Fingerprint fingerprint;
  for (const double* component : {outline.x, outline.y}) fingerprint.mix(component, outline.count);
  return fingerprint.value();
}

/// With the loops of the faces, as pair caches refer to face indices.
inline std::uint64_t fingerprint_of(const Outline<3>& outline) {
  Fingerprint fingerprint;
  for (const double* component : {outline.x, outline.y, outline.z})
    fingerprint.mix(component, outline.vertex_count());
  const Topology& topology = *outline.topology;
  for (int k = 0; k < 2 * topology.edge_count; ++k) fingerprint.mix(std::uint64_t(topology.face_vertex[k]));
  return fingerprint.value();
}

}  // namespace halfspace
