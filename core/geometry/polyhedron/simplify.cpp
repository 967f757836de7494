#include "geometry/polyhedron/simplify.h"

#include <algorithm>

namespace halfspace {
namespace {

/// Rewrites the loops: vertex keep(v) replaces v, -1 removes it. Equal neighbours in a loop become one; faces
/// with fewer than three vertices are removed.
template <class Keep>
void rewrite_loops(Polyhedron& p, Keep keep) {
  std::int32_t kept_faces = 0;
  std::size_t written = 0;
  std::size_t begin = 0;
  for (std::size_t f = 0; f < p.normals.size(); ++f) {
    const std::size_t end = std::size_t(p.first_of_face[f + 1]);
    const std::size_t first = written;
    for (; begin < end; ++begin) {
      const std::int32_t v = keep(p.face_vertices[begin]);
      if (v >= 0 && (written == first || p.face_vertices[written - 1] != v)) p.face_vertices[written++] = v;
    }
    while (written > first + 1 && p.face_vertices[written - 1] == p.face_vertices[first]) --written;
    if (written < first + 3) {
      written = first;
      continue;
    }
    p.normals[std::size_t(kept_faces)] = p.normals[f];
    p.first_of_face[std::size_t(++kept_faces)] = std::int32_t(written);
  }
  p.face_vertices.resize(written);
  p.first_of_face.resize(std::size_t(kept_faces) + 1);
  p.normals.resize(std::size_t(kept_faces));
}

Array<std::int32_t> faces_at_vertices(const Polyhedron& p) {
  Array<std::int32_t> faces(p.vertices.size(), 0, p.memory());
  for (const std::int32_t v : p.face_vertices) ++faces[std::size_t(v)];
  return faces;
}

void drop_unused_vertices(Polyhedron& p) {
  Array<std::int32_t> place = faces_at_vertices(p);
  std::int32_t kept = 0;
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (place[v] == 0) continue;
    p.vertices[std::size_t(kept)] = p.vertices[v];
    place[v] = kept++;
  }
  p.vertices.resize(std::size_t(kept));
  for (std::int32_t& v : p.face_vertices) v = place[std::size_t(v)];
}

/// The vertex that replaces another, at the end of a chain of replacements.
std::int32_t place_of(std::int32_t v, const Array<std::int32_t>& taken_by) {
  while (taken_by[std::size_t(v)] != v) v = taken_by[std::size_t(v)];
  return v;
}

}  // namespace

void drop_degenerate(Polyhedron& polyhedron) {
  // A removed face may leave a vertex with two faces, which is removed, and then another face.
  for (std::size_t before = polyhedron.face_vertices.size() + 1; polyhedron.face_vertices.size() < before;) {
    before = polyhedron.face_vertices.size();
    const Array<std::int32_t> faces = faces_at_vertices(polyhedron);
    rewrite_loops(polyhedron, [&](std::int32_t v) { return faces[std::size_t(v)] < 3 ? -1 : v; });
  }
  drop_unused_vertices(polyhedron);
}

void weld_short_edges(Polyhedron& polyhedron, double length) {
  Array<std::int32_t> taken_by(polyhedron.vertices.size(), polyhedron.memory());
  for (std::size_t v = 0; v < taken_by.size(); ++v) taken_by[v] = std::int32_t(v);
  for (std::int32_t f = 0; f < polyhedron.face_count(); ++f) {
    std::int32_t before = polyhedron.loop(f).back();
    for (const std::int32_t v : polyhedron.loop(f)) {
      const Vector<3> edge = polyhedron.vertices[std::size_t(v)] - polyhedron.vertices[std::size_t(before)];
      const std::int32_t a = place_of(before, taken_by);
      const std::int32_t b = place_of(v, taken_by);
      if (edge.cwiseAbs().maxCoeff() <= length) taken_by[std::size_t(std::max(a, b))] = std::min(a, b);
      before = v;
    }
  }
  rewrite_loops(polyhedron, [&](std::int32_t v) { return place_of(v, taken_by); });
  drop_degenerate(polyhedron);
}

}  // namespace halfspace
