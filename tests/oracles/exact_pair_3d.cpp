#include "oracles/exact_pair_3d.h"

#include <CGAL/Gmpzf.h>
#include <CGAL/Mpzf.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <algorithm>
#include <limits>

namespace halfspace_test {
namespace {

using Exact = CGAL::Mpzf;

/// Both polyhedra in the frame of a, everything multiplied by the frame's scale.
class ExactPair {
 public:
  ExactPair(const PlacedPolyhedron& a, const PlacedPolyhedron& b)
      : a_(*a.polyhedron), b_(*b.polyhedron), frame_(a, b) {
    for (const Point3& v : a_.vertices) points_of_a_.push_back(frame_.point_of_a(a, v));
    for (const Point3& v : b_.vertices) points_of_b_.push_back(frame_.point_of_b(b, v));
  }

  /// Does the facet's normal, which is exact but not of unit length, have all of b strictly in front of all
  /// of a? Of two edges both senses are looked at: when they are close to parallel, the sense is in doubt
  /// too.
  bool is_apart_along(const MinkowskiFacet& facet) const {
    switch (facet.kind) {
      case MinkowskiFacet::face_of_a:
        return is_apart_along(normal_of_face(a_, facet.a));
      case MinkowskiFacet::face_of_b:
        return is_apart_along(frame_.direction_of_b(Exact(-1) * normal_of_face(b_, facet.b)));
      default: {
        const Vector3<Exact> normal = cross(edge(a_, facet.a), frame_.direction_of_b(edge(b_, facet.b)));
        return is_apart_along(normal) || is_apart_along(Exact(-1) * normal);
      }
    }
  }

 private:
  bool is_apart_along(const Vector3<Exact>& normal) const {
    Exact farthest_of_a = dot(normal, points_of_a_[0]);
    for (const Vector3<Exact>& p : points_of_a_) farthest_of_a = std::max(farthest_of_a, dot(normal, p));
    return std::all_of(points_of_b_.begin(), points_of_b_.end(),
                       [&](const Vector3<Exact>& p) { return dot(normal, p) > farthest_of_a; });
  }

  static Vector3<Exact> difference(const Polyhedron& polyhedron, int from, int to) {
    return converted<Exact>(polyhedron.vertices[std::size_t(to)]) -
           converted<Exact>(polyhedron.vertices[std::size_t(from)]);
  }
  static Vector3<Exact> normal_of_face(const Polyhedron& polyhedron, int face) {
    const Corner corner = widest_corner(polyhedron, polyhedron.faces[std::size_t(face)]);
    return cross(difference(polyhedron, corner.before, corner.here),
                 difference(polyhedron, corner.here, corner.after));
  }
  static Vector3<Exact> edge(const Polyhedron& polyhedron, int edge) {
    const Polyhedron::Edge& e = polyhedron.edges[std::size_t(edge)];
    return difference(polyhedron, e.from, e.to);
  }
  const Polyhedron& a_;
  const Polyhedron& b_;
  PairFrame<Exact> frame_;
  std::vector<Vector3<Exact>> points_of_a_;
  std::vector<Vector3<Exact>> points_of_b_;
};

}  // namespace

double extent(const MinkowskiFacets& facets, const Point3& apart) { return facets.radii() + length(apart); }

ExactVerdict3 exact_verdict(const PlacedPolyhedron& a, const PlacedPolyhedron& b,
                            const MinkowskiFacets& facets) {
  const Point3 between = apart(a, b);
  // Of the coordinates: one rounding each for the vertices about the centre and the distance of the centres,
  // 20 for the two turns together, 6 for the dot products and their difference. The bound has 128 of them.
  const double accuracy = 64 * std::numeric_limits<double>::epsilon() * extent(facets, between);
  const MinkowskiFacets::Separation separation = facets.separation(between);
  ExactVerdict3 verdict{true, separation.gap, separation.normal, accuracy, true};
  // Any direction with a gap is a proof, however far it is from a facet's normal.
  if (separation.gap > accuracy) {
    verdict.touches = false;
    return verdict;
  }

  std::vector<const MinkowskiFacet*> in_doubt;
  for (const MinkowskiFacet& facet : facets.facets()) {
    if (gap_of(facet, between) >= -(accuracy + facet.doubt * extent(facets, between)))
      in_doubt.push_back(&facet);
  }
  for (const MinkowskiFacet& facet : facets.parallel_edges()) in_doubt.push_back(&facet);
  verdict.filter_was_enough = in_doubt.empty();
  if (in_doubt.empty()) return verdict;
  const ExactPair exact(a, b);
  verdict.touches = std::none_of(in_doubt.begin(), in_doubt.end(),
                                 [&](const MinkowskiFacet* facet) { return exact.is_apart_along(*facet); });
  return verdict;
}

bool have_a_common_point(const PlacedPolyhedron& a, const PlacedPolyhedron& b) {
  // Weights >= 0 of the vertices, with the sum 1 for a and for b, so that both weighted means are one point.
  using Number = CGAL::Gmpzf;
  const PairFrame<Number> frame(a, b);
  CGAL::Quadratic_program<Number> program(CGAL::EQUAL, true, 0, false, 0);
  int variable = 0;
  const auto add = [&](const Vector3<Number>& p, int sum) {
    program.set_a(variable, 0, p.x);
    program.set_a(variable, 1, p.y);
    program.set_a(variable, 2, p.z);
    program.set_a(variable, sum, 1);
    ++variable;
  };
  for (const Point3& v : a.polyhedron->vertices) add(frame.point_of_a(a, v), 3);
  for (const Point3& v : b.polyhedron->vertices) add(Number(-1) * frame.point_of_b(b, v), 4);
  program.set_b(3, 1);
  program.set_b(4, 1);
  return !CGAL::solve_linear_program(program, Number()).is_infeasible();
}

}  // namespace halfspace_test
