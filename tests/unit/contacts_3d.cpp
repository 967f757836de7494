#include "contacts_3d.h"

#include <Eigen/Geometry>
#include <cmath>

#include "catch.h"
#include "narrow_phase/space/potential_pairs.h"

namespace halfspace::test {
namespace {

bool is_behind_faces(const Shape<3>& shape, const Vector<3>& p, double margin) {
  const Outline<3>& o = shape.outline();
  for (int f = 0; f < o.face_count(); ++f)
    if (o.normal(f).dot(p) > o.offset[f] + margin) return false;
  return true;
}

}  // namespace

Cloud prism(const Points& base, double height) {
  Cloud points;
  for (const Vector<2>& p : base) {
    points.emplace_back(p.x(), p.y(), -0.5 * height);
    points.emplace_back(p.x(), p.y(), 0.5 * height);
  }
  return points;
}

Cloud octahedron(double x, double y, double z) {
  return {{x, 0, 0}, {-x, 0, 0}, {0, y, 0}, {0, -y, 0}, {0, 0, z}, {0, 0, -z}};
}

Cloud wedge(double length, double half_width, double height) {
  Cloud points;
  for (const double x : {-0.5 * length, 0.5 * length})
    for (const double sign : {-1.0, 1.0})
      points.insert(points.end(), {{x, sign * half_width, 0}, {x, 0, sign * height}});
  return points;
}

Cloud turned(Cloud points, const Eigen::Matrix3d& turn) {
  for (Vector<3>& p : points) p = turn * p;
  return points;
}
Cloud turned(Cloud points, double angle, const Vector<3>& axis) {
  return turned(std::move(points), Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix());
}
Cloud scaled(Cloud points, double factor) {
  for (Vector<3>& p : points) p *= factor;
  return points;
}

Shape<3> block_of(const Cloud& points) { return shape_of(hull_of(points)); }

Shape<3> turned_block(const Cloud& points, double about_x, double then_about_z) {
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(then_about_z, z_axis) * Eigen::AngleAxisd(about_x, x_axis)).toRotationMatrix();
  Polyhedron polyhedron = hull_of(points);
  for (Vector<3>& p : polyhedron.vertices) p = turn * p;
  for (Vector<3>& n : polyhedron.normals) n = turn * n;
  return shape_of(polyhedron);
}

Shape<3> random_block(Random& random, int count) { return block_of(random_cloud(random, count, 1, 1)); }

Separation<3> pair_of_largest_gap(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b) {
  Separation<3> best{-HUGE_VAL, {}, {}};
  const auto judge = [&](Pair pair) {
    const double gap = refresh(a, b, to_b, pair);
    // To rounding a face comes before edges in its plane.
    const double margin = pair.kind == Pair::edge_edge ? 1e-12 * std::abs(best.gap) : 0;
    if (gap > best.gap + margin) best = {gap, pair, normal_of(a, b, pair)};
  };
  for (int f = 0; f < a.face_count(); ++f) judge({Pair::face_vertex, f, 0});
  for (int f = 0; f < b.face_count(); ++f) judge({Pair::vertex_face, 0, f});
  for (int i = 0; i < a.topology->edge_count; ++i)
    for (int j = 0; j < b.topology->edge_count; ++j) judge({Pair::edge_edge, i, j});
  return best;
}

Met meet(const Shape<3>& a, const Shape<3>& b, const Vector<3>& to_b, const PairCache<3>& witness,
         const DetectOptions& options) {
  Met met{{}, witness};
  const Separation<3> found = pair_of_largest_gap(a.outline(), b.outline(), to_b);
  if (found.gap > 0) {
    met.witness = witness_of(found);
  } else {
    describe_overlap(a.outline(), b.outline(), to_b, found.pair, options, met.witness, met.contact);
  }
  return met;
}

PairCache<3> touching_through(const Shape<3>& a, const Vector<3>& direction) {
  const Outline<3>& o = a.outline();
  Pair pair{Pair::face_vertex, 0, 0};
  for (int f = 1; f < o.face_count(); ++f)
    if (o.normal(f).dot(direction) > o.normal(pair.a).dot(direction)) pair.a = f;
  return {PairCache<3>::touching, pair};
}

PairCache<3> swapped(const PairCache<3>& witness) {
  const Pair& p = witness.pair;
  const Pair::Kind kind = p.kind == Pair::face_vertex   ? Pair::vertex_face
                          : p.kind == Pair::vertex_face ? Pair::face_vertex
                                                        : p.kind;
  return {witness.state, {kind, p.b, p.a}, -witness.proof};
}

void check_by_definition(const Shape<3>& a, const Shape<3>& b, const Vector<3>& to_b, const Contact<3>& c) {
  const double margin = 1e-12 * (a.bounding_radius() + b.bounding_radius());
  CHECK(c.normal.norm() == Approx(1).epsilon(1e-14));
  CHECK(c.gap <= 0);
  CHECK(c.point_count >= 1);
  CHECK(c.point_count <= max_region_points);
  const bool in_middle = c.type == ContactType::edge_edge;
  for (int i = 0; i < c.point_count; ++i) {
    const Vector<3> from = in_middle ? c.points[i] - 0.5 * c.gaps[i] * c.normal : c.points[i];
    const Vector<3> to = from + c.gaps[i] * c.normal;
    const bool a_first = c.pair.kind != Pair::vertex_face;
    const Vector<3> on_a = a_first ? from : from - c.gaps[i] * c.normal;
    const Vector<3> on_b = a_first ? to : from;
    CHECK(c.gaps[i] >= c.gap);
    CHECK(std::abs(c.normal.dot(c.points[i] - c.center)) <= margin);
    if (c.type == ContactType::vertex_vertex || c.type == ContactType::vertex_edge) continue;
    CHECK(is_behind_faces(a, on_a, margin));
    CHECK(is_behind_faces(b, on_b - to_b, margin));
  }
}

}  // namespace halfspace::test
