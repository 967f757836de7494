#include <algorithm>
#include <span>
#include <utility>

#include "force/spring/pressure_sums.h"
#include "narrow_phase/pair.h"

namespace halfspace {
namespace {

using Placed = PlacedOutline<3>;
using Face = PressureFace<3>;

/// A face where the search starts. Of two edges, one beside the first.
Face first_face(const Placed (&blocks)[2], const PotentialPair<3>& near) {
  switch (near.kind) {
    case PotentialPair<3>::face_vertex:
      return face_of(blocks[0], near.a);
    case PotentialPair<3>::vertex_face:
      return face_of(blocks[1], near.b);
    case PotentialPair<3>::edge_edge:
      return face_of(blocks[0], blocks[0].outline.topology->edge_left[near.a]);
    default:
      return face_of(blocks[0], 0);
  }
}

std::span<const std::int32_t> vertices_of(const Placed& block, int face) {
  const Topology& topology = *block.outline.topology;
  const std::int32_t first = topology.first_of_face[face];
  return {topology.face_vertex + first, std::size_t(topology.first_of_face[face + 1] - first)};
}

std::span<const Vector<3>> corners_of(const OverlapFace& face, const OverlapBody& body) {
  return {body.corners.data() + face.first, body.corners.data() + face.end};
}

/// The faces of a block that have a vertex below the first face.
void begin_below(const Face& first, const Placed& block, PressureRoom<3>& room) {
  OverlapBody& body = room.overlap;
  body.faces.clear();
  body.corners.clear();
  room.is_inside.clear();
  for (int v = 0; v < block.outline.vertex_count(); ++v)
    room.is_inside.push_back(first.depth(block.vertex(v)) > 0);
  const auto is_inside = [&](std::int32_t v) { return room.is_inside[std::size_t(v)] != 0; };
  for (int f = 0; f < block.outline.face_count(); ++f) {
    const auto vertices = vertices_of(block, f);
    if (std::none_of(vertices.begin(), vertices.end(), is_inside)) continue;
    const std::int32_t begin = std::int32_t(body.corners.size());
    for (const std::int32_t v : vertices) body.corners.push_back(block.vertex(v));
    body.faces.push_back({block.outline.normal(f), block.block, f, flush_of(block, f), false, begin,
                          std::int32_t(body.corners.size())});
  }
}

/// Appends the part of a face below a plane, and its edges on the plane to the rim: by rounding a face with
/// corners close together may have several. Points on the plane are outside.
void cut_face(const OverlapFace& face, const Face& plane, PressureRoom<3>& room) {
  const auto corners = corners_of(face, room.overlap);
  Array<Vector<3>>& part = room.clipped.corners;
  const std::size_t begin = part.size(), rim_begin = room.rim.size();
  const Vector<3>* before = &corners.back();
  double depth_before = plane.depth(*before);
  Vector<3> left = Vector<3>::Zero();  // where the boundary has left the part
  for (const Vector<3>& corner : corners) {
    const double depth = plane.depth(corner);
    if ((depth > 0) != (depth_before > 0)) {
      // From its inner to its outer end, so that both faces at the edge get the same bits.
      const bool enters = depth > 0;
      const Vector<3>&inner = enters ? corner : *before, &outer = enters ? *before : corner;
      const double inside = enters ? depth : depth_before, outside = enters ? depth_before : depth;
      part.push_back(inner + inside / (inside - outside) * (outer - inner));
      if (enters)
        room.rim.push_back({part.back(), left});
      else
        left = part.back();
    }
    if (depth > 0) part.push_back(corner);
    before = &corner;
    depth_before = depth;
  }
  if (depth_before <= 0 && room.rim.size() > rim_begin) room.rim[rim_begin].end = left;
  if (part.size() == begin) return;
  OverlapFace& rest = room.clipped.faces.emplace_back(face);
  rest.first = std::int32_t(begin);
  rest.end = std::int32_t(part.size());
}

/// The face that a cut leaves on its plane: each edge of the rim begins at the end of another. Rounding may
/// make it several loops, each a face.
void close_rim(const Face& plane, PressureRoom<3>& room) {
  Array<RimEdge>& rim = room.rim;
  OverlapBody& body = room.clipped;
  std::size_t begin = body.corners.size();
  for (auto edge = rim.begin(); edge != rim.end(); ++edge) {
    body.corners.push_back(edge->start);
    const auto next =
        std::find_if(edge + 1, rim.end(), [&](const RimEdge& other) { return other.start == edge->end; });
    if (next != rim.end()) {
      std::swap(*next, edge[1]);
      continue;
    }
    const std::size_t end = body.corners.size();
    body.faces.push_back(
        {plane.normal, plane.block, plane.face, plane.flush, false, std::int32_t(begin), std::int32_t(end)});
    begin = end;
  }
}

/// Keeps of the overlap what lies below a plane.
void cut(const Face& plane, PressureRoom<3>& room) {
  room.clipped.faces.clear();
  room.clipped.corners.clear();
  room.rim.clear();
  for (const OverlapFace& face : room.overlap.faces) cut_face(face, plane, room);
  close_rim(plane, room);
  std::swap(room.overlap, room.clipped);
}

/// Marks a face of the other block that lies on the plane and looks the same way, up to rounding.
bool is_shared(const Face& plane, OverlapBody& body) {
  for (OverlapFace& face : body.faces) {
    if (face.block == plane.block || !are_parallel(plane.normal, face.normal)) continue;
    const auto corners = corners_of(face, body);
    face.is_shared = std::all_of(corners.begin(), corners.end(), [&](const Vector<3>& corner) {
      return std::abs(plane.depth(corner)) <= std::min(plane.flush, face.flush);
    });
    return face.is_shared;
  }
  return false;
}

/// A sphere around the overlap.
struct Sphere {
  Vector<3> center;
  double radius;
};

Sphere sphere_around(const OverlapBody& body) {
  Vector<3> sum = Vector<3>::Zero();
  for (const Vector<3>& corner : body.corners) sum += corner;
  const Vector<3> center = sum / std::max(double(body.corners.size()), 1.0);
  double square = 0;
  for (const Vector<3>& corner : body.corners) square = std::max(square, (corner - center).squaredNorm());
  return {center, std::sqrt(square)};
}

/// Cuts by a face of the owner, if it reaches above the plane. Where the owner shares a face with the other
/// block, rounding must not decide.
bool cut_where_above(const Face& plane, PressureRoom<3>& room) {
  if (is_shared(plane, room.overlap)) return false;
  const Array<Vector<3>>& corners = room.overlap.corners;
  const auto is_above = [&](const Vector<3>& corner) { return plane.depth(corner) < 0; };
  if (std::none_of(corners.begin(), corners.end(), is_above)) return false;
  cut(plane, room);
  return true;
}

/// Cuts by the faces of the owner besides the first one that a sphere around the overlap meets, from the
/// nearest on.
void cut_by_owner(const Placed& owner, int first, PressureRoom<3>& room) {
  const Outline<3>& outline = owner.outline;
  Sphere sphere = sphere_around(room.overlap);
  const auto depth_of_center = [&](int f) {
    return outline.offset[f] - outline.normal(f).dot(sphere.center - owner.at);
  };
  int nearest = first;
  double least = HUGE_VAL;
  for (int f = 0; f < outline.face_count(); ++f) {
    const double depth = depth_of_center(f);
    if (f == first || depth >= least) continue;
    nearest = f;
    least = depth;
  }
  const auto cut_by = [&](int f) {
    if (depth_of_center(f) <= sphere.radius && cut_where_above(face_of(owner, f), room))
      sphere = sphere_around(room.overlap);
  };
  if (least > sphere.radius) return;
  cut_by(nearest);
  for (int f = 0; f < outline.face_count(); ++f) {
    if (f != first && f != nearest) cut_by(f);
  }
}

/// By cones from one corner to the faces.
Vector<3> centroid_of(const OverlapBody& body) {
  const Vector<3>& apex = body.corners.front();
  double volume = 0;
  Vector<3> moment = Vector<3>::Zero();
  for (const OverlapFace& face : body.faces) {
    const auto corners = corners_of(face, body);
    const double height = face.normal.dot(corners[0] - apex);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const Vector<3>&p = corners[0], &q = corners[i], &r = corners[i + 1];
      const double part = height * cross_product(q - p, r - p).dot(face.normal);
      volume += part;
      moment += part * (p + q + r);
    }
  }
  return volume > 0 ? Vector<3>(0.25 * (apex + moment / volume)) : apex;
}

struct Corner {
  const Vector<3>& at;
  double depth;
};

/// Calls `visit(p, q, r, area)` for the triangles of a face, with the depths of their corners below another.
template <class Visitor>
void for_each_triangle(const Face& below, const OverlapFace& face, const OverlapBody& body, Visitor visit) {
  const auto corners = corners_of(face, body);
  const auto corner = [&](std::size_t i) { return Corner{corners[i], below.depth(corners[i])}; };
  const Corner p = corner(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Corner q = corner(i), r = corner(i + 1);
    visit(p, q, r, 0.5 * cross_product(q.at - p.at, r.at - p.at).dot(face.normal));
  }
}

/// By the divergence theorem the depth integrated over the overlap is an integral over its surface.
PressureSums<3> sums_below(const Face& face, const OverlapBody& body) {
  PressureSums<3> sums;
  for (const OverlapFace& side : body.faces) {
    const double faces_down = -face.normal.dot(side.normal);
    const double pressed = pressed_part(side, face);
    double depths = 0, squares = 0;
    Vector<3> moment = Vector<3>::Zero();
    for_each_triangle(face, side, body, [&](const Corner& p, const Corner& q, const Corner& r, double area) {
      const double sum = p.depth + q.depth + r.depth;
      sums.depth = std::max({sums.depth, p.depth, q.depth, r.depth});
      depths += area / 3 * sum;
      squares +=
          area / 6 *
          (p.depth * (p.depth + q.depth) + q.depth * (q.depth + r.depth) + r.depth * (r.depth + p.depth));
      moment += area / 12 * ((sum + p.depth) * p.at + (sum + q.depth) * q.at + (sum + r.depth) * r.at);
      if (faces_down > 0) sums.add_base(p.at, q.at, r.at, faces_down * area);
    });
    sums.energy += 0.5 * faces_down * squares;
    sums.add_pressure(side.normal, pressed * depths, pressed * moment);
  }
  return sums;
}

/// Finds the overlap from a face on.
void find_overlap(const Placed (&blocks)[2], const Face& first, PressureRoom<3>& room) {
  begin_below(first, blocks[1 - first.block], room);
  cut(first, room);
  if (!room.overlap.faces.empty()) cut_by_owner(blocks[first.block], first.face, room);
}

/// The pair of a face, with the other block's vertex of the one near to it if that has the same face.
PotentialPair<3> pair_of(const Face& face, const PotentialPair<3>& near) {
  const bool is_of_a = face.block == 0;
  const auto kind = is_of_a ? PotentialPair<3>::face_vertex : PotentialPair<3>::vertex_face;
  if (near.kind == kind && (is_of_a ? near.a : near.b) == face.face) return near;
  return is_of_a ? PotentialPair<3>{kind, face.face, 0} : PotentialPair<3>{kind, 0, face.face};
}

}  // namespace

Pressure<3> pressure_between(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                             const PotentialPair<3>& near, PressureRoom<3>& room) {
  const Placed blocks[] = {{a, Vector<3>::Zero(), 0}, {b, to_b, 1}};
  Face first = first_face(blocks, near);
  for (bool is_second = false;; is_second = true) {
    find_overlap(blocks, first, room);
    const Array<OverlapFace>& faces = room.overlap.faces;
    if (faces.empty()) return no_pressure(first);
    const Vector<3> centroid = centroid_of(room.overlap);
    const Face face = least_face(blocks, first, faces, centroid);
    if (face.is_same(first) || is_second) {
      const PressureSums<3> sums = sums_below(face, room.overlap);
      return sums.is_empty() ? no_pressure(face) : sums.pressure(pair_of(face, near), face, centroid);
    }
    first = face;
  }
}

}  // namespace halfspace
