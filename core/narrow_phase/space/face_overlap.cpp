#include "narrow_phase/space/face_overlap.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "geometry/polygon/clip.h"

namespace halfspace {
namespace {

/// A face with more corners is divided into pieces, as a fan from its first corner.
constexpr int max_piece_corners = 32;

/// A convex polygon: a piece of one face, cut by a piece of another. Each cut adds one corner at most.
struct Piece {
  int count = 0;
  Vector<2> corner[2 * max_piece_corners];

  void add(const Vector<2>& p) {
    // Only a polygon made slightly concave by rounding gets more; the loss is as small.
    if (count < 2 * max_piece_corners) corner[count++] = p;
  }
  std::span<const Vector<2>> corners() const { return {corner, std::size_t(count)}; }
};

constexpr int corners_in_fan = max_piece_corners - 2;  // without the first, and the last of the piece before

int piece_count(const FlatFace& face) { return (face.count() - 2 + corners_in_fan - 1) / corners_in_fan; }

void take_piece(const FlatFace& face, int index, Piece& piece) {
  const int from = 1 + index * corners_in_fan;
  const int to = std::min(from + corners_in_fan, face.count() - 1);
  piece.count = 0;
  piece.add(face.corner(0));
  for (int i = from; i <= to; ++i) piece.add(face.corner(i));
}

/// Cuts a polygon by the sides of a piece that it crosses; the two buffers alternate.
const Piece& cut_by(const Piece& cutter, double rounding, Piece& polygon, Piece& room) {
  Piece* kept = &polygon;
  Piece* next = &room;
  for (int i = 0; i < cutter.count && kept->count >= 3; ++i) {
    const int end = i + 1 == cutter.count ? 0 : i + 1;
    const HalfPlane side(cutter.corner[i], cutter.corner[end], rounding);
    double height[2 * max_piece_corners], highest = -HUGE_VAL;
    for (int k = 0; k < kept->count; ++k) {
      height[k] = side.height(kept->corner[k]);
      highest = std::max(highest, height[k]);
    }
    if (highest <= side.rounding) continue;
    next->count = 0;
    clip(
        kept->corners(), [&](const Vector<2>& p) { return height[&p - kept->corner]; }, side.rounding,
        [&](const Vector<2>& p) { next->add(p); });
    std::swap(kept, next);
  }
  return *kept;
}

/// The farthest of many points in evenly spread directions. The directions are rotated by an odd angle: for
/// edges normal to one, both ends and all points between would be equally far.
class FarthestPoints {
 public:
  FarthestPoints() { std::fill_n(height_, max_region_points, -HUGE_VAL); }

  void consider(const Vector<2>& p) {
    Vector<2> direction(0.98768834059513777, 0.15643446504023087);  // 9 degrees
    for (int i = 0; i < max_region_points; ++i) {
      const double height = direction.dot(p);
      if (height > height_[i]) {
        height_[i] = height;
        point_[i] = p;
      }
      constexpr double cosine = 0.70710678118654757, sine = cosine;  // of an eighth of a turn
      static_assert(max_region_points == 8);
      direction = {cosine * direction.x() - sine * direction.y(),
                   sine * direction.x() + cosine * direction.y()};
    }
  }

  /// Writes each point once.
  int write(Vector<2>* points) const {
    int count = 0;
    for (int i = 0; i < max_region_points; ++i) {
      if (point_[i] != point_[i == 0 ? max_region_points - 1 : i - 1]) points[count++] = point_[i];
    }
    return count;
  }

 private:
  double height_[max_region_points];
  Vector<2> point_[max_region_points];
};

/// Adds area and centroid, the latter times the area.
void add_area(const Piece& piece, FaceOverlap& overlap) {
  const Vector<2> first = piece.corner[0];
  double twice_area = 0;
  Vector<2> moment(0, 0);
  for (int i = 1; i + 1 < piece.count; ++i) {
    const Vector<2> p = piece.corner[i] - first, q = piece.corner[i + 1] - first;
    const double part = cross(p, q);
    twice_area += part;
    moment += part * (p + q);
  }
  if (!(twice_area > 0)) return;
  overlap.area += 0.5 * twice_area;
  overlap.centroid += 0.5 * (twice_area * first + moment / 3);
}

}  // namespace

FaceOverlap overlap_of(const FlatFace& one, const FlatFace& other, const Vector<2>& slope, double rounding) {
  FaceOverlap overlap;
  overlap.lowest = HUGE_VAL;
  FarthestPoints farthest;
  Piece polygon, room, cutter;
  const bool in_one_piece = piece_count(one) == 1 && piece_count(other) == 1;
  for (int j = 0; j < piece_count(other); ++j) {
    take_piece(other, j, cutter);
    for (int i = 0; i < piece_count(one); ++i) {
      take_piece(one, i, polygon);
      const Piece& part = cut_by(cutter, rounding, polygon, room);
      if (part.count < 3) continue;
      add_area(part, overlap);
      for (int k = 0; k < part.count; ++k)
        overlap.lowest = std::min(overlap.lowest, slope.dot(part.corner[k]));
      if (in_one_piece && part.count <= max_region_points) {
        overlap.count = part.count;
        std::copy_n(part.corner, part.count, overlap.corner);
      } else {
        for (int k = 0; k < part.count; ++k) farthest.consider(part.corner[k]);
      }
    }
  }
  if (overlap.area == 0) return {};
  overlap.centroid /= overlap.area;
  if (overlap.count == 0) overlap.count = farthest.write(overlap.corner);
  return overlap;
}

SegmentPart part_over(const FlatFace& face, const Vector<2>& start, const Vector<2>& end, double rounding) {
  SegmentPart part;
  for (int i = 0; i < face.count(); ++i) {
    const HalfPlane half_plane(face.corner(i), face.corner(face.next(i)), rounding);
    const double at_start = half_plane.height(start), at_end = half_plane.height(end);
    const bool starts_outside = at_start > half_plane.rounding, ends_outside = at_end > half_plane.rounding;
    if (starts_outside && ends_outside) return {0, 0};
    if (starts_outside) part.from = std::max(part.from, at_start / (at_start - at_end));
    if (ends_outside) part.to = std::min(part.to, at_start / (at_start - at_end));
  }
  return part;
}

}  // namespace halfspace
