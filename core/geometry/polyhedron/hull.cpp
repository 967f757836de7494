#include "geometry/polyhedron/hull.h"

#include <cmath>
#include <utility>

#include "geometry/box.h"
#include "geometry/polyhedron/quickhull.h"
#include "geometry/polyhedron/simplify.h"

namespace halfspace {
namespace {

/// The points relative to the centre of their box, in units of a power of two near its size: this reduces
/// qhull's rounding errors, and scaling by a power of two changes none of its decisions.
class Normalized {
 public:
  Normalized(std::span<const Vector<3>> points, Memory* memory) : coordinates_(memory) {
    Box<3> box;
    for (const Vector<3>& p : points) box.include(p);
    const Vector<3> center = box.center();
    std::frexp(box.extent(), &exponent_);
    coordinates_.reserve(3 * points.size());
    for (const Vector<3>& p : points) {
      for (int axis = 0; axis < 3; ++axis) {
        coordinates_.push_back(std::ldexp(p[axis] - center[axis], -exponent_));
      }
    }
  }

  Array<double>& coordinates() { return coordinates_; }
  double length(double in_units_of_the_points) const {
    return std::ldexp(in_units_of_the_points, -exponent_);
  }

 private:
  Array<double> coordinates_;
  int exponent_ = 0;
};

PolyhedronFault find_hull(std::span<const Vector<3>> points, Polyhedron& hull) {
  hull.vertices.assign(points.begin(), points.end());
  if (const PolyhedronFault r = check_points(points); r.fault != Fault::none) return r;

  Normalized normalized(points, hull.memory());
  const double coplanar = normalized.length(coplanarity_tolerance(largest_coordinate(points)));
  switch (quickhull(normalized.coordinates(), coplanar, hull.first_of_face, hull.face_vertices)) {
    case QuickhullResult::ok:
      break;
    case QuickhullResult::flat:
      return {Fault::zero_volume, -1, -1};
    case QuickhullResult::failed:
      return {Fault::hull_failed, -1, -1};
    case QuickhullResult::unavailable:
      return {Fault::hull_unavailable, -1, -1};
  }
  hull.normals.resize(std::size_t(hull.face_count()));  // computed with the faces
  drop_degenerate(hull);                                // merging facets may leave a vertex inside an edge
  return complete_polyhedron(hull);
}

}  // namespace

PolyhedronFault convex_hull(std::span<const Vector<3>> points, Polyhedron& hull) {
  const PolyhedronFault report = find_hull(points, hull);
  if (report.fault != Fault::none) hull = Polyhedron(hull.memory());
  return report;
}

}  // namespace halfspace
