#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "geometry/outline.h"
#include "geometry/polyhedron/gauss_map.h"
#include "geometry/polyhedron/polyhedron.h"
#include "geometry/polyhedron/topology.h"
#include "geometry/vector.h"

namespace halfspace {

/// Measures of a shape in 2D or 3D.
template <int D>
class ShapeMeasures {
 public:
  const Vector<D>& centroid() const { return centroid_; }
  double bounding_radius() const { return bounding_radius_; }
  double shortest_edge() const { return shortest_edge_; }
  double longest_edge() const { return longest_edge_; }
  /// The smallest width normal to an edge or, in 3D, to a face. Normal to two edges a polyhedron may be
  /// narrower, a flat tetrahedron by half.
  double thickness() const { return thickness_; }
  /// Identifies the shape, see Fingerprint.
  std::uint64_t fingerprint() const { return fingerprint_; }

 protected:
  Vector<D> centroid_ = Vector<D>::Zero();
  double bounding_radius_ = 0;
  double shortest_edge_ = 0;
  double longest_edge_ = 0;
  double thickness_ = 0;
  std::uint64_t fingerprint_ = 0;
};

/// A convex shape in its own frame, centroid at the origin.
template <int D>
class Shape;

/// A convex polygon.
template <>
class Shape<2> : public ShapeMeasures<2> {
 public:
  /// Requires vertices, in either order, without a fault by check_polygon().
  Shape(std::span<const Vector<2>> vertices, Memory* memory);
  /// A copy with the same bits.
  Shape(const Shape& other, Memory* memory);
  Shape(const Shape&) = delete;  // its outline points into its own components
  Shape& operator=(const Shape&) = delete;

  /// Moves the vertices: as many as there are, without a fault by check_polygon(). Clockwise ones are
  /// reversed.
  void set_vertices(std::span<Vector<2>> vertices);

  int vertex_count() const { return count_; }
  const Outline<2>& outline() const { return outline_; }

  double area() const { return area_; }
  /// Integral of r r^T about the centroid: xx, yy, xy.
  const Eigen::Vector3d& second_moment() const { return second_moment_; }
  /// Polar moment about the centroid, the moment of inertia for unit density.
  double polar_moment() const { return second_moment_[0] + second_moment_[1]; }

 private:
  void measure(std::span<const Vector<2>> counter_clockwise);
  void store(std::span<const Vector<2>> counter_clockwise);
  void measure_thickness();
  void point_outline();

  int count_ = 0;
  double area_ = 0;
  Eigen::Vector3d second_moment_ = Eigen::Vector3d::Zero();
  Array<double> components_;  // x, y, nx, ny, offset, each padded
  Outline<2> outline_;        // into components_
};

/// A convex polyhedron.
template <>
class Shape<3> : public ShapeMeasures<3> {
 public:
  /// Requires a polyhedron without a fault by check_polyhedron().
  Shape(const Polyhedron& polyhedron, Memory* memory);
  Shape(const Shape&) = delete;  // its outline points into its own components
  Shape& operator=(const Shape&) = delete;

  /// Moves vertices and faces: a polyhedron without a fault by check_polyhedron(), with the same loops.
  void set_polyhedron(const Polyhedron& polyhedron);

  int vertex_count() const { return topology().vertex_count; }
  int edge_count() const { return topology().edge_count; }
  int face_count() const { return topology().face_count; }
  const Topology& topology() const { return topology_.view(); }
  const Outline<3>& outline() const { return outline_; }

  double volume() const { return volume_; }
  /// Integral of r r^T about the centroid: xx, yy, zz, xy, yz, zx.
  const Eigen::Matrix<double, 6, 1>& second_moment() const { return second_moment_; }
  /// About the centroid, for unit density: integral of (r.r) 1 - r r^T.
  Eigen::Matrix3d inertia() const;
  /// Area.
  double largest_face() const { return largest_face_; }

 private:
  void measure(const Polyhedron& polyhedron);
  void store(const Polyhedron& polyhedron);
  void measure_edges();
  void measure_faces();
  void measure_thickness();

  double volume_ = 0;
  Eigen::Matrix<double, 6, 1> second_moment_ = Eigen::Matrix<double, 6, 1>::Zero();
  double largest_face_ = 0;
  TopologyArrays topology_;
  Array<double> components_;           // x, y, z, then nx, ny, nz, offset, each padded
  std::optional<GaussMap> gauss_map_;  // only with many vertices that have not been moved
  Outline<3> outline_;                 // into components_, topology_ and gauss_map_
};

/// The polyhedron of a shape, in the coordinates that it was made from, to rounding.
Polyhedron polyhedron_of(const Shape<3>& shape, Memory* memory);

}  // namespace halfspace
