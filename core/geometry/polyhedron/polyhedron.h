#pragma once

#include <cstdint>
#include <span>

#include "geometry/vector.h"

namespace halfspace {

/// A convex polyhedron: vertices, and faces as loops of vertices. The result of hulls and cuts, and the input
/// of Shape<3>.
struct Polyhedron {
  explicit Polyhedron(Memory* memory)
      : vertices(memory), first_of_face(1, 0, memory), face_vertices(memory), normals(memory) {}

  Polyhedron(Polyhedron&&) = default;
  Polyhedron& operator=(Polyhedron&&) = default;
  /// Copies into memory of the given allocator.
  Polyhedron(const Polyhedron& other, Memory* memory)
      : vertices(other.vertices, memory),
        first_of_face(other.first_of_face, memory),
        face_vertices(other.face_vertices, memory),
        normals(other.normals, memory) {}

  std::int32_t vertex_count() const { return std::int32_t(vertices.size()); }
  std::int32_t face_count() const { return std::int32_t(first_of_face.size()) - 1; }
  bool is_empty() const { return vertices.empty(); }
  Memory* memory() const { return vertices.get_allocator().resource(); }

  /// Vertices of a face, counter-clockwise seen from outside.
  std::span<const std::int32_t> loop(std::int32_t face) const {
    const std::size_t first = std::size_t(first_of_face[std::size_t(face)]);
    return {face_vertices.data() + first, std::size_t(first_of_face[std::size_t(face) + 1]) - first};
  }
  const Vector<3>& corner(std::int32_t face, std::size_t i) const {
    return vertices[std::size_t(loop(face)[i])];
  }

  void append_corner(std::int32_t vertex) { face_vertices.push_back(vertex); }
  /// Ends a face of the corners appended since the last one.
  void end_face() { first_of_face.push_back(std::int32_t(face_vertices.size())); }

  Array<Vector<3>> vertices;
  Array<std::int32_t> first_of_face;  // size face_count + 1, starts with 0
  Array<std::int32_t> face_vertices;
  /// Outer unit normal of each face. Stored with the loops, as rounded vertices of a small face do not define
  /// it: after a thousand cuts the faces still have the normals of the cutting planes.
  Array<Vector<3>> normals;
};

/// The largest absolute coordinate, the scale of rounding errors.
double largest_coordinate(std::span<const Vector<3>> vertices);

}  // namespace halfspace
