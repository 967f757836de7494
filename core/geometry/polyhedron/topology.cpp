#include "geometry/polyhedron/topology.h"

#include <algorithm>

namespace halfspace {

HalfEdges::HalfEdges(const Polyhedron& polyhedron)
    : polyhedron_(polyhedron),
      face_(polyhedron.face_vertices.size(), polyhedron.memory()),
      first_leaving_(polyhedron.vertices.size() + 1, 0, polyhedron.memory()),
      leaving_(polyhedron.face_vertices.size(), polyhedron.memory()),
      twin_(polyhedron.face_vertices.size(), polyhedron.memory()) {
  for (std::int32_t f = 0; f < polyhedron.face_count(); ++f) {
    std::fill(face_.begin() + polyhedron.first_of_face[std::size_t(f)],
              face_.begin() + polyhedron.first_of_face[std::size_t(f) + 1], f);
  }
  sort_by_start();
  find_twins();
}

std::int32_t HalfEdges::next(std::int32_t h) const {
  const std::size_t f = std::size_t(face(h));
  return h + 1 == polyhedron_.first_of_face[f + 1] ? polyhedron_.first_of_face[f] : h + 1;
}

std::int32_t HalfEdges::previous(std::int32_t h) const {
  const std::size_t f = std::size_t(face(h));
  return (h == polyhedron_.first_of_face[f] ? polyhedron_.first_of_face[f + 1] : h) - 1;
}

std::span<const std::int32_t> HalfEdges::leaving(std::int32_t vertex) const {
  const std::size_t first = std::size_t(first_leaving_[std::size_t(vertex)]);
  return {leaving_.data() + first, std::size_t(first_leaving_[std::size_t(vertex) + 1]) - first};
}

void HalfEdges::sort_by_start() {
  // Counting sort: counts, their running sum, then each half-edge into the next free place of its vertex.
  for (std::int32_t h = 0; h < count(); ++h) ++first_leaving_[std::size_t(start(h)) + 1];
  for (std::size_t v = 1; v < first_leaving_.size(); ++v) first_leaving_[v] += first_leaving_[v - 1];
  Array<std::int32_t> free_place(first_leaving_, first_leaving_.get_allocator());
  for (std::int32_t h = 0; h < count(); ++h) {
    leaving_[std::size_t(free_place[std::size_t(start(h))]++)] = h;
  }
}

void HalfEdges::find_twins() {
  for (std::int32_t h = 0; h < count(); ++h) {
    const bool is_alone = only_one(start(h), end(h)) == h;
    twin_[std::size_t(h)] = is_alone ? only_one(end(h), start(h)) : -1;
  }
}

std::int32_t HalfEdges::only_one(std::int32_t from, std::int32_t to) const {
  // A vertex has as many half-edges that arrive as leave: one of each per face.
  const bool is_short = leaving(from).size() <= leaving(to).size();
  std::int32_t found = -1;
  for (const std::int32_t at_vertex : leaving(is_short ? from : to)) {
    const std::int32_t h = is_short ? at_vertex : previous(at_vertex);
    if (start(h) != from || end(h) != to) continue;
    if (found >= 0) return -1;
    found = h;
  }
  return found;
}

Topology topology_at(const std::int32_t* indices, std::int32_t vertices, std::int32_t edges,
                     std::int32_t faces) {
  const std::int32_t* next = indices;
  const auto take = [&](std::int32_t count) {
    const std::int32_t* const taken = next;
    next += count;
    return taken;
  };
  Topology topology{vertices, edges, faces};
  topology.first_of_face = take(faces + 1);
  topology.face_vertex = take(2 * edges);
  topology.face_edge = take(2 * edges);
  topology.edge_start = take(edges);
  topology.edge_end = take(edges);
  topology.edge_left = take(edges);
  topology.edge_right = take(edges);
  topology.first_of_vertex = take(vertices + 1);
  topology.vertex_neighbour = take(2 * edges);
  topology.vertex_edge = take(2 * edges);
  topology.vertex_face = take(2 * edges);
  return topology;
}

TopologyArrays::TopologyArrays(const Polyhedron& polyhedron, Memory* memory) : indices_(memory) {
  const HalfEdges half_edges(polyhedron);
  const std::int32_t vertices = polyhedron.vertex_count();
  const std::int32_t faces = polyhedron.face_count();
  const std::int32_t halves = half_edges.count();
  const std::int32_t edges = halves / 2;

  indices_.resize(std::size_t(topology_length(vertices, edges, faces)));
  view_ = topology_at(indices_.data(), vertices, edges, faces);
  const auto own = [&](const std::int32_t* array) { return indices_.data() + (array - indices_.data()); };
  std::int32_t* const face_edge = own(view_.face_edge);
  std::int32_t* const edge_start = own(view_.edge_start);
  std::int32_t* const edge_end = own(view_.edge_end);
  std::int32_t* const edge_left = own(view_.edge_left);
  std::int32_t* const edge_right = own(view_.edge_right);
  std::int32_t* const first_of_vertex = own(view_.first_of_vertex);
  std::int32_t* const vertex_neighbour = own(view_.vertex_neighbour);
  std::int32_t* const vertex_edge = own(view_.vertex_edge);
  std::int32_t* const vertex_face = own(view_.vertex_face);

  std::copy(polyhedron.first_of_face.begin(), polyhedron.first_of_face.end(), own(view_.first_of_face));
  std::copy(polyhedron.face_vertices.begin(), polyhedron.face_vertices.end(), own(view_.face_vertex));

  std::int32_t e = 0;
  for (std::int32_t h = 0; h < halves; ++h) {
    const std::int32_t twin = half_edges.twin(h);
    if (twin < h) continue;
    edge_start[e] = half_edges.start(h);
    edge_end[e] = half_edges.end(h);
    edge_left[e] = half_edges.face(h);
    edge_right[e] = half_edges.face(twin);
    face_edge[h] = face_edge[twin] = e++;
  }

  std::int32_t k = 0;
  for (std::int32_t v = 0; v < vertices; ++v) {
    first_of_vertex[v] = k;
    const std::int32_t first = half_edges.leaving(v)[0];
    std::int32_t h = first;
    do {
      vertex_neighbour[k] = half_edges.end(h);
      vertex_edge[k] = face_edge[h];
      vertex_face[k] = half_edges.face(h);
      ++k;
      // The face on the left of an outgoing edge is counter-clockwise of it; the next edge is the one by
      // which that face's loop arrives.
      h = half_edges.twin(half_edges.previous(h));
    } while (h != first);
  }
  first_of_vertex[vertices] = k;
}

}  // namespace halfspace
