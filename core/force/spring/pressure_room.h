#pragma once

#include <cstdint>

#include "force/spring/pressure.h"

namespace halfspace {

/// A face of a block as the surface of a fluid, which the block is.
template <int D>
struct PressureFace {
  Vector<D> normal = Vector<D>::Zero();
  double offset = 0;
  double flush = 0;  // a smaller distance counts as none
  int block = 0;     // 0 a, 1 b
  int face = -1;     // of that block

  double depth(const Vector<D>& p) const { return offset - normal.dot(p); }
  bool is_same(const PressureFace& other) const { return block == other.block && face == other.face; }
};

/// A corner of the overlap in the plane, and the side that starts there.
struct OverlapCorner {
  Vector<2> at;      // relative to the centroid of a
  Vector<2> normal;  // of the side, out of the overlap
  int block;         // that the side belongs to: 0 a, 1 b
  int face;          // of that block
  double flush;      // a smaller distance from another side counts as none
  bool is_shared;    // the side lies on one of the other block, too
};

template <>
struct PressureRoom<2> {
  explicit PressureRoom(Memory* memory) : overlap(memory), clipped(memory) {}

  /// Reserves for two blocks of up to `edges` edges.
  void reserve(std::size_t edges) {
    overlap.reserve(2 * edges);
    clipped.reserve(2 * edges);
  }

  Array<OverlapCorner> overlap;
  Array<OverlapCorner> clipped;
};

/// A face of the overlap in space: its corners in the room, counter-clockwise seen from outside.
struct OverlapFace {
  Vector<3> normal;  // out of the overlap
  int block;         // that the face belongs to: 0 a, 1 b
  int face;          // of that block
  double flush;      // a smaller distance from another face counts as none
  bool is_shared;    // the face lies on one of the other block, too
  std::int32_t first;
  std::int32_t end;
};

/// A convex polyhedron as its faces.
struct OverlapBody {
  explicit OverlapBody(Memory* memory) : faces(memory), corners(memory) {}

  void clear() {
    faces.clear();
    corners.clear();
  }

  Array<OverlapFace> faces;
  Array<Vector<3>> corners;  // relative to the centroid of a
};

/// A vertex of a block, and its depth below the first face.
struct PlacedVertex {
  Vector<3> at;
  double depth;
};

/// An edge of the face that a cut leaves.
struct RimEdge {
  Vector<3> start;
  Vector<3> end;
};

template <>
struct PressureRoom<3> {
  explicit PressureRoom(Memory* memory)
      : overlap(memory), clipped(memory), rim(memory), vertices(memory), is_below(memory) {}

  /// Reserves for two blocks of up to `edges` edges. The overlap is convex: with the faces of both blocks, at
  /// most two thirds of their edges, it has at most three times as many edges, each a side of two faces.
  void reserve(std::size_t edges) {
    for (OverlapBody* body : {&overlap, &clipped}) {
      body->faces.reserve(2 * edges);
      body->corners.reserve(8 * edges);
    }
    rim.reserve(2 * edges);
    vertices.reserve(edges);
    is_below.reserve(edges);
  }

  OverlapBody overlap;
  OverlapBody clipped;
  Array<RimEdge> rim;
  Array<PlacedVertex> vertices;  // of a block
  Array<std::uint8_t> is_below;  // per face of it: has it a vertex below the first face?
};

}  // namespace halfspace
