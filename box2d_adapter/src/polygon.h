#pragma once

#include <box2d/b2_polygon_shape.h>
#include <halfspace/halfspace.h>

#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "vector.h"

namespace halfspace::box2d {

struct DestroyContext {
  void operator()(hs_context* context) const { hs_context_destroy(context); }
};
struct DestroyShape {
  void operator()(hs_shape* shape) const { hs_shape_destroy(shape); }
};
using Context = std::unique_ptr<hs_context, DestroyContext>;
using Shape = std::unique_ptr<hs_shape, DestroyShape>;

Context make_context();

/// Throws std::invalid_argument if the shape is no polygon.
hs_shape_properties properties_of_polygon(const hs_shape& shape);

/// A shape of the library with the geometry for manifolds. Vertices are counter-clockwise and relative to the
/// centroid; edge i is from vertex i to the next.
class Polygon {
 public:
  explicit Polygon(const hs_shape& borrowed);
  explicit Polygon(Shape owned);

  const hs_shape* shape() const { return shape_; }
  bool is_borrowed() const { return !owned_; }
  const Vector& centroid() const { return centroid_; }  // in body coordinates
  double radius() const { return radius_; }             // max distance of a vertex from the centroid
  int count() const { return int(corners_.size()); }
  const Vector& vertex(int i) const { return corners_[std::size_t(i)].vertex; }
  const Vector& normal(int edge) const { return corners_[std::size_t(edge)].normal; }
  double offset(int edge) const { return corners_[std::size_t(edge)].offset; }
  int next(int i) const { return i + 1 < count() ? i + 1 : 0; }
  int previous(int i) const { return i > 0 ? i - 1 : count() - 1; }

 private:
  /// A vertex and the edge that starts there, adjacent in memory.
  struct Corner {
    Vector vertex;
    Vector normal;
    double offset;
  };

  Vector centroid_;
  double radius_ = 0;
  std::vector<Corner> corners_;
  const hs_shape* shape_;
  Shape owned_;
};

/// The polygons of a world's contacts. Fixtures of equal shape have one in common, destroyed with the last
/// contact that uses it.
class Polygons {
 public:
  explicit Polygons(hs_context& context) : context_(context) {}

  /// NULL if the library refuses the polygon.
  std::shared_ptr<const Polygon> polygon_of(const b2PolygonShape& shape);
  std::shared_ptr<const Polygon> polygon_of(const hs_shape& shape);

 private:
  /// All bits of a shape's vertices, then their number.
  using Bits = std::array<std::uint32_t, 2 * b2_maxPolygonVertices + 1>;

  struct HashOfBits {
    std::size_t operator()(const Bits& bits) const;
  };

  hs_context& context_;
  std::unordered_map<Bits, std::weak_ptr<const Polygon>, HashOfBits> of_box2d_;
  std::unordered_map<const hs_shape*, std::weak_ptr<const Polygon>> attached_;
};

}  // namespace halfspace::box2d
