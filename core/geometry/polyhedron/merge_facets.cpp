#include "geometry/polyhedron/merge_facets.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/polyhedron/facets.h"
#include "geometry/polyhedron/simplify.h"
#include "geometry/polyhedron/topology.h"

namespace halfspace {
namespace {

double longest_side(const Polyhedron& surface, std::int32_t facet) {
  double longest = 0;
  for (std::size_t i = 1; i < surface.loop(facet).size(); ++i)
    longest = std::max(longest, (surface.corner(facet, i) - surface.corner(facet, 0)).norm());
  return longest;
}

/// The smallest distance of two parallel planes around four points, through a face of their tetrahedron or
/// two opposite edges.
double thickness_of(const Vector<3>& a, const Vector<3>& b, const Vector<3>& c, const Vector<3>& d) {
  const Vector<3> u = b - a, v = c - a, w = d - a;
  double largest = 0;
  for (const Vector<3>& area :
       {cross_product(u, v), cross_product(u, w), cross_product(v, w), cross_product(v - u, w - u),
        cross_product(u, w - v), cross_product(v, w - u), cross_product(w, v - u)})
    largest = std::max(largest, area.norm());
  return largest > 0 ? std::abs(cross_product(u, v).dot(w)) / largest : 0;
}

class Merging {
 public:
  Merging(const Polyhedron& surface, double tolerance)
      : surface_(surface),
        tolerance_(tolerance),
        half_edges_(surface),
        areas_(surface.memory()),
        face_of_vertex_(surface.vertices.size(), -1, surface.memory()),
        corners_(surface.memory()),
        open_(surface.memory()),
        merged_(surface.memory()) {
    for (std::int32_t f = 0; f < surface.face_count(); ++f) areas_.push_back(area_vector(surface, f));
    merged_.face_of_facet.assign(std::size_t(surface.face_count()), -1);
  }

  MergedFacets merge() {
    for (const std::int32_t facet : by_area()) {
      if (merged_.face_of_facet[std::size_t(facet)] < 0) grow_from(facet);
    }
    return std::move(merged_);
  }

 private:
  Array<std::int32_t> by_area() const {
    Array<std::int32_t> order(areas_.size(), surface_.memory());
    for (std::size_t f = 0; f < order.size(); ++f) order[f] = std::int32_t(f);
    const auto squared_area = [&](std::int32_t f) { return areas_[std::size_t(f)].squaredNorm(); };
    std::sort(order.begin(), order.end(), [&](std::int32_t f, std::int32_t g) {
      return squared_area(f) > squared_area(g) || (squared_area(f) == squared_area(g) && f < g);
    });
    return order;
  }

  void grow_from(std::int32_t seed) {
    corners_.clear();
    area_ = areas_[std::size_t(seed)];
    add_corners(seed);
    FittedPlane plane;
    if (!area_.isZero(0)) plane = fit_plane(corners_, area_);
    take(seed);
    for (open_.assign(1, seed); !open_.empty();) {
      const std::int32_t facet = open_.back();
      open_.pop_back();
      for_each_neighbour(facet, [&](std::int32_t neighbour) { try_to_take(neighbour, plane); });
    }
    if (corners_.size() > corners_per_fit && plane.deviation <= tolerance_) {
      const FittedPlane fitted = fit_plane(corners_, area_);
      if (fitted.deviation <= tolerance_) plane = fitted;
    }
    merged_.planes.push_back(plane);
  }

  void try_to_take(std::int32_t facet, FittedPlane& plane) {
    if (merged_.face_of_facet[std::size_t(facet)] >= 0 || !(plane.deviation <= tolerance_)) return;
    const Vector<3>& area = areas_[std::size_t(facet)];
    if (area.dot(plane.plane.normal) <= 0 && !is_narrow(facet)) return;
    const std::size_t before = corners_.size();
    add_corners(facet);
    FittedPlane wider = plane;
    if (is_too_thick(before))
      wider.deviation = HUGE_VAL;
    else if (before > corners_per_fit && deviation_with_new(before, plane) <= tolerance_)
      wider.deviation = deviation_with_new(before, plane);
    else if (corners_.size() > before)
      wider = fit_plane(corners_, area_ + areas_[std::size_t(facet)]);
    if (!(wider.deviation <= tolerance_)) {
      corners_.resize(before);
      forget_corners(facet);
      return;
    }
    plane = wider;
    area_ += area;
    take(facet);
    open_.push_back(facet);
  }

  /// A fit visits all corners. With more of them, a face takes corners that are within the tolerance of its
  /// plane without another fit until the last one.
  static constexpr std::size_t corners_per_fit = 64;

  double deviation_with_new(std::size_t old_count, const FittedPlane& plane) const {
    double deviation = plane.deviation;
    for (std::size_t i = old_count; i < corners_.size(); ++i)
      deviation = std::max(deviation, std::abs(plane.plane.depth(corners_[i])));
    return deviation;
  }

  /// True if four corners show that no plane is within the tolerance of all, which a fit would visit one by
  /// one.
  bool is_too_thick(std::size_t old_count) const {
    return std::any_of(
        corners_.begin() + std::ptrdiff_t(old_count), corners_.end(), [&](const Vector<3>& added) {
          return thickness_of(corners_[0], corners_[old_count / 3], corners_[2 * old_count / 3], added) >
                 4 * tolerance_;
        });
  }

  /// Adds the corners that the growing face does not have yet.
  void add_corners(std::int32_t facet) {
    for (const std::int32_t v : surface_.loop(facet)) {
      if (face_of_vertex_[std::size_t(v)] == growing()) continue;
      if (face_of_vertex_[std::size_t(v)] != tried()) corners_.push_back(surface_.vertices[std::size_t(v)]);
      face_of_vertex_[std::size_t(v)] = tried();
    }
  }
  void forget_corners(std::int32_t facet) {
    for (const std::int32_t v : surface_.loop(facet)) {
      if (face_of_vertex_[std::size_t(v)] == tried()) face_of_vertex_[std::size_t(v)] = -1;
    }
  }
  void take(std::int32_t facet) {
    merged_.face_of_facet[std::size_t(facet)] = growing();
    for (const std::int32_t v : surface_.loop(facet)) face_of_vertex_[std::size_t(v)] = growing();
  }

  /// The normal of a facet narrower than the tolerance may be reversed by the rounding of its corners.
  bool is_narrow(std::int32_t facet) const {
    return areas_[std::size_t(facet)].norm() <= 2 * tolerance_ * longest_side(surface_, facet);
  }

  template <class Visit>
  void for_each_neighbour(std::int32_t facet, Visit visit) const {
    for (std::int32_t h = surface_.first_of_face[std::size_t(facet)];
         h < surface_.first_of_face[std::size_t(facet) + 1]; ++h) {
      visit(half_edges_.face(half_edges_.twin(h)));
    }
  }

  std::int32_t growing() const { return std::int32_t(merged_.planes.size()); }
  static constexpr std::int32_t tried() { return -2; }

  const Polyhedron& surface_;
  double tolerance_;
  HalfEdges half_edges_;
  Array<Vector<3>> areas_;  // twice the areas
  Array<std::int32_t> face_of_vertex_;
  Array<Vector<3>> corners_;  // of the growing face
  Vector<3> area_ = Vector<3>::Zero();
  Array<std::int32_t> open_;  // facets whose neighbours have not been tried yet
  MergedFacets merged_;
};

}  // namespace

MergedFacets merge_facets(const Polyhedron& surface, double tolerance) {
  return Merging(surface, tolerance).merge();
}

Polyhedron outlines_of(const Polyhedron& surface, const MergedFacets& faces) {
  const HalfEdges half_edges(surface);
  const auto face_at = [&](std::int32_t h) { return faces.face_of_facet[std::size_t(half_edges.face(h))]; };
  const auto is_outer = [&](std::int32_t h) { return face_at(h) != face_at(half_edges.twin(h)); };
  Array<char> is_made(faces.planes.size(), 0, surface.memory());
  Polyhedron outlines(surface.memory());
  outlines.vertices = surface.vertices;
  for (std::int32_t begin = 0; begin < half_edges.count(); ++begin) {
    if (!is_outer(begin) || std::exchange(is_made[std::size_t(face_at(begin))], 1)) continue;
    std::int32_t h = begin;
    do {
      outlines.append_corner(half_edges.start(h));
      for (h = half_edges.next(h); !is_outer(h);) h = half_edges.next(half_edges.twin(h));
    } while (h != begin);
    outlines.end_face();
  }
  outlines.normals.resize(std::size_t(outlines.face_count()));
  drop_degenerate(outlines);
  return outlines;
}

}  // namespace halfspace
