#include "geometry/divided_polyhedron.h"

#include <algorithm>
#include <cmath>

#include "geometry/two_lanes.h"

namespace halfspace {

/// Gained by doubling, for all arrays alike: the last one tells what every one has, wherever memory ran out
/// before.
void DividedPolyhedron::make_room(std::size_t vertices) {
  if (outside_.size() >= vertices) return;
  const std::size_t room = std::max(vertices, 2 * outside_.size());
  const auto widen = [](auto& array, std::size_t size) {
    if (array.size() < size) array.resize(size);
  };
  widen(vertex_, room);
  widen(twin_, 4 * room);
  widen(face_, 4 * room);
  widen(inside_, room);
  widen(crossings_, room);
  widen(triangles_, 4 * room);
  widen(outside_, room);
}

void DividedPolyhedron::reserve(std::size_t edges, std::size_t faces, std::size_t vertices) {
  make_room(vertices);
  grow(first_of_vertex_, edges);
  grow(half_of_edge_, 2 * edges);
  grow(fan_center_, faces);
}

void DividedPolyhedron::begin(const Outline<3>& block, const Sounding& sounding) {
  const Topology& t = *block.topology;
  make_room(std::size_t(2 * t.edge_count));
  grow(first_of_vertex_, std::size_t(t.vertex_count));
  grow(half_of_edge_, std::size_t(2 * t.edge_count));
  extent_ = {0, Index(t.face_count)};
  inside_count_ = 0;
  outside_count_ = 0;
  for (std::int32_t v = 0; v < t.vertex_count; ++v) {
    first_of_vertex_[std::size_t(v)] = extent_.vertices;
    add_block_vertex(block, v, sounding.depth(v));
  }
  join_block_vertices(block);
  cut_edges_of_inside();
  close_inside();
}

/// Where d edges meet inside there is a row of d - 2 vertices, from each to the next an edge without length
/// that has the last face on its left. The first and the last have two edges of the block, the others one. A
/// vertex outside is but a place that edges go to.
void DividedPolyhedron::add_block_vertex(const Outline<3>& block, std::int32_t v, double depth) {
  const Vertex vertex{block.x[v], block.y[v], block.z[v], depth};
  if (depth < 0) {
    vertex_[extent_.vertices++] = vertex;
    return;
  }
  const Topology& t = *block.topology;
  const std::int32_t begin = t.first_of_vertex[v], degree = t.first_of_vertex[v + 1] - begin;
  const std::int32_t *const edge = t.vertex_edge + begin, *const face = t.vertex_face + begin;
  const auto put = [&](std::int32_t k, Index half) {
    half_of_edge_[std::size_t(2 * edge[k] + (t.edge_start[edge[k]] == v))] = half;
  };
  put(0, 4 * extent_.vertices);
  for (std::int32_t k = 1; k < degree - 1; ++k) {
    const Index half = 4 * extent_.vertices;
    put(k, half + 1);
    face_[half] = Index(face[k - 1]);
    face_[half + 1] = Index(face[k]);
    face_[half + 2] = Index(face[degree - 1]);
    if (k > 1) twin_[half] = half - 2;
    if (k < degree - 2) twin_[half + 2] = half + 4;
    vertex_[extent_.vertices] = vertex;
    inside_[inside_count_++] = extent_.vertices++;
  }
  put(degree - 1, 4 * (extent_.vertices - 1) + 2);
}

void DividedPolyhedron::join_block_vertices(const Outline<3>& block) {
  const Topology& t = *block.topology;
  for (std::int32_t v = 0; v < t.vertex_count; ++v) {
    if (vertex_[first_of_vertex_[std::size_t(v)]].depth < 0) continue;
    for (std::int32_t k = t.first_of_vertex[v]; k < t.first_of_vertex[v + 1]; ++k) {
      const std::int32_t edge = t.vertex_edge[k], at_start = t.edge_start[edge] == v;
      const Index other = first_of_vertex_[std::size_t(t.vertex_neighbour[k])];
      twin_[half_of_edge_[std::size_t(2 * edge + at_start)]] =
          vertex_[other].depth < 0 ? 4 * other : half_of_edge_[std::size_t(2 * edge + 1 - at_start)];
    }
  }
}

void DividedPolyhedron::begin(const DividedPolyhedron& other) {
  extent_ = other.extent_;
  make_room(extent_.vertices);
  std::copy_n(other.vertex_.begin(), extent_.vertices, vertex_.begin());
  std::copy_n(other.twin_.begin(), 4 * extent_.vertices, twin_.begin());
  std::copy_n(other.face_.begin(), 4 * extent_.vertices, face_.begin());
  grow(fan_center_, extent_.faces);
}

DepthRange DividedPolyhedron::sound(Part part, const CuttingPlane& plane) {
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const Index v : part) {
    Vertex& p = vertex_[v];
    p.depth = plane.offset - (plane.normal.x() * p.x + plane.normal.y() * p.y + plane.normal.z() * p.z);
    least = std::min(least, p.depth);
    most = std::max(most, p.depth);
  }
  return {least, most};
}

/// Without branches: on which side a vertex is, is as good as random.
void DividedPolyhedron::cut_edges(Part part) {
  Index *in = inside_.data(), *out = outside_.data();
  const Vertex* const vertex = vertex_.data();
  for (const Index v : part) {
    const bool is_inside = !(vertex[v].depth < 0);
    *in = *out = v;
    in += is_inside;
    out += !is_inside;
  }
  inside_count_ = std::size_t(in - inside_.data());
  outside_count_ = std::size_t(out - outside_.data());
  cut_edges_of_inside();
}

void DividedPolyhedron::cut_edges_of_inside() {
  // For two vertices at each of their edges; and for one crossing more than there is.
  make_room(extent_.vertices + 6 * inside_count_ + 1);
  Vertex* const vertex = vertex_.data();
  Index* const twin = twin_.data();
  Crossing* end = crossings_.data();
  for (const Index v : inside()) {
    for (Index k = 0; k < 3; ++k) {
      end->inner_half = 4 * v + k;
      end->outer_half = twin[4 * v + k];
      end += vertex[end->outer()].depth < 0;
    }
  }
  crossing_count_ = std::size_t(end - crossings_.data());
  Index added = extent_.vertices;
  for (Crossing* crossing = crossings_.data(); crossing != end; ++crossing, ++added) {
    const Vertex &p = vertex[crossing->inner()], &q = vertex[crossing->outer()];
    const double share = p.depth / (p.depth - q.depth);
    crossing->share = share;
    vertex[added] = {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y), p.z + share * (q.z - p.z), 0};
    twin[4 * added] = crossing->inner_half;
    twin[crossing->inner_half] = 4 * added;
  }
}

/// Of the edges of a new vertex one is that which has been cut; the others lead to those before it and behind
/// it along the new face.
inline void DividedPolyhedron::surround(Index vertex, Index left, Index right) {
  face_[4 * vertex] = right;
  face_[4 * vertex + 1] = extent_.faces;
  face_[4 * vertex + 2] = left;
}

/// Along a face, behind the vertex where its outline leaves a part comes the one where it comes back.
inline void DividedPolyhedron::join(Index exit, Index entry) {
  twin_[4 * exit + 2] = 4 * entry + 1;
  twin_[4 * entry + 1] = 4 * exit + 2;
}

/// Calls `join(exit, entry)`. Where rounding has torn a face, its outline may come and go more than once.
template <class Join>
inline void DividedPolyhedron::join_along_faces(Join join) {
  Index entry = extent_.vertices;
  for (const Crossing& crossing : crossings()) {
    Index half = clockwise(crossing.inner_half);
    while (twin_[half] < 4 * extent_.vertices) half = clockwise(twin_[half]);
    join(twin_[half] / 4, entry++);
  }
}

void DividedPolyhedron::close_inside() {
  Index added = extent_.vertices;
  for (const Crossing& crossing : crossings()) {
    surround(added, face_[crossing.inner_half], face_[clockwise(crossing.inner_half)]);
    inside_[inside_count_++] = added++;
  }
  join_along_faces([this](Index exit, Index entry) { join(exit, entry); });
  extent_.vertices = added;
  grow(fan_center_, ++extent_.faces);
}

void DividedPolyhedron::close_both() {
  const Index count = Index(crossing_count_);
  Index added = extent_.vertices;
  for (const Crossing& crossing : crossings()) {
    const Index left = face_[crossing.inner_half], right = face_[clockwise(crossing.inner_half)];
    const Index other = added + count;
    vertex_[other] = vertex_[added];
    twin_[4 * other] = crossing.outer_half;
    twin_[crossing.outer_half] = 4 * other;
    surround(added, left, right);
    surround(other, right, left);
    inside_[inside_count_++] = added++;
    outside_[outside_count_++] = other;
  }
  join_along_faces([this, count](Index exit, Index entry) {
    join(exit, entry);
    join(entry + count, exit + count);
  });
  extent_.vertices += 2 * count;
  grow(fan_center_, ++extent_.faces);
}

/// Of each face that is not at the top, between one of its corners and its other edges; a corner in the plane
/// if there is one, for the new edges have not been joined. What that leaves out is in the plane, as the top
/// is.
std::size_t DividedPolyhedron::list_triangles(Index top) {
  Index* const center = fan_center_.data();
  const Index *const twin = twin_.data(), *const face = face_.data();
  for (const Index v : inside())
    for (Index half = 4 * v; half < 4 * v + 3; ++half) center[face[half]] = v;
  Index added = extent_.vertices;
  for (const Crossing& crossing : crossings()) center[face[crossing.inner_half]] = added++;
  if (crossing_count_ > 0) {
    center[face[crossings_[0].inner_half]] = top;
    center[face[clockwise(crossings_[0].inner_half)]] = top;
  }
  Triangle* triangle = triangles_.data();
  for (const Index v : inside()) {
    for (Index half = 4 * v; half < 4 * v + 3; ++half) {
      const Index from = center[face[half]];
      *triangle = {from, half};
      triangle += (from != top) & (from != v) & (from != twin[half] / 4);
    }
  }
  added = extent_.vertices;
  for (const Crossing& crossing : crossings()) {
    const Index from = center[face[clockwise(crossing.inner_half)]];
    *triangle = {from, 4 * added};
    triangle += (from != top) & (from != added++);
  }
  *triangle = {top, 4 * top};  // so that they can be read in pairs
  return std::size_t(triangle - triangles_.data());
}

VolumeAndMoment DividedPolyhedron::measure(Part part) {
  std::copy(part.begin(), part.end(), inside_.begin());
  inside_count_ = part.size();
  crossing_count_ = 0;
  return measure_inside();
}

/// As tetrahedra from one vertex to triangles. Where rounding has torn a face, as a plane flush with it does,
/// all its loops are seen from one corner: what then is negative has been counted twice elsewhere.
VolumeAndMoment DividedPolyhedron::measure_inside() {
  if (inside_count_ == 0) return {};
  const Index top_vertex = crossing_count_ > 0 ? extent_.vertices : inside_[inside_count_ - 1];
  const std::size_t count = list_triangles(top_vertex);
  const Vertex* const vertex = vertex_.data();
  const Vertex top = vertex[top_vertex];
  struct Points {
    TwoLanes x, y, z;
  };
  const auto seen_from_top = [&](Index v, Index w) {
    const Vertex &p = vertex[v], &q = vertex[w];
    return Points{TwoLanes{p.x, q.x} - both(top.x), TwoLanes{p.y, q.y} - both(top.y),
                  TwoLanes{p.z, q.z} - both(top.z)};
  };
  TwoLanes sum{}, sum_x{}, sum_y{}, sum_z{};
  for (const Triangle *s = triangles_.data(), *end = s + count; s < end; s += 2) {
    const Points p = seen_from_top(s[0].corner, s[1].corner), q = seen_from_top(s[0].half / 4, s[1].half / 4),
                 r = seen_from_top(twin_[s[0].half] / 4, twin_[s[1].half] / 4);
    const TwoLanes volume =
        p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) + p.z * (q.x * r.y - q.y * r.x);
    sum += volume;
    sum_x += volume * (p.x + q.x + r.x);
    sum_y += volume * (p.y + q.y + r.y);
    sum_z += volume * (p.z + q.z + r.z);
  }
  const double volume = (sum[0] + sum[1]) / 6;
  return {volume,
          {(sum_x[0] + sum_x[1]) / 24 + volume * top.x, (sum_y[0] + sum_y[1]) / 24 + volume * top.y,
           (sum_z[0] + sum_z[1]) / 24 + volume * top.z}};
}

}  // namespace halfspace
