#include "geometry/polyhedron/merge_facets.h"

#include <algorithm>

#include "geometry/polyhedron/facets.h"
#include "geometry/polyhedron/topology.h"

namespace halfspace {
namespace {

double longest_side(const Polyhedron& surface, std::int32_t facet) {
  double longest = 0;
  for (std::size_t i = 1; i < surface.loop(facet).size(); ++i)
    longest = std::max(longest, (surface.corner(facet, i) - surface.corner(facet, 0)).norm());
  return longest;
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
    merged_.planes.push_back(plane);
  }

  void try_to_take(std::int32_t facet, FittedPlane& plane) {
    if (merged_.face_of_facet[std::size_t(facet)] >= 0 || !(plane.deviation <= tolerance_)) return;
    const Vector<3>& area = areas_[std::size_t(facet)];
    if (area.dot(plane.plane.normal) <= 0 && !is_narrow(facet)) return;
    const std::size_t before = corners_.size();
    add_corners(facet);
    const FittedPlane wider =
        corners_.size() == before ? plane : fit_plane(corners_, area_ + areas_[std::size_t(facet)]);
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

}  // namespace halfspace
