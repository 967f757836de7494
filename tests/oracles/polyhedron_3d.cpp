#include "oracles/polyhedron_3d.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <map>
#include <utility>

namespace halfspace_test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

bool in_one_plane(const Mesh& mesh, Mesh::Face_index triangle, Mesh::Face_index other) {
  std::vector<Kernel::Point_3> p;
  for (const auto v : mesh.vertices_around_face(mesh.halfedge(triangle))) p.push_back(mesh.point(v));
  for (const auto v : mesh.vertices_around_face(mesh.halfedge(other))) {
    if (!CGAL::coplanar(p[0], p[1], p[2], mesh.point(v))) return false;
  }
  return true;
}

/// For every triangle the number of the face that it is a part of. Returns how many faces there are.
int join_triangles(const Mesh& mesh, std::vector<int>& face_of) {
  face_of.assign(mesh.num_faces(), -1);
  int faces = 0;
  for (const auto first : mesh.faces()) {
    if (face_of[first] >= 0) continue;
    std::vector<Mesh::Face_index> reached{first};
    face_of[first] = faces;
    while (!reached.empty()) {
      const auto triangle = reached.back();
      reached.pop_back();
      for (const auto h : mesh.halfedges_around_face(mesh.halfedge(triangle))) {
        const auto next = mesh.face(mesh.opposite(h));
        if (face_of[next] >= 0 || !in_one_plane(mesh, first, next)) continue;
        face_of[next] = faces;
        reached.push_back(next);
      }
    }
    ++faces;
  }
  return faces;
}

/// For every vertex of the mesh its number among the points that are vertices, in the order of the points:
/// the mesh has them in an order that depends on addresses.
std::vector<int> number_vertices(const Mesh& mesh, const Points3& points, Points3& vertices) {
  std::map<Kernel::Point_3, Mesh::Vertex_index> vertex_at;
  for (const auto v : mesh.vertices()) vertex_at[mesh.point(v)] = v;
  std::vector<int> number(mesh.num_vertices(), -1);
  for (const Point3& p : points) {
    const auto found = vertex_at.find({p.x, p.y, p.z});
    if (found == vertex_at.end() || number[found->second] >= 0) continue;
    number[found->second] = int(vertices.size());
    vertices.push_back(p);
  }
  return number;
}

/// The outlines of the faces, each from its least vertex on, in the order of their vertices.
std::vector<std::vector<int>> outlines(const Mesh& mesh, const std::vector<int>& number) {
  std::vector<int> face_of;
  const int count = join_triangles(mesh, face_of);
  std::vector<std::map<int, int>> next_on(
      static_cast<std::size_t>(count));  // by face: vertex to the next one
  for (const auto h : mesh.halfedges()) {
    const int left = face_of[mesh.face(h)], right = face_of[mesh.face(mesh.opposite(h))];
    if (left != right) next_on[std::size_t(left)][number[mesh.source(h)]] = number[mesh.target(h)];
  }
  std::vector<std::vector<int>> faces;
  for (const std::map<int, int>& next : next_on) {
    std::vector<int> face{next.begin()->first};
    for (int v = next.at(face[0]); v != face[0]; v = next.at(v)) face.push_back(v);
    faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

std::vector<Polyhedron::Edge> edges_of(const std::vector<std::vector<int>>& faces) {
  std::map<std::pair<int, int>, int> left_of;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t i = 0; i < faces[f].size(); ++i)
      left_of[{faces[f][i], faces[f][(i + 1) % faces[f].size()]}] = int(f);
  }
  std::vector<Polyhedron::Edge> edges;
  for (const auto& [edge, left] : left_of) {
    const auto [from, to] = edge;
    if (from < to) edges.push_back({from, to, left, left_of.at({to, from})});
  }
  return edges;
}

}  // namespace

Polyhedron convex_hull(const Points3& points) {
  std::vector<Kernel::Point_3> in;
  for (const Point3& p : points) in.emplace_back(p.x, p.y, p.z);
  Mesh mesh;
  CGAL::convex_hull_3(in.begin(), in.end(), mesh);
  Polyhedron hull;
  if (mesh.num_vertices() < 4 || !CGAL::is_closed(mesh)) return hull;

  const std::vector<int> number = number_vertices(mesh, points, hull.vertices);
  hull.faces = outlines(mesh, number);
  hull.edges = edges_of(hull.faces);
  for (const Point3& v : hull.vertices) hull.centre = hull.centre + v;
  hull.centre = (1 / double(hull.vertices.size())) * hull.centre;
  return hull;
}

Points3 local_vertices(const Polyhedron& polyhedron) {
  Points3 local;
  for (const Point3& v : polyhedron.vertices) local.push_back(v - polyhedron.centre);
  return local;
}

Corner widest_corner(const Polyhedron& polyhedron, const std::vector<int>& face) {
  const auto vertex = [&](int i) { return polyhedron.vertices[std::size_t(i)]; };
  Corner widest{face[0], face[1], face[2]};
  double largest_sine = 0;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Corner corner{face[i], face[(i + 1) % face.size()], face[(i + 2) % face.size()]};
    const Point3 in = vertex(corner.here) - vertex(corner.before);
    const Point3 out = vertex(corner.after) - vertex(corner.here);
    const double sine = length(cross(in, out)) / (length(in) * length(out));
    if (sine > largest_sine) {
      largest_sine = sine;
      widest = corner;
    }
  }
  return widest;
}

}  // namespace halfspace_test
