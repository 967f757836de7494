#include <algorithm>
#include <span>
#include <utility>

#include "force/spring/pressure_sums.h"
#include "geometry/polygon/clip.h"
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

/// Appends the part of a face below a plane, and its edges on the plane to the rim: by rounding a face with
/// corners close together may have several. Points on the plane are outside. `corner(i)` and `depth(i)` are
/// those of the face's corners.
template <class Corner, class Depth>
void cut_face(const OverlapFace& face, std::size_t count, Corner corner, Depth depth, OverlapBody& part,
              Array<RimEdge>& rim) {
  const std::size_t begin = part.corners.size(), rim_begin = rim.size();
  std::size_t before = count - 1;
  double depth_before = depth(before);
  Vector<3> left = Vector<3>::Zero();  // where the boundary has left the part
  for (std::size_t i = 0; i < count; before = i++) {
    const double depth_here = depth(i);
    if ((depth_here > 0) != (depth_before > 0)) {
      const bool enters = depth_here > 0;
      const Vector<3>&inner = corner(enters ? i : before), &outer = corner(enters ? before : i);
      const double inside = enters ? depth_here : depth_before, outside = enters ? depth_before : depth_here;
      part.corners.push_back(crossing(inner, -inside, outer, -outside));
      if (enters)
        rim.push_back({part.corners.back(), left});
      else
        left = part.corners.back();
    }
    if (depth_here > 0) part.corners.push_back(corner(i));
    depth_before = depth_here;
  }
  if (depth_before <= 0 && rim.size() > rim_begin) rim[rim_begin].end = left;
  if (part.corners.size() == begin) return;
  OverlapFace& rest = part.faces.emplace_back(face);
  rest.first = std::int32_t(begin);
  rest.end = std::int32_t(part.corners.size());
}

/// The face that a cut leaves on its plane: each edge of the rim begins at the end of another. Rounding may
/// make it several loops, each a face.
void close_rim(const Face& plane, OverlapBody& body, Array<RimEdge>& rim) {
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

/// The part of a block below the first face.
void begin_below(const Face& first, const Placed& block, PressureRoom<3>& room) {
  room.overlap.clear();
  room.rim.clear();
  room.vertices.clear();
  const Topology& topology = *block.outline.topology;
  room.is_below.assign(std::size_t(block.outline.face_count()), false);
  for (int v = 0; v < block.outline.vertex_count(); ++v) {
    const Vector<3> at = block.vertex(v);
    const double depth = first.depth(at);
    room.vertices.push_back({at, depth});
    if (!(depth > 0)) continue;
    for (int k = topology.first_of_vertex[v]; k < topology.first_of_vertex[v + 1]; ++k)
      room.is_below[std::size_t(topology.vertex_face[k])] = true;
  }
  for (int f = 0; f < block.outline.face_count(); ++f) {
    if (!room.is_below[std::size_t(f)]) continue;
    const auto vertices = vertices_of(block, f);
    const auto vertex = [&](std::size_t i) -> const PlacedVertex& {
      return room.vertices[std::size_t(vertices[i])];
    };
    cut_face(
        {block.outline.normal(f), block.block, f, flush_of(block, f), false, 0, 0}, vertices.size(),
        [&](std::size_t i) -> const Vector<3>& { return vertex(i).at; },
        [&](std::size_t i) { return vertex(i).depth; }, room.overlap, room.rim);
  }
  close_rim(first, room.overlap, room.rim);
}

/// Keeps of the overlap what lies below a plane.
void cut(const Face& plane, PressureRoom<3>& room) {
  room.clipped.clear();
  room.rim.clear();
  for (const OverlapFace& face : room.overlap.faces) {
    const auto corners = corners_of(face, room.overlap);
    cut_face(
        face, corners.size(), [&](std::size_t i) -> const Vector<3>& { return corners[i]; },
        [&](std::size_t i) { return plane.depth(corners[i]); }, room.clipped, room.rim);
  }
  close_rim(plane, room.clipped, room.rim);
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

/// The sum of cones from one corner to the faces that do not have it.
OverlapVolume<3> volume_of(const OverlapBody& body) {
  const Vector<3>& apex = body.corners.front();
  double volume = 0;
  Vector<3> moment = Vector<3>::Zero();
  for (const OverlapFace& face : body.faces) {
    const auto corners = corners_of(face, body);
    if (corners.size() < 3) continue;  // rounding may leave a face without an area
    const Vector<3> p = corners[0] - apex;
    const double height = face.normal.dot(p);
    if (height == 0) continue;
    Vector<3> q = corners[1] - apex, across = q - p;
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const Vector<3> r = corners[i] - apex, next = r - p;
      const double part = height * cross_product(across, next).dot(face.normal);
      volume += part;
      moment += part * (p + q + r);
      q = r;
      across = next;
    }
  }
  if (!(volume > 0)) return {0, apex};
  return {volume / 6, apex + 0.25 / volume * moment};
}

/// Calls `visit(p, q, r, area)` for the triangles of a face.
template <class Visitor>
void for_each_triangle(const OverlapFace& face, const OverlapBody& body, Visitor visit) {
  const auto corners = corners_of(face, body);
  const Vector<3>& p = corners[0];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Vector<3>&q = corners[i], &r = corners[i + 1];
    visit(p, q, r, 0.5 * cross_product(q - p, r - p).dot(face.normal));
  }
}

void keep_pressure(const Face& face, const OverlapFace& side, double part, const OverlapBody& body,
                   PressureSums<3>& sums) {
  double depths = 0;
  Vector<3> moment = Vector<3>::Zero();
  for_each_triangle(side, body, [&](const Vector<3>& p, const Vector<3>& q, const Vector<3>& r, double area) {
    const double at_p = face.depth(p), at_q = face.depth(q), at_r = face.depth(r), sum = at_p + at_q + at_r;
    depths += area / 3 * sum;
    moment += area / 12 * ((sum + at_p) * p + (sum + at_q) * q + (sum + at_r) * r);
  });
  sums.keep(side.normal, part * depths, part * moment);
}

PressureSums<3> sums_below(const Face& face, const OverlapBody& body) {
  PressureSums<3> sums;
  for (const Vector<3>& corner : body.corners) sums.depth = std::max(sums.depth, face.depth(corner));
  for (const OverlapFace& side : body.faces) {
    if (const double part = kept_part(side, face); part > 0) keep_pressure(face, side, part, body, sums);
    const double faces_up = face.normal.dot(side.normal);
    if (!(faces_up > 0)) continue;
    for_each_triangle(side, body,
                      [&](const Vector<3>& p, const Vector<3>& q, const Vector<3>& r, double area) {
                        sums.add_base(p, q, r, faces_up * area);
                      });
  }
  return sums;
}

/// Finds the overlap from a face on.
void find_overlap(const Placed (&blocks)[2], const Face& first, PressureRoom<3>& room) {
  begin_below(first, blocks[1 - first.block], room);
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
    const OverlapVolume<3> overlap = volume_of(room.overlap);
    const Face face = face_of_min_energy(blocks, first, faces, overlap.centroid);
    if (face.is_same(first) || is_second)
      return sums_below(face, room.overlap).pressure(pair_of(face, near), face, overlap);
    first = face;
  }
}

}  // namespace halfspace
