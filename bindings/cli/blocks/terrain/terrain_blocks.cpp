#include "blocks/terrain/terrain_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>

namespace halfspace::cli {
namespace {

constexpr double degree = std::numbers::pi / 180;

Point horizontal(const Point& vector) { return {vector[0], vector[1], 0}; }

/// The distance of two segments in the plane that do not cross.
double distance_of_segments(const Point& a, const Point& b, const Point& c, const Point& d) {
  return std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d), distance_to_segment(c, a, b),
                   distance_to_segment(d, a, b)});
}

/// The blocks behind the triangles of a surface.
class BlocksBehind {
 public:
  BlocksBehind(const TriangleSurface& surface, double depth) : surface_(surface), depth_(depth) {
    around_.resize(surface.vertices.size());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const std::array<int, 3>& corners = surface.triangles[t];
      normals_.push_back(unit(area_normal({vertex(corners[0]), vertex(corners[1]), vertex(corners[2])})));
      for (std::size_t i = 0; i < 3; ++i) {
        around_[static_cast<std::size_t>(corners[i])].push_back(t);
        triangle_at_.emplace(edge(corners[i], corners[(i + 1) % 3]), t);
      }
    }
  }

  /// The half-spaces of a block, relative to a point.
  std::vector<HalfSpace> halfspaces(std::size_t t, const Point& origin) const {
    const std::array<int, 3>& corners = surface_.triangles[t];
    const Point& normal = normals_[t];
    const double lip = lip_of(t);
    std::vector<HalfSpace> halfspaces;
    const auto add = [&](const Point& outward, const Point& at, double beyond) {
      halfspaces.push_back({outward, dot(outward, minus(at, origin)) + beyond});
    };
    add(normal, vertex(corners[0]), 0);
    add(times(-1, normal), vertex(corners[0]), depth_);
    std::array<Point, 3> flanks;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point& from = vertex(corners[i]);
      const Point along = unit(minus(vertex(corners[(i + 1) % 3]), from));
      const Point sideways = unit(cross(along, {0, 0, 1}));
      const auto neighbour = triangle_at_.find(edge(corners[(i + 1) % 3], corners[i]));
      const bool has_neighbour = neighbour != triangle_at_.end();
      flanks[i] = has_neighbour ? flank_between(along, normal, normals_[neighbour->second]) : sideways;
      add(flanks[i], from, 0);
      if (has_neighbour && flanks[i][2] > 0) add(sideways, from, lip);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      for (const Point& cut : cuts_at(t, i, flanks[(i + 2) % 3], flanks[i])) add(cut, vertex(corners[i]), 0);
    }
    return halfspaces;
  }

 private:
  const Point& vertex(int index) const { return surface_.vertices[static_cast<std::size_t>(index)]; }

  static std::uint64_t edge(int from, int to) {
    return std::uint64_t{static_cast<std::uint32_t>(from)} << 32 | static_cast<std::uint32_t>(to);
  }

  /// The outer normal of the flank at an edge: at 60 degrees to the surface of the neighbour. At ridges
  /// sharper than 60 degrees the flanks of both blocks are the bisector; in hollows a flank stays 30 degrees
  /// below its own surface.
  static Point flank_between(const Point& along, const Point& normal, const Point& of_neighbour) {
    const Point outward = cross(along, normal);
    const double bend = std::atan2(dot(of_neighbour, outward), dot(of_neighbour, normal));  // at a ridge > 0
    const double below =
        bend < 60 * degree ? std::max(60 * degree + bend, 30 * degree) : 90 * degree + bend / 2;
    return plus(times(std::sin(below), outward), times(std::cos(below), normal));
  }

  /// How far, seen from above, a block may extend beyond its edges: half-way to the border of the triangles
  /// around it, as it is known to lie below these only.
  double lip_of(std::size_t t) const {
    const std::array<int, 3>& corners = surface_.triangles[t];
    std::array<Point, 3> at;
    for (std::size_t i = 0; i < 3; ++i) at[i] = horizontal(vertex(corners[i]));
    double farthest = std::numeric_limits<double>::infinity();
    double sharpest = 1;  // sine of half the smallest angle
    for (std::size_t i = 0; i < 3; ++i) {
      const Point one = unit(minus(at[(i + 1) % 3], at[i])), other = unit(minus(at[(i + 2) % 3], at[i]));
      sharpest = std::min(sharpest, std::sqrt(std::max(0.0, (1 - dot(one, other)) / 2)));
      for (const std::size_t around : around_[static_cast<std::size_t>(corners[i])]) {
        const auto [a, b] = opposite(around, corners[i]);
        if (is_corner(corners, a) || is_corner(corners, b)) continue;
        for (std::size_t k = 0; k < 3; ++k) {
          farthest = std::min(farthest, distance_of_segments(at[k], at[(k + 1) % 3], horizontal(vertex(a)),
                                                             horizontal(vertex(b))));
        }
      }
    }
    if (!std::isfinite(farthest)) farthest = length(minus(at[1], at[0]));
    return sharpest * farthest / 2;
  }

  /// The other two vertices of a triangle, in its order.
  std::pair<int, int> opposite(std::size_t t, int corner) const {
    const std::array<int, 3>& corners = surface_.triangles[t];
    const std::size_t i =
        static_cast<std::size_t>(std::find(corners.begin(), corners.end(), corner) - corners.begin());
    return {corners[(i + 1) % 3], corners[(i + 2) % 3]};
  }

  static bool is_corner(const std::array<int, 3>& corners, int vertex) {
    return std::find(corners.begin(), corners.end(), vertex) != corners.end();
  }

  /// Outer normals of planes through a corner that keep the block below the triangles that it shares only
  /// that corner with, where no other face does.
  std::vector<Point> cuts_at(std::size_t t, std::size_t corner, const Point& flank_before,
                             const Point& flank) const {
    const std::array<int, 3>& corners = surface_.triangles[t];
    const int at = corners[corner];
    std::vector<Point> cuts;
    const auto [next, last] = opposite(t, at);
    const std::array<Point, 2> own{unit(minus(vertex(next), vertex(at))),
                                   unit(minus(vertex(last), vertex(at)))};
    for (const std::size_t around : around_[static_cast<std::size_t>(at)]) {
      const auto [a, b] = opposite(around, at);
      if (is_corner(corners, a) || is_corner(corners, b)) continue;
      const std::array<Point, 2> others{unit(minus(vertex(a), vertex(at))),
                                        unit(minus(vertex(b), vertex(at)))};
      const auto is_ahead_of = [&](const Point& face) { return keeps_behind(face, own, others); };
      if (is_ahead_of(normals_[t]) || is_ahead_of(flank_before) || is_ahead_of(flank) ||
          std::any_of(cuts.begin(), cuts.end(), is_ahead_of))
        continue;
      cuts.push_back(plane_between(own, others));
    }
    return cuts;
  }

  /// True if a plane has the triangle of two directions, and all below it, behind it, and the triangle of two
  /// other directions, and all above it, ahead.
  static bool keeps_behind(const Point& normal, const std::array<Point, 2>& own,
                           const std::array<Point, 2>& others) {
    constexpr double rounding = 1e-12;
    return normal[2] >= -rounding && dot(normal, own[0]) <= rounding && dot(normal, own[1]) <= rounding &&
           dot(normal, others[0]) >= -rounding && dot(normal, others[1]) >= -rounding;
  }

  /// The mean of all such planes that two of the directions span. There is one, as both triangles are convex,
  /// and neither is above the other.
  static Point plane_between(const std::array<Point, 2>& own, const std::array<Point, 2>& others) {
    std::vector<Point> directions{own[0], own[1], others[0], others[1], {0, 0, 1}};
    Point sum{};
    for (std::size_t i = 0; i < directions.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const Point across = cross(directions[i], directions[k]);
        if (!(length(across) > 0)) continue;
        for (const double sign : {1.0, -1.0}) {
          const Point normal = times(sign / length(across), across);
          if (keeps_behind(normal, own, others)) sum = plus(sum, normal);
        }
      }
    }
    return unit(sum);
  }

  const TriangleSurface& surface_;
  double depth_;
  std::vector<Point> normals_;
  std::vector<std::vector<std::size_t>> around_;                ///< the triangles at each vertex
  std::unordered_map<std::uint64_t, std::size_t> triangle_at_;  ///< by their directed edges
};

/// The face of a shape with a given outer normal.
std::vector<int> face_towards(const Context& context, const Shape& shape, const Point& normal) {
  const std::vector<HalfSpace> sides = halfspaces_of(context, shape);
  const auto less = [&](const HalfSpace& a, const HalfSpace& b) {
    return dot(a.normal, normal) < dot(b.normal, normal);
  };
  const auto top = std::max_element(sides.begin(), sides.end(), less);
  return faces_of(context, shape)[static_cast<std::size_t>(top - sides.begin())];
}

}  // namespace

void make_terrain_blocks(const Context& context, const TriangleSurface& surface, double depth,
                         const std::function<void(TerrainBlock)>& add) {
  const BlocksBehind behind(surface, depth);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    Point center{};
    for (const int vertex : surface.triangles[t])
      center = plus(center, times(1.0 / 3, surface.vertices[static_cast<std::size_t>(vertex)]));
    const std::vector<HalfSpace> halfspaces = behind.halfspaces(t, center);
    TerrainBlock block{make_from_halfspaces(context, halfspaces), center, {}};
    block.top = face_towards(context, block.shape, halfspaces[0].normal);
    add(std::move(block));
  }
}

}  // namespace halfspace::cli
