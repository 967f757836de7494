#pragma once

#include <algorithm>

#include "force/potential/space/cell_division.h"
#include "force/potential/space/division_plan.h"
#include "force/potential/space/division_record.h"
#include "geometry/outline.h"
#include "geometry/polyhedron/division.h"

namespace halfspace {

/// The force between the potentials of two overlapping blocks, for k_n / H = 1 (Zheng et al. 2020, section
/// 3).
template <int D>
struct PotentialForce {
  Vector<D> force = Vector<D>::Zero();  // on b, opposite on a
  // Force times arm^T from the block's own centroid, summed over the forces on it: its moment, and how it is
  // strained.
  Tensor<D> virial_a = Tensor<D>::Zero();
  Tensor<D> virial_b = Tensor<D>::Zero();
  Vector<D> centroid = Vector<D>::Zero();  // of what the blocks have in common; relative to that of a
  double content = 0;                      // area or volume of it
  double energy = 0;                       // falls along the force: that is its gradient
  // Mean of the way from that centroid times itself^T: a contact that spreads resists tilting and twisting.
  Tensor<D> spread = Tensor<D>::Zero();
};

/// Room to work in. Once it has grown to the largest blocks it asks for no more memory.
template <int D>
struct PotentialRoom;

template <>
struct PotentialRoom<2> {
  explicit PotentialRoom(Memory* memory)
      : least_depth(memory), near_a(memory), near_b(memory), corners(memory) {}

  /// Takes the room that two blocks of so many edges at most need.
  void reserve(std::size_t edges) {
    if (near_a.size() >= edges) return;
    corners.resize(3 * polygon_room(edges), Vector<2>::Zero());
    least_depth.resize(edges + 1);  // they are found in pairs
    near_b.resize(edges);
    near_a.resize(edges);
  }
  /// The first (second, third) polygon to work on.
  Vector<2>* polygon(int which) { return corners.data() + std::size_t(which) * max_corners(); }
  std::size_t max_corners() const { return polygon_room(near_a.size()); }

  Array<double> least_depth;   // of the other block's vertices, behind each edge
  Array<std::int32_t> near_a;  // edges of a that can be the nearest one to some point of b
  Array<std::int32_t> near_b;
  Array<Vector<2>> corners;

 private:
  /// The corners of both blocks, one more for each cut, and as many that rounding may add.
  static std::size_t polygon_room(std::size_t edges) { return 6 * edges; }
};

template <>
struct PotentialRoom<3> {
  explicit PotentialRoom(Memory* memory)
      : least_depth(memory),
        near_a(memory),
        near_b(memory),
        sounding_of_a(memory),
        sounding_of_b(memory),
        vertices(memory),
        intersection(memory),
        cells(memory),
        record(memory),
        plan(memory) {}

  /// Takes the room that two blocks of so many edges at most need, unless more than 32 faces are the nearest
  /// in what they share, or it has very many vertices for them: then the room grows with them, and stays. A
  /// block has at most 2/3 as many faces as edges.
  void reserve(std::size_t edges) {
    const std::size_t faces = edges, vertices_of_parts = 256 + 8 * edges;
    least_depth.resize(std::max(least_depth.size(), faces));
    near_a.reserve(faces);
    near_b.reserve(faces);
    sounding_of_a.reserve(edges);
    sounding_of_b.reserve(edges);
    vertices.reserve(vertices_of_parts);
    intersection.reserve(edges, vertices_of_parts);
    cells.reserve(edges, vertices_of_parts, std::min<std::size_t>(faces, 32));
    record.reserve(edges);
    plan.reserve(most_plan_codes);
  }

  Array<double> least_depth;  // of the intersection behind each face, or less
  Array<NearFace> near_a;     // can be the nearest one to some point of the intersection
  Array<NearFace> near_b;
  VertexDepths sounding_of_a;
  VertexDepths sounding_of_b;
  Array<DividedPolyhedron::Index> vertices;  // of the intersection
  DividedPolyhedron intersection;
  CellDivision cells;
  DivisionRecord record;
  Array<PlanCode> plan;
};

/// A point inside a block has its distance to the nearest edge as potential; what two blocks have in common
/// is pushed down both. The paper integrates the potential over the outline of the intersection, piece by
/// piece between demarcation points. By the divergence theorem that is the integral of its gradient over the
/// intersection, and the gradient is constant where one edge is the nearest: area times normal, cell by cell.
/// The energy is area times depth at the cells' centroids. Cost grows with the product of the numbers of
/// edges; of cells there are but the few whose edges the other block reaches.
///
/// Force and virials are the gradient of the energy by any affine motion of either block.
PotentialForce<2> potential_force(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                                  PotentialRoom<2>& room);

/// In space the cells are volumes. How they are found is written down where there is a record.
PotentialForce<3> potential_force(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                                  PotentialRoom<3>& room, DivisionRecord* record = nullptr);

}  // namespace halfspace
