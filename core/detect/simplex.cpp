#include "detect/simplex.h"

#include <cmath>

namespace halfspace {
namespace {

/// The face of a simplex on which the point nearest to the origin lies.
struct Nearest {
  int corner[3];
  int count;
  Vector<3> point;
};

Nearest at_corner(const Corner* c, int i) { return {{i, 0, 0}, 1, c[i].at}; }

Nearest on_segment(const Corner* c, int i, int j) {
  const Vector<3>&p = c[i].at, &q = c[j].at;
  const Vector<3> along = q - p;
  const double t = -p.dot(along), whole = along.squaredNorm();
  if (!(t > 0)) return at_corner(c, i);
  if (t >= whole) return at_corner(c, j);
  return {{i, j, 0}, 2, p + (t / whole) * along};
}

/// By the regions of corners, edges and inside, told apart by signs (Ericson 2005, section 5.1.5).
Nearest on_triangle(const Corner* c, int i, int j, int k) {
  const Vector<3>&p = c[i].at, &q = c[j].at, &r = c[k].at;
  const Vector<3> pq = q - p, pr = r - p;
  const double p1 = -pq.dot(p), p2 = -pr.dot(p);
  if (p1 <= 0 && p2 <= 0) return at_corner(c, i);
  const double q1 = -pq.dot(q), q2 = -pr.dot(q);
  if (q1 >= 0 && q2 <= q1) return at_corner(c, j);
  const double at_r = p1 * q2 - q1 * p2;
  if (at_r <= 0 && p1 >= 0 && q1 <= 0) return on_segment(c, i, j);
  const double r1 = -pq.dot(r), r2 = -pr.dot(r);
  if (r2 >= 0 && r1 <= r2) return at_corner(c, k);
  const double at_q = r1 * p2 - p1 * r2;
  if (at_q <= 0 && p2 >= 0 && r2 <= 0) return on_segment(c, i, k);
  const double at_p = q1 * r2 - r1 * q2;
  if (at_p <= 0 && q2 - q1 >= 0 && r1 - r2 >= 0) return on_segment(c, j, k);
  const double sum = at_p + at_q + at_r;
  return {{i, j, k}, 3, p + (at_q / sum) * pq + (at_r / sum) * pr};
}

/// Count 4 when the origin is inside. It was nearest to the first three corners, and the last one lies beyond
/// it: what is nearest now has the last one among its corners.
Nearest in_tetrahedron(const Corner* c) {
  const Vector<3>& last = c[3].at;
  const Vector<3> to[] = {c[0].at - last, c[1].at - last, c[2].at - last};
  Nearest best{{}, 4, Vector<3>::Zero()};
  double least = HUGE_VAL;
  for (int i = 0; i < 3; ++i) {
    const int j = i == 2 ? 0 : i + 1, opposite = i == 0 ? 2 : i - 1;
    const Vector<3> normal = cross_product(to[i], to[j]);
    const double origin = -normal.dot(last), inside = normal.dot(to[opposite]);
    if ((origin > 0 && inside > 0) || (origin < 0 && inside < 0)) continue;
    const Nearest candidate = on_triangle(c, i, j, 3);
    const double distance = candidate.point.squaredNorm();
    if (distance < least) {
      least = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace

void Simplex::keep(const int* kept, int kept_count) {
  const Corner all[4] = {corner[0], corner[1], corner[2], corner[3]};
  for (int i = 0; i < kept_count; ++i) corner[i] = all[kept[i]];
  count = kept_count;
}

void Simplex::add(const Corner& c) {
  corner[count++] = c;
  Nearest found = at_corner(corner, 0);
  if (count == 2) found = on_segment(corner, 0, 1);
  if (count == 3) found = on_triangle(corner, 0, 1, 2);
  if (count == 4) found = in_tetrahedron(corner);
  nearest = found.point;
  if (found.count < 4) keep(found.corner, found.count);
}

}  // namespace halfspace
