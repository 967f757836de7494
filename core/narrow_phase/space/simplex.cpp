#include "narrow_phase/space/simplex.h"

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

/// The face of a simplex with the point nearest to the origin: its newest corner, and its other corners. The
/// newest always belongs to it, as it is beyond the plane, normal to the direction of the origin, that bounds
/// the others.
struct Nearest {
  int other[3];
  int count;  // of the other corners
  Vector<3> point;
};

/// The nearest point on the segment from the newest corner to another one.
Nearest on_segment(const Vector<3>& newest, const Vector<3>& to, double towards_origin, int other) {
  const double share = std::min(1.0, towards_origin / to.squaredNorm());
  return {{other}, 1, newest + share * to};
}

/// The nearest point on the triangle with two others: at the newest corner, on a side from it, or inside,
/// decided by signs (Ericson 2005, section 5.1.5).
Nearest on_triangle(const Vector<3>& newest, const Vector<3>& to_i, const Vector<3>& to_j, int i, int j) {
  const double along_i = -to_i.dot(newest), along_j = -to_j.dot(newest);
  if (along_i <= 0 && along_j <= 0) return {{}, 0, newest};
  const double ii = to_i.squaredNorm(), ij = to_i.dot(to_j), jj = to_j.squaredNorm();
  const double share_i = along_i * jj - along_j * ij, share_j = along_j * ii - along_i * ij;
  if (share_j <= 0 && along_i > 0) return on_segment(newest, to_i, along_i, i);
  if (share_i <= 0 && along_j > 0) return on_segment(newest, to_j, along_j, j);
  const double whole = ii * jj - ij * ij;
  return {{i, j}, 2, newest + (share_i / whole) * to_i + (share_j / whole) * to_j};
}

/// The nearest point on the tetrahedron with all three others, or the origin if it is inside.
Nearest in_tetrahedron(const Vector<3>& newest, const Vector<3>* to) {
  const Vector<3> normal[] = {cross_product(to[0], to[1]), cross_product(to[1], to[2]),
                              cross_product(to[2], to[0])};
  const double volume = normal[0].dot(to[2]);  // six times the volume: the side of each face's fourth corner
  Nearest best{{0, 1, 2}, 3, Vector<3>::Zero()};
  double least = HUGE_VAL;
  for (int i = 0; i < 3; ++i) {
    const double origin = -normal[i].dot(newest);
    if ((origin > 0 && volume > 0) || (origin < 0 && volume < 0)) continue;
    const int j = i == 2 ? 0 : i + 1;
    const Nearest candidate = on_triangle(newest, to[i], to[j], i, j);
    const double distance = candidate.point.squaredNorm();
    if (distance < least) {
      least = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace

void Simplex::add(const Corner& c) {
  Vector<3> to[3];
  for (int i = 0; i < count; ++i) to[i] = corner[i].at - c.at;
  Nearest found{{}, 0, c.at};
  if (count == 1) {
    const double along = -to[0].dot(c.at);
    if (along > 0) found = on_segment(c.at, to[0], along, 0);
  }
  if (count == 2) found = on_triangle(c.at, to[0], to[1], 0, 1);
  if (count == 3) found = in_tetrahedron(c.at, to);
  nearest = found.point;
  Corner others[3];
  for (int i = 0; i < found.count; ++i) others[i] = corner[found.other[i]];
  std::copy_n(others, found.count, corner);
  corner[found.count] = c;
  count = found.count + 1;
}

}  // namespace halfspace
