#include "narrow_phase/closest_points.h"

#include <algorithm>
#include <cmath>

#include "geometry/tolerances.h"
#include "narrow_phase/plane/posed_pair.h"
#include "narrow_phase/plane/separation.h"
#include "narrow_phase/plane/vertex_edge_distance.h"
#include "narrow_phase/space/separation.h"
#include "narrow_phase/space/simplex.h"

// GJK without an early end: the simplex moves towards the origin until no corner of the Minkowski difference
// is nearer.
//
//   normal <- direction from the origin to the nearest point of the simplex
//   corner <- support of the difference along the normal, towards the origin
//   repeat: the corner is not in front of the simplex? then its nearest point is that of the difference
//           add the corner to the simplex, and keep its face nearest to the origin
//
// The weights of the last simplex's corners are those of the vertices of both blocks.

namespace halfspace {
namespace {

Vector<3> in_space(const Vector<2>& v) { return {v.x(), v.y(), 0}; }
const Vector<3>& in_space(const Vector<3>& v) { return v; }

template <int D>
Vector<D> in_frame(const Vector<3>& v) {
  return v.head<D>();
}

/// The Minkowski difference of two polygons, in the frame of a, with z = 0.
class DifferenceInPlane {
 public:
  DifferenceInPlane(const Outline<2>& a, const Outline<2>& b, const Frames<2>& frames)
      : a_(a), b_(b), b_in_a_(frames.b_in_a()), to_b_(frames.to_b()) {}

  Corner deepest_along(const Vector<3>& direction, const Corner& near) const {
    const Vector<2> along = direction.head<2>();
    const int of_a = deepest_vertex(a_, -along, near.a);
    const int of_b = deepest_vertex(b_, b_in_a_.inverse() * along, near.b);
    return {in_space(Vector<2>(vertex_of_b(of_b) - a_.vertex(of_a))), of_a, of_b};
  }
  Vector<2> vertex_of_a(int vertex) const { return a_.vertex(vertex); }
  Vector<2> vertex_of_b(int vertex) const { return b_in_a_ * b_.vertex(vertex) + to_b_; }

 private:
  const Outline<2>& a_;
  const Outline<2>& b_;
  Rotation<2> b_in_a_;
  Vector<2> to_b_;
};

/// The Minkowski difference of two polyhedra, in the frame of a.
class DifferenceInSpace : public MinkowskiDifference<Rotation<3>> {
 public:
  DifferenceInSpace(const Outline<3>& a, const Outline<3>& b, const Frames<3>& frames)
      : MinkowskiDifference(a, b, frames.to_b, frames.b_in_a) {}

  Vector<3> vertex_of_a(int vertex) const { return a().vertex(vertex); }
};

DifferenceInPlane difference_of(const Outline<2>& a, const Outline<2>& b, const Frames<2>& frames) {
  return {a, b, frames};
}
DifferenceInSpace difference_of(const Outline<3>& a, const Outline<3>& b, const Frames<3>& frames) {
  return {a, b, frames};
}

/// The plane of detection between the blocks, in the host's orientation; its gap is not positive in contact.
struct Detected {
  double gap;
  Vector<3> normal;
};
Detected detect(const PosedPair<2>& posed, const Frames<2>& frames, Memory* room) {
  PairOptions options;
  options.with_region = false;
  PairCache<2> unknown;
  const Contact<2> found = search_pair(posed, frames, options, unknown, room);
  return {found.gap, in_space(found.normal)};
}
Detected detect(const PosedPair<3>& posed, const Frames<3>& frames, Memory*) {
  const Separation<3> found =
      find_separation(posed.a.outline(), posed.b.outline(), frames.to_b, frames.b_in_a);
  return {found.gap, frames.of_a * found.normal};
}
Rotation<2> orientation_of_a(const Frames<2>& frames) { return frames.of_a(); }
const Rotation<3>& orientation_of_a(const Frames<3>& frames) { return frames.of_a; }
Vector<2> centroid_of_b(const Frames<2>& frames) { return frames.to_b(); }
const Vector<3>& centroid_of_b(const Frames<3>& frames) { return frames.to_b; }

/// The weights of a simplex's corners at its point nearest to the origin, relative to the newest corner.
/// False if that point is outside of the simplex, across from the newest corner.
bool weigh(const Simplex& simplex, double weight[4]) {
  const int others = simplex.count - 1;
  const Vector<3>& newest = simplex.corner[others].at;
  Vector<3> to[3];
  for (int i = 0; i < others; ++i) to[i] = simplex.corner[i].at - newest;
  if (others == 1) weight[0] = -to[0].dot(newest) / to[0].squaredNorm();
  if (others == 2) {
    const Vector<3> normal = cross_product(to[0], to[1]);
    weight[0] = -normal.dot(cross_product(newest, to[1])) / normal.squaredNorm();
    weight[1] = -normal.dot(cross_product(to[0], newest)) / normal.squaredNorm();
  }
  if (others == 3) {
    const double volume = cross_product(to[0], to[1]).dot(to[2]);
    for (int i = 0; i < 3; ++i)
      weight[i] = -cross_product(to[(i + 1) % 3], to[(i + 2) % 3]).dot(newest) / volume;
  }
  double sum = 0;
  for (int i = 0; i < others; ++i) sum += weight[i] = std::clamp(weight[i], 0.0, 1.0);
  weight[others] = std::max(0.0, 1 - sum);
  return sum <= 1;
}

/// A simplex around the origin has one corner more than the space has dimensions.
template <int D>
bool contains_origin(const Simplex& simplex) {
  return simplex.count == D + 1 || simplex.nearest.isZero(0);
}

const Vector<3>& newest_of(const Simplex& simplex) { return simplex.corner[simplex.count - 1].at; }

/// The direction from the origin to the nearest point of a simplex, normal to all of its edges. That point
/// has the rounding errors of the corners, so close to the origin the edges define the direction more
/// accurately, unless a triangle is narrower than its distance.
template <int D>
Vector<3> normal_of(const Simplex& simplex) {
  const Vector<3>& nearest = simplex.nearest;
  const double distance = nearest.norm();
  if (simplex.count == 1) return nearest / distance;
  const Vector<3> along = simplex.corner[0].at - newest_of(simplex);
  if (simplex.count == D) {
    const Vector<3> across =
        D == 2 ? Vector<3>(0, 0, 1) : Vector<3>(simplex.corner[1].at - newest_of(simplex));
    const Vector<3> normal = cross_product(along, across);
    const double length = normal.norm(), longest = D == 2 ? 1 : std::max(along.norm(), across.norm());
    if (length > distance * longest) return (normal.dot(nearest) < 0 ? -1 : 1) / length * normal;
  } else {
    const Vector<3> edge = along.normalized();
    Vector<3> across = nearest / distance;
    for (int times = 0; times < 2; ++times) across -= across.dot(edge) * edge;
    if (!across.isZero(0)) return across.normalized();
  }
  return nearest / distance;
}

/// The simplex of the point of the difference that is nearest to the origin, and the size of the difference.
struct Found {
  Simplex simplex;
  double size;
};

template <int D, class Difference>
Found find_nearest(const Difference& difference, const Vector<3>& start) {
  Corner corner = difference.deepest_along(start, {start, 0, 0});
  Found found;
  Simplex& simplex = found.simplex;
  simplex.add(corner);
  found.size = corner.at.norm();
  while (!contains_origin<D>(simplex)) {
    const Vector<3> normal = normal_of<D>(simplex);
    corner = difference.deepest_along(normal, corner);
    found.size = std::max(found.size, corner.at.norm());
    const double progress = normal.dot(newest_of(simplex) - corner.at);
    if (progress <= 2 * machine_epsilon * found.size || simplex.has(corner)) break;
    Simplex next = simplex;
    next.add(corner);
    if (!(next.nearest.squaredNorm() < simplex.nearest.squaredNorm())) break;  // to rounding
    // Four corners of one face of the difference: rounding decides which three remain.
    if (double weight[4]; D == 3 && next.count == 3 && !weigh(next, weight)) break;
    simplex = next;
  }
  return found;
}

}  // namespace

template <int D>
ClosestPoints<D> find_closest_points(const PosedPair<D>& posed, Memory* room) {
  const Frames<D> frames = frames_of<D>(posed.at_a, posed.at_b);
  const auto difference = difference_of(posed.a.outline(), posed.b.outline(), frames);
  Vector<3> start = in_space(centroid_of_b(frames));
  if (start.squaredNorm() == 0) start = {1, 0, 0};  // the length may underflow
  const auto [simplex, size] = find_nearest<D>(difference, start);

  double weight[4];
  weigh(simplex, weight);
  const auto of_a = orientation_of_a(frames);
  ClosestPoints<D> closest{0, Vector<D>::Zero(), Vector<D>::Zero(), Vector<D>::Zero()};
  for (int i = 0; i < simplex.count; ++i) {
    closest.on_a += weight[i] * difference.vertex_of_a(simplex.corner[i].a);
    closest.on_b += weight[i] * difference.vertex_of_b(simplex.corner[i].b);
  }
  closest.on_a = of_a * closest.on_a;
  closest.on_b = of_a * closest.on_b;

  Vector<3> normal = Vector<3>::Zero();
  double distance = 0;
  if (!contains_origin<D>(simplex)) {
    normal = normal_of<D>(simplex);
    distance = normal.dot(newest_of(simplex));
  }
  // Close blocks: detection decides whether they touch. Simplices of slivers in the plane have large errors.
  if (distance <= sure_distance<D> * size) {
    const Detected detected = detect(posed, frames, room);
    if (!(detected.gap > 0)) return closest;
    if constexpr (D == 2) {
      const VertexAndEdge found = closest_vertex_and_edge(posed.a.outline(), posed.b.outline(), frames);
      if (found.distance < HUGE_VAL)
        return {found.distance, of_a * found.on_a, of_a * found.on_b, of_a * found.normal};
    }
    if (!(distance > 0)) {
      closest.distance = detected.gap;
      closest.normal = in_frame<D>(detected.normal);
      return closest;
    }
  }
  closest.distance = distance;
  closest.normal = of_a * in_frame<D>(normal);
  return closest;
}

template ClosestPoints<2> find_closest_points(const PosedPair<2>&, Memory*);
template ClosestPoints<3> find_closest_points(const PosedPair<3>&, Memory*);

}  // namespace halfspace
