#pragma once

#include <span>

#include "geometry/outline.h"
#include "geometry/vector.h"

namespace halfspace {

/// An immutable convex shape in its own frame, centroid at the origin.
template <int D>
class Shape;

/// A convex polygon.
template <>
class Shape<2> {
 public:
  /// From vertices in either order that check_polygon() found no fault with.
  Shape(std::span<const Vector<2>> vertices, Memory* memory);
  Shape(const Shape&) = delete;  // its outline points into its own components
  Shape& operator=(const Shape&) = delete;

  int vertex_count() const { return count_; }
  const Outline<2>& outline() const { return outline_; }

  double area() const { return area_; }
  const Vector<2>& centroid() const { return centroid_; }
  /// Integral of r r^T about the centroid: xx, yy, xy.
  const Eigen::Vector3d& second_moment() const { return second_moment_; }
  /// Polar moment about the centroid, the moment of inertia for unit density.
  double polar_moment() const { return second_moment_[0] + second_moment_[1]; }
  double bounding_radius() const { return bounding_radius_; }
  double shortest_edge() const { return shortest_edge_; }
  double longest_edge() const { return longest_edge_; }

 private:
  void measure(std::span<const Vector<2>> counter_clockwise);
  void store(std::span<const Vector<2>> counter_clockwise);

  int count_ = 0;
  double area_ = 0;
  Vector<2> centroid_ = Vector<2>::Zero();
  Eigen::Vector3d second_moment_ = Eigen::Vector3d::Zero();
  double bounding_radius_ = 0;
  double shortest_edge_ = 0;
  double longest_edge_ = 0;
  Array<double> components_;  // x, y, nx, ny, offset, each padded
  Outline<2> outline_;        // into components_
};

}  // namespace halfspace
