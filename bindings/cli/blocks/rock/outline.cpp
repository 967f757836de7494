#include "blocks/rock/outline.h"

#include <algorithm>
#include <cmath>

#include "common/text.h"

namespace halfspace::cli {
namespace {

double size_of(const std::vector<Point>& vertices) {
  double size = 0;
  for (const Point& vertex : vertices) size = std::max(size, length(minus(vertex, vertices[0])));
  return size;
}

bool is_between(double value, double one, double other, double tolerance) {
  return value >= std::min(one, other) - tolerance && value <= std::max(one, other) + tolerance;
}

/// The edges of an outline, each from the vertex of its index to the next one.
class Outline {
 public:
  explicit Outline(const std::vector<Point>& vertices)
      : vertices_(vertices), tolerance_(straight * size_of(vertices)) {}

  bool turns_back(std::size_t i) const {
    const Point arriving = minus(vertices_[i], vertices_[before(i)]);
    const Point leaving = minus(vertices_[next(i)], vertices_[i]);
    return dot(arriving, leaving) < 0 &&
           std::abs(cross(arriving, leaving)[2]) <= straight * length(arriving) * length(leaving);
  }

  bool is_on(std::size_t i, std::size_t vertex) const {
    return length(minus(vertices_[i], vertices_[vertex])) <= tolerance_;
  }

  bool is_on_edge(std::size_t i, std::size_t edge) const {
    const Point &p = vertices_[i], &a = vertices_[edge], &b = vertices_[next(edge)];
    return is_between(p[0], a[0], b[0], tolerance_) && is_between(p[1], a[1], b[1], tolerance_) &&
           distance_to_segment(p, a, b) <= tolerance_;
  }

  bool cross_each_other(std::size_t one, std::size_t other) const {
    return separates(one, other) && separates(other, one);
  }

  std::size_t next(std::size_t i) const { return i + 1 < vertices_.size() ? i + 1 : 0; }
  std::size_t before(std::size_t i) const { return (i > 0 ? i : vertices_.size()) - 1; }

 private:
  /// True if the ends of an edge are on both sides of the line of another.
  bool separates(std::size_t line, std::size_t edge) const {
    return is_left(line, edge) != is_left(line, next(edge));
  }
  bool is_left(std::size_t line, std::size_t i) const {
    const Point& start = vertices_[line];
    return cross(minus(vertices_[next(line)], start), minus(vertices_[i], start))[2] > 0;
  }

  const std::vector<Point>& vertices_;
  double tolerance_;
};

}  // namespace

std::optional<SelfContact> find_self_contact(const std::vector<Point>& vertices) {
  const Outline outline(vertices);
  const std::size_t n = vertices.size();
  const auto named = [&](std::size_t i) { return std::to_string(i) + ' ' + described(vertices[i], 2); };
  const auto edge_from = [&](std::size_t i) {
    return "the edge from vertex " + named(i) + " to vertex " + named(outline.next(i));
  };
  for (std::size_t i = 0; i < n; ++i)
    if (outline.turns_back(i)) return SelfContact{i, "the outline turns back on itself"};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t edge = 0; edge < n; ++edge) {
      const std::size_t end = outline.next(edge);
      // Between a vertex and its neighbour's other edge only a spike leaves no room.
      const bool is_near = edge == i || end == i || outline.next(end) == i || outline.next(i) == edge;
      if (is_near || !outline.is_on_edge(i, edge)) continue;
      for (const std::size_t corner : {edge, end})
        if (outline.is_on(i, corner)) return SelfContact{i, "touches vertex " + named(corner)};
      return SelfContact{i, "touches " + edge_from(edge)};
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t edge = i + 2; edge < n; ++edge) {
      if (outline.next(edge) == i || !outline.cross_each_other(i, edge)) continue;
      return SelfContact{i, "the edge to vertex " + named(outline.next(i)) + " crosses " + edge_from(edge)};
    }
  }
  return std::nullopt;
}

}  // namespace halfspace::cli
