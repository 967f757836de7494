#include <algorithm>
#include <cmath>

#include "force/potential_force.h"

namespace halfspace {
namespace {

/// Points where offset - normal . p >= 0.
struct HalfPlane {
  Vector<2> normal;
  double offset;
  double depth(const Vector<2>& p) const { return offset - normal.dot(p); }
};

/// Cuts off what of a convex polygon is not in the half-plane (Sutherland and Hodgman). `cut` is working
/// room.
void keep_inside(const HalfPlane& half_plane, Array<Vector<2>>& polygon, Array<Vector<2>>& cut) {
  cut.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector<2>&p = polygon[i], &q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const double depth_p = half_plane.depth(p), depth_q = half_plane.depth(q);
    if (depth_p >= 0) cut.push_back(p);
    if ((depth_p < 0) != (depth_q < 0)) cut.push_back(p + depth_p / (depth_p - depth_q) * (q - p));
  }
  polygon.swap(cut);
}

struct AreaAndCentroid {
  double area = 0;
  Vector<2> centroid = Vector<2>::Zero();
};

AreaAndCentroid measure(const Array<Vector<2>>& polygon) {
  AreaAndCentroid sum;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    // From the first vertex, so that no digits are lost far from the origin.
    const Vector<2> p = polygon[i - 1] - polygon[0], q = polygon[i] - polygon[0];
    const double area = 0.5 * cross(p, q);
    sum.area += area;
    sum.centroid += area / 3 * (p + q);
  }
  if (sum.area > 0) sum.centroid = polygon[0] + sum.centroid / sum.area;
  return sum;
}

/// What one block's potential does to the other one, and in return to its owner.
struct FieldForce {
  Vector<2> force = Vector<2>::Zero();  // on the other block
  Tensor<2> virial_of_owner = Tensor<2>::Zero();
  Tensor<2> virial_of_other = Tensor<2>::Zero();
  double energy = 0;
};

/// A block whose potential pushes another one, which lies at `shift` from its centroid.
class Field {
 public:
  Field(const Outline<2>& owner, const Outline<2>& other, const Vector<2>& shift, PotentialRoom<2>& room)
      : owner_(owner), other_(other), shift_(shift), room_(room) {}

  FieldForce force_on_other() {
    find_near_edges();
    find_intersection();
    FieldForce sum;
    for (const std::int32_t edge : room_.near) {
      find_cell(edge);
      const auto [area, centroid] = measure(room_.cell);
      if (!(area > 0)) continue;
      const HalfPlane nearest = half_plane(edge);
      const double depth = nearest.depth(centroid), energy = area * depth;
      const Vector<2> force = area * nearest.normal, foot = centroid + depth * nearest.normal;
      sum.force += force;
      sum.virial_of_owner -= force * foot.transpose();
      sum.virial_of_other += force * (centroid - shift_).transpose() - energy * Tensor<2>::Identity();
      sum.energy += energy;
    }
    return sum;
  }

  /// After force_on_other().
  AreaAndCentroid intersection() const { return measure(room_.intersection); }

 private:
  HalfPlane half_plane(int edge) const { return {owner_.normal(edge), owner_.offset[edge]}; }
  Vector<2> vertex_of_other(int i) const { return other_.vertex(i) + shift_; }

  /// No point of the other block is deeper in the owner than the least, over the edges, of how deep its
  /// vertices reach. An edge that all of it is deeper behind is nowhere the nearest.
  void find_near_edges() {
    const auto over_vertices = [&](int edge, auto best) {
      const HalfPlane h = half_plane(edge);
      double found = h.depth(vertex_of_other(0));
      for (int v = 1; v < other_.count; ++v) found = best(found, h.depth(vertex_of_other(v)));
      return found;
    };
    double reach = HUGE_VAL;
    for (int edge = 0; edge < owner_.count; ++edge)
      reach = std::min(reach, over_vertices(edge, [](double p, double q) { return std::max(p, q); }));
    room_.near.clear();
    for (int edge = 0; edge < owner_.count; ++edge) {
      if (over_vertices(edge, [](double p, double q) { return std::min(p, q); }) <= reach)
        room_.near.push_back(edge);
    }
  }

  void find_intersection() {
    room_.intersection.clear();
    for (int v = 0; v < other_.count; ++v) room_.intersection.push_back(vertex_of_other(v));
    for (const std::int32_t edge : room_.near) keep_inside(half_plane(edge), room_.intersection, room_.cut);
  }

  /// What of the intersection has this edge for its nearest.
  void find_cell(std::int32_t edge) {
    const HalfPlane nearest = half_plane(edge);
    room_.cell = room_.intersection;
    for (const std::int32_t e : room_.near) {
      if (e == edge) continue;
      const HalfPlane farther = half_plane(e);
      keep_inside({farther.normal - nearest.normal, farther.offset - nearest.offset}, room_.cell, room_.cut);
    }
  }

  const Outline<2>& owner_;
  const Outline<2>& other_;
  Vector<2> shift_;
  PotentialRoom<2>& room_;
};

}  // namespace

PotentialForce<2> potential_force(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                                  PotentialRoom<2>& room) {
  Field of_a(a, b, to_b, room);
  const FieldForce by_a = of_a.force_on_other();
  const auto [area, centroid] = of_a.intersection();
  const FieldForce by_b = Field(b, a, -to_b, room).force_on_other();
  return {by_a.force - by_b.force,
          by_a.virial_of_owner + by_b.virial_of_other,
          by_a.virial_of_other + by_b.virial_of_owner,
          centroid,
          area,
          by_a.energy + by_b.energy};
}

}  // namespace halfspace
