#pragma once

#include <cstdint>

#include "geometry/vector.h"

namespace halfspace {

class GaussMap;

/// A convex shape as detection reads it: arrays of components, relative to the centroid, in the present
/// orientation.
template <int D>
struct Outline;

/// Vertex i, and half-space i of the edge from vertex i to vertex i + 1: inside is nx*x + ny*y <= offset. The
/// arrays are contiguous in this order, each padded to an even count with its last entry, so that entries can
/// be read in pairs.
template <>
struct Outline<2> {
  int count = 0;
  const double* x = nullptr;
  const double* y = nullptr;
  const double* nx = nullptr;
  const double* ny = nullptr;
  const double* offset = nullptr;

  int vertex_count() const { return count; }
  int edge_count() const { return count; }
  int face_count() const { return count; }
  Vector<2> vertex(int i) const { return {x[i], y[i]}; }
  Vector<2> normal(int i) const { return {nx[i], ny[i]}; }
  // Without branches, as they would be unpredictable.
  int next(int i) const { return (i + 1) & -int(i + 1 < count); }
  int previous(int i) const { return i - 1 + (count & -int(i == 0)); }
  static constexpr int padded(int count) { return count + (count & 1); }
};

/// The topology of a polyhedron: vertices, edges and faces without coordinates, so that all blocks of one
/// shape share it.
///
/// List i of a list of lists is entries first[i] to first[i + 1], the latter excluded.
struct Topology {
  std::int32_t vertex_count = 0;
  std::int32_t edge_count = 0;
  std::int32_t face_count = 0;

  /// Per face, counter-clockwise seen from outside: its vertices, and the edge from each to the next.
  const std::int32_t* first_of_face = nullptr;  // face_count + 1
  const std::int32_t* face_vertex = nullptr;    // 2 edge_count
  const std::int32_t* face_edge = nullptr;      // 2 edge_count

  /// Edge e goes from edge_start to edge_end, counter-clockwise along edge_left and clockwise along
  /// edge_right: seen from outside with edge_end ahead, edge_left is on the left.
  const std::int32_t* edge_start = nullptr;  // edge_count each
  const std::int32_t* edge_end = nullptr;
  const std::int32_t* edge_left = nullptr;
  const std::int32_t* edge_right = nullptr;

  /// Per vertex, counter-clockwise seen from outside: its neighbours, the edge to each, and the face between
  /// each and the next.
  const std::int32_t* first_of_vertex = nullptr;   // vertex_count + 1
  const std::int32_t* vertex_neighbour = nullptr;  // 2 edge_count each
  const std::int32_t* vertex_edge = nullptr;
  const std::int32_t* vertex_face = nullptr;
};

/// Vertex i, and half-space f of face f: inside is nx*x + ny*y + nz*z <= offset. The arrays are padded to a
/// multiple of four with the last entry, so that two or four entries can be read at a time.
template <>
struct Outline<3> {
  const Topology* topology = nullptr;
  const double* x = nullptr;
  const double* y = nullptr;
  const double* z = nullptr;
  const double* nx = nullptr;
  const double* ny = nullptr;
  const double* nz = nullptr;
  const double* offset = nullptr;
  /// Only shapes with many vertices have one, in the orientation of the shape; otherwise null.
  const GaussMap* gauss_map = nullptr;

  int vertex_count() const { return topology->vertex_count; }
  int edge_count() const { return topology->edge_count; }
  int face_count() const { return topology->face_count; }
  Vector<3> vertex(int i) const { return {x[i], y[i], z[i]}; }
  Vector<3> normal(int f) const { return {nx[f], ny[f], nz[f]}; }
  static constexpr int padded(int count) { return (count + 3) & ~3; }
};

}  // namespace halfspace
