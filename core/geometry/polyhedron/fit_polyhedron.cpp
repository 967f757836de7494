#include "geometry/polyhedron/fit_polyhedron.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/box.h"
#include "geometry/polyhedron/facets.h"
#include "geometry/polyhedron/halfspaces.h"
#include "geometry/polyhedron/hull.h"
#include "geometry/polyhedron/merge_facets.h"
#include "geometry/polyhedron/support_tree.h"
#include "geometry/polyhedron/surface.h"

namespace halfspace {
namespace {

Polyhedron moved_by(const Polyhedron& polyhedron, const Vector<3>& shift) {
  Polyhedron moved(polyhedron, polyhedron.memory());
  for (Vector<3>& v : moved.vertices) v += shift;
  return moved;
}

/// The depth of a facet's lowest corner below the hull's plane nearest to the facet.
struct Dent {
  double depth = 0;
  std::int64_t vertex = -1;
  std::int64_t facet = -1;
};

Dent lowest_corner(const Polyhedron& surface, std::int32_t facet, const Polyhedron& hull, std::int32_t face) {
  Dent lowest{0, surface.loop(facet)[0], facet};
  const Vector<3>& normal = hull.normals[std::size_t(face)];
  for (const std::int32_t v : surface.loop(facet)) {
    const double depth = normal.dot(hull.corner(face, 0) - surface.vertices[std::size_t(v)]);
    if (depth > lowest.depth) lowest = {depth, v, facet};
  }
  return lowest;
}

Dent largest_dent(const Polyhedron& surface, const Polyhedron& hull) {
  Dent largest;
  for (std::int32_t f = 0; f < surface.face_count(); ++f) {
    Dent nearest{HUGE_VAL, -1, -1};
    for (std::int32_t g = 0; g < hull.face_count(); ++g) {
      const Dent dent = lowest_corner(surface, f, hull, g);
      if (dent.depth < nearest.depth) nearest = dent;
    }
    if (nearest.depth > largest.depth) largest = nearest;
  }
  return largest;
}

/// The largest distance of a vertex from the planes of its faces, or in front of another plane.
double deviation_of(const Polyhedron& surface, const MergedFacets& faces) {
  const SupportTree vertices(surface.vertices, surface.memory());
  double largest = 0;
  for (const FittedPlane& face : faces.planes) {
    largest = std::max(largest, face.deviation);
    const auto height = [&](const Vector<3>& v) { return -face.plane.depth(v); };
    largest = std::max(largest, vertices.highest(face.plane.normal, largest, height).height);
  }
  return largest;
}

/// The faces of each vertex, each once.
Array<Array<std::int32_t>> faces_of_vertices(const Polyhedron& surface, const MergedFacets& faces) {
  Array<Array<std::int32_t>> found(surface.vertices.size(), surface.memory());
  for (std::int32_t f = 0; f < surface.face_count(); ++f) {
    const std::int32_t face = faces.face_of_facet[std::size_t(f)];
    for (const std::int32_t v : surface.loop(f)) {
      Array<std::int32_t>& own = found[std::size_t(v)];
      if (std::find(own.begin(), own.end(), face) == own.end()) own.push_back(face);
    }
  }
  return found;
}

/// A corner moves to the nearest new vertex; any other vertex to the planes of its faces.
double largest_movement(const Polyhedron& surface, const MergedFacets& faces, const Polyhedron& made) {
  const auto is_before = [](const Vector<3>& a, const Vector<3>& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  Array<Vector<3>> corners(made.vertices, surface.memory());
  std::sort(corners.begin(), corners.end(), is_before);
  const Array<Array<std::int32_t>> faces_of = faces_of_vertices(surface, faces);
  double largest = 0;
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    const Vector<3>& given = surface.vertices[v];
    double moved = faces_of[v].size() < 3 ? 0 : HUGE_VAL;
    if (faces_of[v].size() < 3) {
      for (const std::int32_t face : faces_of[v])
        moved = std::max(moved, std::abs(faces.planes[std::size_t(face)].plane.depth(given)));
    } else if (std::binary_search(corners.begin(), corners.end(), given, is_before)) {
      moved = 0;
    } else {
      for (const Vector<3>& corner : corners) moved = std::min(moved, (corner - given).norm());
    }
    largest = std::max(largest, moved);
  }
  return largest;
}

std::size_t largest_face(const Polyhedron& polyhedron) {
  std::size_t largest = 0;
  for (std::int32_t f = 0; f < polyhedron.face_count(); ++f)
    largest = std::max(largest, polyhedron.loop(f).size());
  return largest;
}

/// A surface and its hull, if any, to be fitted within several tolerances.
class Fit {
 public:
  explicit Fit(const Polyhedron& given)
      : origin_(given.vertices[0]), given_(given, given.memory()), surface_(moved_by(given, -origin_)) {
    turn_outward(surface_);
  }

  /// On a fault, not yet with its place, the polyhedron is undefined.
  FitReport within(double tolerance, Polyhedron& polyhedron) const {
    FitReport report;
    const MergedFacets faces = merge_facets(surface_, tolerance);
    report.deviation = deviation_of(surface_, faces);
    if (!(report.deviation <= tolerance)) {
      report.fault = {Fault::beyond_tolerance, -1, -1};
      return report;
    }
    // Convex outlines, or a hull with the same faces, need no fit.
    if (Polyhedron outlines = outlines_of(given_, faces);
        largest_face(outlines) > corners_by_hull && complete_polyhedron(outlines).fault == Fault::none) {
      polyhedron = std::move(outlines);
    } else if (hull().face_count() == std::int32_t(faces.planes.size())) {
      polyhedron = Polyhedron(hull(), given_.memory());
    } else {
      report.fault = intersect(faces, polyhedron);
    }
    if (report.fault.fault != Fault::none) return report;
    report.merged = surface_.face_count() - polyhedron.face_count();
    report.moved = largest_movement(surface_, faces, moved_by(polyhedron, -origin_));
    return report;
  }

  /// Reports the deepest dent of a surface that no polyhedron fits within the tolerance. A surface without a
  /// dent above rounding is folded.
  void describe_dent(double rounding, FitReport& report) const {
    const Dent dent = largest_dent(surface_, moved_by(hull(), -origin_));
    if (!(dent.depth > rounding)) {
      report.fault = {Fault::vertex_outside_face, -1, -1};
      return;
    }
    report.deviation = dent.depth;
    report.fault.vertex = dent.vertex;
    report.fault.face = dent.facet;
    Box<3> box;
    for (const Vector<3>& v : surface_.vertices) box.include(v);
    Polyhedron polyhedron(surface_.memory());
    // A fitted plane reduces a dent to half at best.
    for (double tried = rounded_up(0.5 * dent.depth); tried > 0 && tried < box.extent();
         tried = rounded_up(growth * tried)) {
      if (within(tried, polyhedron).fault.fault != Fault::none) continue;
      report.sufficient = tried;
      return;
    }
  }

  PolyhedronFault hull_fault() const {
    hull();
    return hull_fault_;
  }

 private:
  /// qhull takes some n^2 steps for a face of n corners, so that larger ones are taken as they are given.
  static constexpr std::size_t corners_by_hull = 64;
  static constexpr double growth = 1.05;

  /// To two significant digits, for the error text.
  static double rounded_up(double value) {
    if (!(value > 0)) return 0;
    const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
    return std::ceil(value / unit) * unit;
  }

  const Polyhedron& hull() const {
    if (!hull_) hull_fault_ = convex_hull(given_.vertices, hull_.emplace(given_.memory()));
    return *hull_;
  }

  PolyhedronFault intersect(const MergedFacets& faces, Polyhedron& polyhedron) const {
    Array<Halfspace<3>> halfspaces(surface_.memory());
    for (const FittedPlane& face : faces.planes) halfspaces.push_back(face.plane);
    std::int64_t redundant = 0;
    if (const PolyhedronFault r = polyhedron_from_halfspaces(halfspaces, polyhedron, redundant);
        r.fault != Fault::none) {
      return r;
    }
    polyhedron = moved_by(polyhedron, origin_);
    return check_polyhedron(polyhedron);
  }

  Vector<3> origin_;
  Polyhedron given_;
  Polyhedron surface_;  // relative to its first vertex, so that planes stay accurate far from the origin
  mutable std::optional<Polyhedron> hull_;  // computed when it is read first
  mutable PolyhedronFault hull_fault_;
};

FitReport fit(Polyhedron& polyhedron, double tolerance) {
  FitReport report;
  report.fault = check_points(polyhedron.vertices);
  if (report.fault.fault != Fault::none) return report;
  const double rounding = flatness_tolerance(largest_coordinate(polyhedron.vertices));
  if (polyhedron.face_count() == 0) {
    Polyhedron hull(polyhedron.memory());
    report.fault = convex_hull(polyhedron.vertices, hull);
    if (report.fault.fault != Fault::none) return report;
    polyhedron = std::move(hull);
  }
  report.fault = check_closed(polyhedron);
  if (report.fault.fault != Fault::none) return report;

  const Fit fit(polyhedron);
  report = fit.within(std::max(tolerance, rounding), polyhedron);
  if (report.fault.fault != Fault::beyond_tolerance) return report;
  if (fit.hull_fault().fault != Fault::none) return {.fault = fit.hull_fault()};
  fit.describe_dent(rounding, report);
  return report;
}

}  // namespace

FitReport fit_polyhedron(Polyhedron& polyhedron, double tolerance) {
  const FitReport report = fit(polyhedron, tolerance);
  if (report.fault.fault != Fault::none) polyhedron = Polyhedron(polyhedron.memory());
  return report;
}

}  // namespace halfspace
