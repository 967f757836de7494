#include "oracles/minkowski_facets.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace halfspace_test {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Bounds of rounding, in rad. A difference of vertices, turned by the product of two rotations and brought to
// unit length, has less than 16 epsilon; the cross product of two differences less than 8 epsilon more for
// each unit of 1 / sine.
constexpr double doubt_of_direction = 16 * epsilon;
double doubt_of_cross_product(double sine) { return doubt_of_direction + 8 * epsilon / sine; }

/// What the facets are made of: one polyhedron turned into the frame of a.
struct Turned {
  Points3 vertices;    // about the centre
  Points3 normals;     // unit
  Points3 directions;  // of the edges, unit
  std::vector<double> doubts;
};

template <class Turn>
Turned turned(const Polyhedron& polyhedron, Turn turn) {
  const auto vertex = [&](int i) { return polyhedron.vertices[std::size_t(i)]; };
  Turned result;
  for (const Point3& v : local_vertices(polyhedron)) result.vertices.push_back(turn(v));
  for (const std::vector<int>& face : polyhedron.faces) {
    const Corner corner = widest_corner(polyhedron, face);
    const Point3 in = unit(vertex(corner.here) - vertex(corner.before));
    const Point3 out = unit(vertex(corner.after) - vertex(corner.here));
    const Point3 normal = cross(in, out);
    result.normals.push_back(unit(turn(normal)));
    result.doubts.push_back(doubt_of_cross_product(length(normal)));
  }
  for (const Polyhedron::Edge& edge : polyhedron.edges)
    result.directions.push_back(unit(turn(vertex(edge.to) - vertex(edge.from))));
  return result;
}

Turned seen_from_a(const PlacedPolyhedron& a) {
  return turned(*a.polyhedron, [](const Point3& v) { return v; });
}
Turned seen_from_a(const PlacedPolyhedron& a, const PlacedPolyhedron& b) {
  const PairFrame<double> frame(a, b);
  return turned(*b.polyhedron,
                [&](const Point3& v) { return (1 / frame.scale()) * frame.direction_of_b(v); });
}

// The arcs of two edges on the sphere of normals cross, so that the edges make a facet, if for one sign s the
// left normal of each has the sign s along the other's direction, and the right normal has -s: Wang et al.
// 2021, (23) and (24), in the form of docs/theory.md. Here a sign that rounding leaves open is both.
enum : std::uint8_t { plus = 1, minus = 2 };

/// For each direction, and each edge that the normals belong to, the signs s that are possible.
std::vector<std::uint8_t> possible_signs(const Points3& directions, const Turned& owner,
                                         const std::vector<Polyhedron::Edge>& edges) {
  std::vector<std::uint8_t> signs;
  signs.reserve(directions.size() * edges.size());
  std::vector<std::uint8_t> of_face(owner.normals.size());
  for (const Point3& direction : directions) {
    for (std::size_t f = 0; f < of_face.size(); ++f) {
      const double along = dot(direction, owner.normals[f]);
      const double doubt = owner.doubts[f] + doubt_of_direction;
      of_face[f] = std::uint8_t((along >= -doubt ? plus : 0) | (along <= doubt ? minus : 0));
    }
    for (const Polyhedron::Edge& edge : edges) {
      const std::uint8_t left = of_face[std::size_t(edge.left)], right = of_face[std::size_t(edge.right)];
      const std::uint8_t right_reversed = std::uint8_t((right & plus) << 1 | (right & minus) >> 1);
      signs.push_back(left & right_reversed);
    }
  }
  return signs;
}

double farthest(const Points3& points, const Point3& direction) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Point3& p : points) most = std::max(most, dot(direction, p));
  return most;
}

double radius(const Points3& points) {
  double most = 0;
  for (const Point3& p : points) most = std::max(most, dot(p, p));
  return std::sqrt(most);
}

}  // namespace

MinkowskiFacets::MinkowskiFacets(const PlacedPolyhedron& a, const PlacedPolyhedron& b) {
  const Turned of_a = seen_from_a(a);
  const Turned of_b = seen_from_a(a, b);
  a_ = of_a.vertices;
  b_ = of_b.vertices;
  radii_ = radius(a_) + radius(b_);

  using Facet = MinkowskiFacet;
  for (std::size_t f = 0; f < of_a.normals.size(); ++f)
    add({Facet::face_of_a, int(f), -1, of_a.normals[f], of_a.doubts[f], 0});
  for (std::size_t f = 0; f < of_b.normals.size(); ++f)
    add({Facet::face_of_b, -1, int(f), -1.0 * of_b.normals[f], of_b.doubts[f], 0});

  const std::vector<Polyhedron::Edge>&edges_a = a.polyhedron->edges, &edges_b = b.polyhedron->edges;
  const std::vector<std::uint8_t> normals_of_b = possible_signs(of_a.directions, of_b, edges_b);
  const std::vector<std::uint8_t> normals_of_a = possible_signs(of_b.directions, of_a, edges_a);
  for (std::size_t i = 0; i < edges_a.size(); ++i) {
    for (std::size_t j = 0; j < edges_b.size(); ++j) {
      const int signs = normals_of_b[i * edges_b.size() + j] & normals_of_a[j * edges_a.size() + i];
      if (signs == 0) continue;
      const Point3 product = cross(of_a.directions[i], of_b.directions[j]);
      const double sine = length(product);
      const double doubt = 2 * doubt_of_cross_product(sine) + 2 * doubt_of_direction / sine;
      const Point3 normal = sine > 0 ? unit(product) : product;
      if (signs & plus) add({Facet::edges, int(i), int(j), normal, doubt, 0});
      if (signs & minus) add({Facet::edges, int(i), int(j), -1.0 * normal, doubt, 0});
    }
  }
}

void MinkowskiFacets::add(MinkowskiFacet facet) {
  if (facet.doubt < 1) {
    facet.reach = farthest(a_, facet.normal) + farthest(b_, -1.0 * facet.normal);
    facets_.push_back(facet);
  } else {
    parallel_edges_.push_back(facet);
  }
}

MinkowskiFacets::Separation MinkowskiFacets::separation(const Point3& apart) const {
  Separation largest{-std::numeric_limits<double>::infinity(), {}};
  for (const MinkowskiFacet& facet : facets_) {
    const double gap = gap_of(facet, apart);
    if (gap > largest.gap) largest = {gap, facet.normal};
  }
  return largest;
}

double MinkowskiFacets::distance_for(const Point3& start, const Point3& direction, double gap) const {
  // Each gap is linear in the distance, so that their largest is convex, and the first one to reach it
  // counts.
  double distance = std::numeric_limits<double>::infinity();
  for (const MinkowskiFacet& facet : facets_) {
    const double rate = dot(facet.normal, direction);
    if (rate > 0) distance = std::min(distance, (gap - gap_of(facet, start)) / rate);
  }
  return distance;
}

double largest_gap_of_all_axes(const PlacedPolyhedron& a, const PlacedPolyhedron& b) {
  const Turned of_a = seen_from_a(a), of_b = seen_from_a(a, b);
  const Point3 between = apart(a, b);
  double largest = -std::numeric_limits<double>::infinity();
  const auto look_along = [&](const Point3& n) {
    const double gap = dot(n, between) - farthest(of_a.vertices, n) - farthest(of_b.vertices, -1.0 * n);
    largest = std::max(largest, gap);
  };
  for (const Point3& normal : of_a.normals) look_along(normal);
  for (const Point3& normal : of_b.normals) look_along(-1.0 * normal);
  for (const Point3& edge_a : of_a.directions) {
    for (const Point3& edge_b : of_b.directions) {
      const Point3 product = cross(edge_a, edge_b);
      if (length(product) == 0) continue;
      look_along(unit(product));
      look_along(-1.0 * unit(product));
    }
  }
  return largest;
}

Point3 apart(const PlacedPolyhedron& a, const PlacedPolyhedron& b) {
  const PairFrame<double> frame(a, b);
  return (1 / frame.scale()) * frame.apart();
}

}  // namespace halfspace_test
