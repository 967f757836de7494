#include "geometry/polyhedron/surface.h"

#include <algorithm>

#include "geometry/polyhedron/topology.h"

namespace halfspace {
namespace {

PolyhedronFault first_faulty_loop(const Polyhedron& polyhedron) {
  Array<std::int32_t> last_face(polyhedron.vertices.size(), -1, polyhedron.memory());
  for (std::int32_t f = 0; f < polyhedron.face_count(); ++f) {
    const auto loop = polyhedron.loop(f);
    if (loop.size() < 3) return {Fault::face_too_short, -1, f};
    for (const std::int32_t v : loop) {
      if (v < 0 || v >= polyhedron.vertex_count()) return {Fault::no_such_vertex, v, f};
      if (last_face[std::size_t(v)] == f) return {Fault::vertex_twice_in_face, v, f};
      last_face[std::size_t(v)] = f;
    }
  }
  const auto unused = std::find(last_face.begin(), last_face.end(), -1);
  if (unused != last_face.end()) return {Fault::unused_vertex, unused - last_face.begin(), -1};
  return {};
}

PolyhedronFault first_unmatched_edge(const HalfEdges& half_edges) {
  for (std::int32_t h = 0; h < half_edges.count(); ++h) {
    if (half_edges.twin(h) < 0) return {Fault::unmatched_edge, half_edges.start(h), half_edges.face(h)};
  }
  return {};
}

/// A vertex with two faces is inside an edge.
PolyhedronFault first_vertex_inside_edge(const HalfEdges& half_edges, std::int32_t vertex_count) {
  for (std::int32_t v = 0; v < vertex_count; ++v) {
    if (half_edges.leaving(v).size() < 3) return {Fault::vertex_inside_edge, v, -1};
  }
  return {};
}

PolyhedronFault check_loops(const Polyhedron& polyhedron) {
  if (polyhedron.vertex_count() < 4 || polyhedron.face_count() < 4) return {Fault::fewer_than_four, -1, -1};
  return first_faulty_loop(polyhedron);
}

/// Euler's formula excludes several surfaces, tori, and surfaces that share a vertex.
PolyhedronFault check_euler(const Polyhedron& polyhedron, const HalfEdges& half_edges) {
  const std::int32_t edges = half_edges.count() / 2;
  if (polyhedron.vertex_count() - edges + polyhedron.face_count() != 2)
    return {Fault::not_one_surface, -1, -1};
  return {};
}

}  // namespace

PolyhedronFault check_closed(const Polyhedron& polyhedron) {
  if (const PolyhedronFault r = check_loops(polyhedron); r.fault != Fault::none) return r;
  const HalfEdges half_edges(polyhedron);
  if (const PolyhedronFault r = first_unmatched_edge(half_edges); r.fault != Fault::none) return r;
  return check_euler(polyhedron, half_edges);
}

PolyhedronFault check_surface(const Polyhedron& polyhedron) {
  if (const PolyhedronFault r = check_loops(polyhedron); r.fault != Fault::none) return r;
  const HalfEdges half_edges(polyhedron);
  if (const PolyhedronFault r = first_unmatched_edge(half_edges); r.fault != Fault::none) return r;
  if (const PolyhedronFault r = first_vertex_inside_edge(half_edges, polyhedron.vertex_count());
      r.fault != Fault::none) {
    return r;
  }
  return check_euler(polyhedron, half_edges);
}

}  // namespace halfspace
