#pragma once

#include "geometry/outline.h"
#include "geometry/polyhedron/polyhedron.h"

namespace halfspace {

/// The half of an edge in one face's loop, from a corner to the next; its twin is in the neighbouring face.
/// Half-edge h starts at corner h of Polyhedron::face_vertices.
class HalfEdges {
 public:
  /// All vertices of the loops must exist.
  explicit HalfEdges(const Polyhedron& polyhedron);

  std::int32_t count() const { return std::int32_t(face_.size()); }
  std::int32_t face(std::int32_t h) const { return face_[std::size_t(h)]; }
  std::int32_t next(std::int32_t h) const;
  std::int32_t previous(std::int32_t h) const;
  std::int32_t start(std::int32_t h) const { return polyhedron_.face_vertices[std::size_t(h)]; }
  std::int32_t end(std::int32_t h) const { return start(next(h)); }
  /// The half-edge in the opposite direction; -1 unless there is exactly one in each direction.
  std::int32_t twin(std::int32_t h) const { return twin_[std::size_t(h)]; }

  /// The half-edges that start at a vertex, in the order of their faces.
  std::span<const std::int32_t> leaving(std::int32_t vertex) const;

 private:
  void sort_by_start();
  void find_twins();
  std::int32_t only_one(std::int32_t from, std::int32_t to) const;

  const Polyhedron& polyhedron_;
  Array<std::int32_t> face_;
  Array<std::int32_t> first_leaving_;  // vertex_count + 1
  Array<std::int32_t> leaving_;
  Array<std::int32_t> twin_;
};

/// The topology whose arrays are contiguous from `indices` on, in the order of Topology's members.
Topology topology_at(const std::int32_t* indices, std::int32_t vertices, std::int32_t edges,
                     std::int32_t faces);

/// The number of those indices.
inline std::int64_t topology_length(std::int64_t vertices, std::int64_t edges, std::int64_t faces) {
  return (faces + 1) + 14 * edges + (vertices + 1);
}

/// Owns the arrays of a Topology.
class TopologyArrays {
 public:
  /// Requires a polyhedron without a fault by check_polyhedron().
  TopologyArrays(const Polyhedron& polyhedron, Memory* memory);
  TopologyArrays(const TopologyArrays&) = delete;  // the view points into its own arrays
  TopologyArrays& operator=(const TopologyArrays&) = delete;

  const Topology& view() const { return view_; }

 private:
  Array<std::int32_t> indices_;
  Topology view_;
};

}  // namespace halfspace
