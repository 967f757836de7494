#include "polygon.h"

#include <bit>
#include <new>
#include <stdexcept>

namespace halfspace::box2d {
namespace {

void require_ok(hs_status status) {
  if (status == HS_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  if (status != HS_OK) throw std::runtime_error(hs_status_string(status));
}

/// The polygon of a shape of Box2D, or its convex hull if the library refuses it, as for collinear vertices.
/// NULL if the hull is refused, too.
Shape shape_of(hs_context& context, const b2PolygonShape& shape) {
  double x[b2_maxPolygonVertices], y[b2_maxPolygonVertices];
  for (int i = 0; i < shape.m_count; ++i) {
    x[i] = shape.m_vertices[i].x;
    y[i] = shape.m_vertices[i].y;
  }
  const hs_view vertices = {x, y, nullptr, sizeof(double), shape.m_count};
  hs_shape* made = nullptr;
  hs_status status = hs_polygon_create(&context, vertices, &made);
  if (status == HS_ERROR_GEOMETRY) status = hs_polygon_create_hull(&context, vertices, &made);
  if (status == HS_ERROR_GEOMETRY) return nullptr;
  require_ok(status);
  return Shape(made);
}

/// The entry of the key, created if there is none. It is removed from the map with its last user.
template <class Known, class Make>
std::shared_ptr<const Polygon> shared(Known& known, const typename Known::key_type& key, Make&& make) {
  const auto found = known.find(key);
  if (found != known.end()) return found->second.lock();
  std::unique_ptr<const Polygon> made = make();
  if (!made) return nullptr;
  const auto forget = [&known, key](const Polygon* polygon) {
    known.erase(key);
    delete polygon;
  };
  std::shared_ptr<const Polygon> polygon(made.release(), forget);
  known.emplace(key, polygon);
  return polygon;
}

}  // namespace

Context make_context() {
  hs_context* context = nullptr;
  require_ok(hs_context_create(nullptr, &context));
  return Context(context);
}

hs_shape_properties properties_of_polygon(const hs_shape& shape) {
  hs_shape_properties properties;
  require_ok(hs_shape_get_properties(&shape, &properties, sizeof properties));
  if (properties.dimension != 2) throw std::invalid_argument("the shape of a fixture must be a polygon");
  return properties;
}

Polygon::Polygon(const hs_shape& borrowed) : shape_(&borrowed) {
  const hs_shape_properties properties = properties_of_polygon(borrowed);
  centroid_ = {properties.centroid[0], properties.centroid[1]};
  radius_ = properties.bounding_radius;
  corners_.resize(std::size_t(properties.vertex_count));
  const auto view_of = [&](Vector Corner::*member) {
    Vector& first = corners_[0].*member;
    return hs_mutable_view{&first.x, &first.y, nullptr, sizeof(Corner), properties.vertex_count};
  };
  std::vector<double> offsets(corners_.size());
  require_ok(hs_shape_get_vertices(shape_, view_of(&Corner::vertex), nullptr));
  require_ok(hs_shape_get_halfspaces(shape_, view_of(&Corner::normal), offsets.data(), nullptr));
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    corners_[i].vertex = corners_[i].vertex - centroid_;
    corners_[i].offset = offsets[i];
  }
}

Polygon::Polygon(Shape owned) : Polygon(*owned) { owned_ = std::move(owned); }

/// FNV-1a (Fowler, Noll, Vo), on 32-bit words.
std::size_t Polygons::HashOfBits::operator()(const Bits& bits) const {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const std::uint32_t word : bits) hash = (hash ^ word) * 0x100000001b3;
  return std::size_t(hash ^ (hash >> 32));
}

std::shared_ptr<const Polygon> Polygons::polygon_of(const b2PolygonShape& shape) {
  Bits bits{};
  for (int i = 0; i < shape.m_count; ++i) {
    bits[std::size_t(2 * i)] = std::bit_cast<std::uint32_t>(shape.m_vertices[i].x);
    bits[std::size_t(2 * i + 1)] = std::bit_cast<std::uint32_t>(shape.m_vertices[i].y);
  }
  bits.back() = std::uint32_t(shape.m_count);
  return shared(of_box2d_, bits, [&]() -> std::unique_ptr<const Polygon> {
    Shape made = shape_of(context_, shape);
    return made ? std::make_unique<const Polygon>(std::move(made)) : nullptr;
  });
}

std::shared_ptr<const Polygon> Polygons::polygon_of(const hs_shape& shape) {
  return shared(attached_, &shape, [&] { return std::make_unique<const Polygon>(shape); });
}

}  // namespace halfspace::box2d
