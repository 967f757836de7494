#include "force/potential/potential_force.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "force/potential/field_force.h"
#include "geometry/halfspace.h"
#include "geometry/polygon/clip.h"
#include "simd/two_lanes.h"

// The potential of a block at a point is the depth behind the nearest edge. Its force on another block is the
// sum over cells of their overlap, one for each edge that is the nearest to some point:
//
//   near edges      the other block's least depth behind the edge is at most its reach: the minimum over the
//                   edges of the depth of its deepest vertex
//   intersection    the other block cut by the near edges of the owner
//   cell of an edge the intersection cut by the half-planes where that edge is nearer than each other one
//   sum             the cell's area times the edge's normal, at the cell's centroid

namespace halfspace {
namespace {

/// The half-plane of an edge of a block at `shift`.
Halfspace<2> half_plane(const Outline<2>& block, int edge, const Vector<2>& shift) {
  const Vector<2> normal = block.normal(edge);
  return {normal, block.offset[edge] + normal.dot(shift)};
}

/// A convex polygon in its own memory, cut by one half-plane after another.
class Polygon {
 public:
  Polygon(Vector<2>* corners, std::size_t room) : corner_(corners), room_(int(room)) {}

  bool is_empty() const { return count_ < 3; }
  void clear() { count_ = 0; }
  void add(const Vector<2>& p) {
    if (count_ < room_) corner_[count_++] = p;
  }

  /// Keeps the part of another polygon inside the half-plane.
  void keep_inside(const Polygon& whole, const Halfspace<2>& half_plane) {
    count_ = 0;
    if (whole.is_empty()) return;
    clip(
        whole.corners(), [&](const Vector<2>& p) { return -half_plane.depth(p); }, 0,
        [&](const Vector<2>& p) { add(p); });
  }

  void exchange(Polygon& other) { std::swap(*this, other); }
  std::span<const Vector<2>> corners() const { return {corner_, std::size_t(count_)}; }

 private:
  Vector<2>* corner_;
  int room_;
  int count_ = 0;
};

/// Area and its first moment about one of the corners, which stays accurate far from the origin.
struct Area {
  double content = 0;
  Vector<2> corner = Vector<2>::Zero();
  Vector<2> moment = Vector<2>::Zero();

  /// Subtracts a part.
  Area& operator-=(const Area& part) {
    content -= part.content;
    moment -= part.moment + part.content * (part.corner - corner);
    return *this;
  }
};

Area measure(const Polygon& polygon) {
  Area sum;
  if (polygon.is_empty()) return sum;
  const std::span<const Vector<2>> corner = polygon.corners();
  sum.corner = corner[0];
  Vector<2> p = corner[1] - corner[0];
  for (std::size_t i = 2; i < corner.size(); ++i) {
    const Vector<2> q = corner[i] - corner[0];
    const double twice = cross(p, q);
    sum.content += twice;
    sum.moment += twice * (p + q);
    p = q;
  }
  sum.content *= 0.5;
  sum.moment /= 6;
  return sum;
}

/// Mean of r r^T about the centroid.
Tensor<2> spread_of(const Polygon& polygon, const Area& area) {
  const std::span<const Vector<2>> corner = polygon.corners();
  Tensor<2> sum = Tensor<2>::Zero();
  Vector<2> p = corner[1] - corner[0];
  for (std::size_t i = 2; i < corner.size(); ++i) {
    const Vector<2> q = corner[i] - corner[0], both = p + q;
    sum += cross(p, q) * (p * p.transpose() + q * q.transpose() + both * both.transpose());
    p = q;
  }
  const Vector<2> way = area.moment / area.content;
  return sum / (24 * area.content) - way * way.transpose();
}

/// One of the two blocks, at `shift` from the centroid of a, and its near edges.
struct Owner {
  const Outline<2>& block;
  Vector<2> shift;
  std::span<std::int32_t> near;

  Halfspace<2> half_plane(std::int32_t edge) const { return halfspace::half_plane(block, edge, shift); }
};

/// No point of the other block is deeper in the owner than its reach, the minimum over the edges of the depth
/// of its deepest vertex. An edge behind which all of it is deeper is never the nearest. No edge is near when
/// the other block is outside; else the first one is the edge of the minimum.
void find_near_edges(Owner& owner, const Outline<2>& other, const Vector<2>& shift_of_other,
                     double* min_depth) {
  const Outline<2>& block = owner.block;
  const Vector<2> to_other = shift_of_other - owner.shift;
  TwoLanes reach = both(HUGE_VAL), reaching{}, edge{0, 1};
  for (int e = 0; e < block.count; e += 2, edge += both(2)) {
    const TwoLanes nx = load_two(block.nx + e), ny = load_two(block.ny + e);
    const TwoLanes offset = load_two(block.offset + e) - nx * both(to_other.x()) - ny * both(to_other.y());
    TwoLanes least = both(HUGE_VAL), most = both(-HUGE_VAL);
    for (int v = 0; v < other.count; ++v) {
      const TwoLanes depth = offset - nx * both(other.x[v]) - ny * both(other.y[v]);
      least = min(least, depth);
      most = max(most, depth);
    }
    store_two(min_depth + e, least);
    reaching = most < reach ? edge : reaching;
    reach = min(most, reach);
  }
  const double depth = std::min(reach[0], reach[1]);
  const int first = std::min(int(reach[1] < reach[0] ? reaching[1] : reaching[0]), block.count - 1);
  std::size_t count = 0;
  if (depth > 0) owner.near[count++] = first;
  for (int e = 0; depth > 0 && e < block.count; ++e) {
    if (min_depth[e] <= depth && e != first) owner.near[count++] = e;
  }
  owner.near = owner.near.first(count);
}

void add_cell(const Area& cell, const Halfspace<2>& nearest, FieldForce<2>& sum) {
  if (!(cell.content > 0)) return;
  const double energy = cell.content * nearest.depth(cell.corner) - nearest.normal.dot(cell.moment);
  sum.add_cell(cell.content, cell.content * cell.corner + cell.moment, energy, nearest.normal);
}

/// The half-plane in which one edge is nearer than another.
Halfspace<2> nearer(const Halfspace<2>& edge, const Halfspace<2>& other) {
  return {other.normal - edge.normal, other.offset - edge.offset};
}

/// Sums over the cells: the part of the intersection nearest to each edge. The cell of the first edge is the
/// remainder.
FieldForce<2> field_force(const Owner& owner, const Polygon& intersection, const Area& whole, Polygon cell,
                          Polygon cut) {
  FieldForce<2> sum;
  Area rest = whole;
  for (std::size_t i = 1; i < owner.near.size(); ++i) {
    const Halfspace<2> nearest = owner.half_plane(owner.near[i]);
    const Polygon* left = &intersection;
    for (std::size_t k = 0; k < owner.near.size() && !left->is_empty(); ++k) {
      if (k == i) continue;
      const Halfspace<2> rival = owner.half_plane(owner.near[k]);
      cut.keep_inside(*left, nearer(nearest, rival));
      if (k < i && rival == nearest) cut.clear();  // only one of them gets the cell
      cut.exchange(cell);
      left = &cell;
    }
    const Area found = measure(*left);
    rest -= found;
    add_cell(found, nearest, sum);
  }
  add_cell(rest, owner.half_plane(owner.near[0]), sum);
  return sum;
}

}  // namespace

PotentialForce<2> potential_force(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                                  PotentialRoom<2>& room) {
  room.reserve(std::size_t(std::max(a.count, b.count)));
  const Vector<2> at_a = Vector<2>::Zero();
  Owner of_a{a, at_a, room.near_a}, of_b{b, to_b, room.near_b};
  find_near_edges(of_a, b, to_b, room.min_depth.data());
  find_near_edges(of_b, a, at_a, room.min_depth.data());
  if (of_a.near.empty() || of_b.near.empty()) return {};

  Polygon intersection(room.polygon(0), room.max_corners()), cell(room.polygon(1), room.max_corners()),
      cut(room.polygon(2), room.max_corners());
  for (int v = 0; v < b.count; ++v) intersection.add(b.vertex(v) + to_b);
  for (const std::int32_t edge : of_a.near) {
    cut.keep_inside(intersection, of_a.half_plane(edge));
    cut.exchange(intersection);
  }
  const Area whole = measure(intersection);
  if (!(whole.content > 0)) return {};
  const FieldForce<2> by_a = field_force(of_a, intersection, whole, cell, cut),
                      by_b = field_force(of_b, intersection, whole, cell, cut);
  PotentialForce<2> sum =
      sum_of<2>(by_a, by_b, at_a, to_b, whole.corner + whole.moment / whole.content, whole.content);
  sum.spread = spread_of(intersection, whole);
  return sum;
}

}  // namespace halfspace
