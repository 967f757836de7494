#pragma once

#include <array>
#include <cstdint>

#include "block/mesh/meshes.h"
#include "geometry/vector.h"

namespace halfspace {

/// The body of an added mesh, or the fault of the mesh.
struct PlacedMesh {
  MeshFaultReport report;
  std::int32_t body = -1;
};

/// Two parts of a compound that overlap; depth 0: none do.
struct PartOverlap {
  std::int32_t a = -1;
  std::int32_t b = -1;
  double depth = 0;  // m
};

/// An added compound, unless its parts overlap.
struct PlacedCompound {
  PartOverlap overlap;
  std::int32_t block = -1;
};

/// A stress that is linear in position.
template <int D>
struct StressField {
  Tensor<D> at(const Vector<D>& place) const {
    Tensor<D> stress = at_origin;
    for (int k = 0; k < D; ++k) stress += place[k] * gradient[std::size_t(k)];
    return stress;
  }
  Tensor<D> at_origin;
  std::array<Tensor<D>, D> gradient;  // along each axis
};

}  // namespace halfspace
