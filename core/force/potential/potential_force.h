#pragma once

#include <algorithm>

#include "force/potential/space/near_faces.h"
#include "geometry/outline.h"
#include "geometry/polyhedron/clipped.h"

namespace halfspace {

/// The force between the potentials of two overlapping blocks, for k_n / H = 1 (Zheng et al. 2020, section
/// 3).
template <int D>
struct PotentialForce {
  Vector<D> force = Vector<D>::Zero();  // on b, opposite on a
  // Force times arm^T from the block's own centroid, summed over the forces on it: gives moment and strain.
  Tensor<D> virial_a = Tensor<D>::Zero();
  Tensor<D> virial_b = Tensor<D>::Zero();
  Vector<D> centroid = Vector<D>::Zero();  // of the overlap, relative to that of a
  double content = 0;                      // area or volume of the overlap
  double energy = 0;                       // the force is its negative gradient
  // Mean of r r^T about that centroid: wide contacts resist tilting and twisting.
  Tensor<D> spread = Tensor<D>::Zero();
};

/// Working memory. After growth to the largest blocks it allocates nothing.
template <int D>
struct PotentialRoom;

template <>
struct PotentialRoom<2> {
  explicit PotentialRoom(Memory* memory)
      : min_depth(memory), near_a(memory), near_b(memory), corners(memory) {}

  /// Reserves for two blocks of up to `edges` edges.
  void reserve(std::size_t edges) {
    if (near_a.size() >= edges) return;
    corners.resize(3 * polygon_room(edges), Vector<2>::Zero());
    min_depth.resize(edges + 1);  // they are computed in pairs
    near_b.resize(edges);
    near_a.resize(edges);
  }
  /// The first (second, third) working polygon.
  Vector<2>* polygon(int which) { return corners.data() + std::size_t(which) * max_corners(); }
  std::size_t max_corners() const { return polygon_room(near_a.size()); }

  Array<double> min_depth;     // of the other block's vertices, behind each edge
  Array<std::int32_t> near_a;  // edges of a that can be the nearest to some point of b
  Array<std::int32_t> near_b;
  Array<Vector<2>> corners;

 private:
  /// The corners of both blocks, one more per cut, and as many for rounding.
  static std::size_t polygon_room(std::size_t edges) { return 6 * edges; }
};

template <>
struct PotentialRoom<3> {
  explicit PotentialRoom(Memory* memory)
      : min_depth(memory),
        near(memory),
        sounding_of_a(memory),
        sounding_of_b(memory),
        intersection(memory),
        cell(memory) {}

  /// Reserves for two blocks of up to `edges` edges. Grows later where the overlap has very many vertices. A
  /// block has at most 2/3 as many faces as edges.
  void reserve(std::size_t edges) {
    const std::size_t faces = edges, max_vertices = 256 + 8 * edges;
    min_depth.resize(std::max(min_depth.size(), faces));
    near.reserve(faces, max_vertices);
    sounding_of_a.reserve(edges);
    sounding_of_b.reserve(edges);
    intersection.reserve(edges, max_vertices);
    cell.reserve(edges, max_vertices);
  }

  Array<double> min_depth;  // lower bound, of the intersection behind each face
  NearFaces near;           // of one block at a time
  VertexDepths sounding_of_a;
  VertexDepths sounding_of_b;
  ClippedPolyhedron intersection;
  ClippedPolyhedron cell;
};

/// The potential of a point inside a block is its distance to the nearest edge. The paper integrates the
/// potential over the boundary of the intersection, piece by piece between demarcation points. By the
/// divergence theorem this is the integral of its gradient over the intersection, and the gradient is
/// constant where one edge is the nearest: area times normal, per cell. The energy is area times depth at the
/// cells' centroids. The cost grows with the product of the numbers of edges; cells are few, only those of
/// edges that the other block reaches.
///
/// Force and virials are the gradient of the energy for any affine motion of either block.
PotentialForce<2> potential_force(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                                  PotentialRoom<2>& room);

/// In 3D the cells are volumes.
PotentialForce<3> potential_force(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                                  PotentialRoom<3>& room);

}  // namespace halfspace
