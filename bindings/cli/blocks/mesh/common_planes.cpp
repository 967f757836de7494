#include "blocks/mesh/common_planes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/box.h"
#include "common/vector.h"

namespace halfspace::cli {
namespace {

/// Faces are flush below this distance, as a fraction of their distance from the origin.
constexpr double rounding = 1e-13;

struct Face {
  std::size_t block;
  HalfSpace plane;
  std::vector<Point> corners;
  double radius = 0;  // inner_radius() of the corners
};

/// The box of a block, larger by the tolerance of its planes.
struct Reach : Box {
  std::size_t block;
};

double distance(const HalfSpace& plane, const Point& p) { return dot(plane.normal, p) - plane.offset; }

double farthest(const HalfSpace& plane, const std::vector<Point>& points) {
  double largest = 0;
  for (const Point& p : points) largest = std::max(largest, std::abs(distance(plane, p)));
  return largest;
}

/// The part of a convex polygon in space on the inner side of a plane.
std::vector<Point> clipped(const std::vector<Point>& polygon, const Point& normal, const Point& on_plane) {
  std::vector<Point> rest;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double a = dot(normal, minus(from, on_plane)), b = dot(normal, minus(to, on_plane));
    if (a <= 0) rest.push_back(from);
    if ((a < 0 && b > 0) || (a > 0 && b < 0)) rest.push_back(plus(from, times(a / (a - b), minus(to, from))));
  }
  return rest;
}

/// The part of a face that another one covers, seen along the other's normal.
std::vector<Point> covered(const Face& face, const Face& by) {
  std::vector<Point> part = face.corners;
  for (std::size_t i = 0; i < by.corners.size() && !part.empty(); ++i) {
    const Point &from = by.corners[i], &to = by.corners[(i + 1) % by.corners.size()];
    part = clipped(part, cross(minus(to, from), by.plane.normal), from);
  }
  return part;
}

/// The approximate inradius of a polygon.
double inner_radius(const std::vector<Point>& polygon) {
  double perimeter = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    perimeter += length(minus(polygon[(i + 1) % polygon.size()], polygon[i]));
  return length(area_normal(polygon)) / perimeter;
}

enum class Joint { none, flush, uneven };

/// Classifies two opposite faces within a distance. Their normals may differ by the angle at which the
/// smaller face tilts by that distance; overlaps not larger than the distance are ignored.
Joint joint_of(const Face& a, const Face& b, double within) {
  if (dot(a.plane.normal, b.plane.normal) > -0.5) return Joint::none;
  const double slope = length(plus(a.plane.normal, b.plane.normal));
  const double radius = std::min(a.radius, b.radius);
  if (radius < 2 * within || slope * radius > within) return Joint::none;
  const std::vector<Point> part = covered(a, b);
  if (part.size() < 3 || inner_radius(part) < 2 * within) return Joint::none;
  const double off = std::max(farthest(a.plane, part), farthest(b.plane, part));
  if (off > within) return Joint::none;
  return off <= rounding * (std::abs(a.plane.offset) + radius) ? Joint::flush : Joint::uneven;
}

/// The least-squares plane through points: the regression of their heights over a nearby plane.
HalfSpace plane_through(const std::vector<Point>& points, const HalfSpace& near) {
  const Point& z = near.normal;
  const Point aside = std::abs(z[0]) < 0.6 ? Point{1, 0, 0} : Point{0, 1, 0};
  const Point across = cross(z, aside), x = times(1 / length(across), across), y = cross(z, x);
  Point middle{};
  for (const Point& p : points) middle = plus(middle, times(1.0 / static_cast<double>(points.size()), p));
  double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
  for (const Point& p : points) {
    const Point r = minus(p, middle);
    const double u = dot(r, x), v = dot(r, y), height = dot(r, z);
    xx += u * u, xy += u * v, yy += v * v, xz += u * height, yz += v * height;
  }
  const double determinant = xx * yy - xy * xy;
  const Point tilted = minus(
      z, plus(times((xz * yy - yz * xy) / determinant, x), times((yz * xx - xz * xy) / determinant, y)));
  const Point normal = times(1 / length(tilted), tilted);
  return {normal, dot(normal, middle)};
}

class Joints {
 public:
  Joints(const Context& context, std::vector<ConvexSolid>& blocks) : context_(context), blocks_(blocks) {
    for (std::size_t b = 0; b < blocks.size(); ++b) add_faces(b);
    is_uneven_.resize(faces_.size(), false);
    join_of_.resize(faces_.size());
    std::iota(join_of_.begin(), join_of_.end(), std::size_t(0));
    find_joints();
  }

  int share() {
    std::vector<std::vector<std::size_t>> joints(faces_.size());
    for (std::size_t f = 0; f < faces_.size(); ++f) joints[root(f)].push_back(f);
    std::vector<bool> changed(blocks_.size(), false);
    int moved = 0;
    for (const std::vector<std::size_t>& joint : joints) {
      if (std::none_of(joint.begin(), joint.end(), [&](std::size_t f) { return is_uneven_[f]; })) continue;
      if (!take_common_plane(joint)) continue;
      moved += static_cast<int>(joint.size());
      for (const std::size_t f : joint) changed[faces_[f].block] = true;
    }
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      if (changed[b]) rebuild(b);
    }
    return moved;
  }

 private:
  void add_faces(std::size_t block) {
    const Shape& shape = blocks_[block].shape;
    const Point centroid = point_of(properties_of(context_, shape).centroid);
    const std::vector<Point> vertices = vertices_of(context_, shape);
    const std::vector<HalfSpace> planes = halfspaces_of(context_, shape);
    const std::vector<std::vector<int>> loops = faces_of(context_, shape);
    Box box;
    first_.push_back(faces_.size());
    for (std::size_t f = 0; f < planes.size(); ++f) {
      Face face{block, planes[f], {}};
      for (const int v : loops[f]) face.corners.push_back(vertices[static_cast<std::size_t>(v)]);
      face.plane.offset += dot(face.plane.normal, centroid);
      for (const Point& p : face.corners) box.add(p);
      face.radius = inner_radius(face.corners);
      faces_.push_back(std::move(face));
    }
    const double tolerance = blocks_[block].tolerance;
    const Point margin{tolerance, tolerance, tolerance};
    boxes_.push_back({{minus(box.low, margin), plus(box.high, margin)}, block});
  }

  /// Sorts boxes along x, and sweeps over them.
  void find_joints() {
    std::sort(boxes_.begin(), boxes_.end(),
              [](const Reach& a, const Reach& b) { return a.low[0] < b.low[0]; });
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const Reach& a = boxes_[i];
      for (std::size_t j = i + 1; j < boxes_.size() && boxes_[j].low[0] <= a.high[0]; ++j) {
        const Reach& b = boxes_[j];
        if (b.low[1] <= a.high[1] && a.low[1] <= b.high[1] && b.low[2] <= a.high[2] && a.low[2] <= b.high[2])
          join_faces(a.block, b.block);
      }
    }
  }

  std::size_t end_of(std::size_t block) const {
    return block + 1 < first_.size() ? first_[block + 1] : faces_.size();
  }

  void join_faces(std::size_t a, std::size_t b) {
    const double within = blocks_[a].tolerance + blocks_[b].tolerance;
    for (std::size_t f = first_[a]; f < end_of(a); ++f) {
      for (std::size_t g = first_[b]; g < end_of(b); ++g) {
        const Joint joint = joint_of(faces_[f], faces_[g], within);
        if (joint == Joint::none) continue;
        join_of_[root(g)] = root(f);
        if (joint == Joint::uneven) is_uneven_[f] = true;
      }
    }
  }

  std::size_t root(std::size_t face) {
    while (join_of_[face] != face) face = join_of_[face] = join_of_[join_of_[face]];
    return face;
  }

  /// Gives the faces of a joint one plane, unless it is too far from one of them.
  bool take_common_plane(const std::vector<std::size_t>& joint) {
    std::vector<Point> corners;
    std::size_t widest = joint[0];
    for (const std::size_t f : joint) {
      corners.insert(corners.end(), faces_[f].corners.begin(), faces_[f].corners.end());
      if (length(area_normal(faces_[f].corners)) > length(area_normal(faces_[widest].corners))) widest = f;
    }
    const HalfSpace common = plane_through(corners, faces_[widest].plane);
    for (const std::size_t f : joint) {
      if (!(farthest(common, faces_[f].corners) <= blocks_[faces_[f].block].tolerance)) return false;
    }
    for (const std::size_t f : joint) {
      const double side = dot(common.normal, faces_[f].plane.normal) > 0 ? 1 : -1;
      faces_[f].plane = {times(side, common.normal), side * common.offset};
    }
    return true;
  }

  void rebuild(std::size_t block) {
    std::vector<HalfSpace> planes;
    for (std::size_t f = first_[block]; f < end_of(block); ++f) planes.push_back(faces_[f].plane);
    blocks_[block].shape = make_from_halfspaces(context_, planes);
  }

  const Context& context_;
  std::vector<ConvexSolid>& blocks_;
  std::vector<Reach> boxes_;
  std::vector<Face> faces_;
  std::vector<std::size_t> first_;    // of a block's faces
  std::vector<std::size_t> join_of_;  // a face of the same joint, itself at the root
  std::vector<bool> is_uneven_;       // true: not flush with some face of its joint
};

}  // namespace

int share_planes(const Context& context, std::vector<ConvexSolid>& blocks) {
  return Joints(context, blocks).share();
}

}  // namespace halfspace::cli
