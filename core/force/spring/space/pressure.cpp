#include <span>

#include "force/spring/pressure_sums.h"
#include "narrow_phase/pair.h"

namespace halfspace {
namespace {

using Placed = PlacedOutline<3>;
using Face = PressureFace<3>;

struct Start {
  int block;
  int face;
};

/// A face where the search starts. Of two edges, one beside the first.
Start start_of(const Outline<3>& a, const PotentialPair<3>& near) {
  switch (near.kind) {
    case PotentialPair<3>::face_vertex:
      return {0, near.a};
    case PotentialPair<3>::vertex_face:
      return {1, near.b};
    case PotentialPair<3>::edge_edge:
      return {0, a.topology->edge_left[near.a]};
    default:
      return {0, 0};
  }
}

std::span<const std::int32_t> vertices_of(const Placed& block, int face) {
  const Topology& topology = *block.outline.topology;
  const std::int32_t first = topology.first_of_face[face];
  return {topology.face_vertex + first, std::size_t(topology.first_of_face[face + 1] - first)};
}

/// The faces of a block of which a vertex fulfils the condition.
template <class Condition>
void find_faces(const Placed& block, Array<std::int32_t>& faces, Condition condition) {
  faces.clear();
  for (int f = 0; f < block.outline.face_count(); ++f) {
    const auto vertices = vertices_of(block, f);
    if (std::any_of(vertices.begin(), vertices.end(), [&](int v) { return condition(block.vertex(v)); }))
      faces.push_back(f);
  }
}

/// Keeps of the polygon in the room what lies in a half-space. False if nothing is left.
bool cut(const Face& face, PressureRoom<3>& room) {
  const Array<Vector<3>>& whole = room.polygon;
  bool any_inside = false, any_outside = false;
  for (const Vector<3>& corner : whole) {
    const double depth = face.depth(corner);
    any_inside |= depth > 0;
    any_outside |= depth < 0;
  }
  if (!any_outside) return true;
  if (!any_inside) return false;
  Array<Vector<3>>& part = room.clipped;
  part.clear();
  const Vector<3>* before = &whole.back();
  double depth_before = face.depth(*before);
  for (const Vector<3>& corner : whole) {
    const double depth = face.depth(corner);
    if ((depth >= 0) != (depth_before >= 0)) {
      // From its inner to its outer end, so that both faces at the edge get the same bits.
      const bool enters = depth >= 0;
      const Vector<3>&inner = enters ? corner : *before, &outer = enters ? *before : corner;
      const double inside = enters ? depth : depth_before, outside = enters ? depth_before : depth;
      part.push_back(inner + inside / (inside - outside) * (outer - inner));
    }
    if (depth >= 0) part.push_back(corner);
    before = &corner;
    depth_before = depth;
  }
  room.polygon.swap(room.clipped);
  return room.polygon.size() > 2;
}

/// Does the polygon in the room, with this outer normal, lie on a face that looks the same way, up to
/// rounding?
bool lies_on(const Face& face, const Vector<3>& normal, const PressureRoom<3>& room) {
  return std::all_of(room.polygon.begin(), room.polygon.end(),
                     [&](const Vector<3>& corner) { return are_flush(face, normal, face.depth(corner)); });
}

/// The parts of a block's near faces inside the near half-spaces of the other.
void add_faces(const Placed& block, std::span<const std::int32_t> near, const Placed& other,
               std::span<const std::int32_t> near_of_other, PressureRoom<3>& room) {
  for (const std::int32_t f : near) {
    room.polygon.clear();
    for (const std::int32_t v : vertices_of(block, f)) room.polygon.push_back(block.vertex(v));
    const Vector<3> normal = block.outline.normal(f);
    bool is_shared = false;
    const auto is_cut_away = [&](std::int32_t g) {
      const Face face(other, g);
      if (!lies_on(face, normal, room)) return !cut(face, room);
      is_shared = true;
      return false;
    };
    if (std::any_of(near_of_other.begin(), near_of_other.end(), is_cut_away)) continue;
    const std::int32_t first = std::int32_t(room.corners.size());
    room.corners.insert(room.corners.end(), room.polygon.begin(), room.polygon.end());
    room.faces.push_back({normal, block.block, is_shared, first, std::int32_t(room.corners.size())});
  }
}

struct Corner {
  const Vector<3>& at;
  double depth;
};

/// Calls `visit(p, q, r, area)` for the triangles of a face, with the depths of their corners below another.
/// One that both blocks share counts half for each.
template <class Visitor>
void for_each_triangle(const Face& below, const OverlapFace& face, const Array<Vector<3>>& corners,
                       Visitor visit) {
  const auto corner = [&](std::int32_t i) {
    const Vector<3>& at = corners[std::size_t(i)];
    return Corner{at, below.depth(at)};
  };
  const Corner p = corner(face.first);
  const double part = face.is_shared ? 0.25 : 0.5;
  for (std::int32_t i = face.first + 1; i + 1 < face.end; ++i) {
    const Corner q = corner(i), r = corner(i + 1);
    visit(p, q, r, part * cross_product(q.at - p.at, r.at - p.at).dot(face.normal));
  }
}

/// The depth below a face, integrated over the overlap. By the divergence theorem it is an integral over the
/// surface.
double energy_below(const Face& face, const PressureRoom<3>& room) {
  double energy = 0;
  for (const OverlapFace& side : room.faces) {
    double squares = 0;
    for_each_triangle(
        face, side, room.corners, [&](const Corner& p, const Corner& q, const Corner& r, double area) {
          squares +=
              area / 6 *
              (p.depth * (p.depth + q.depth) + q.depth * (q.depth + r.depth) + r.depth * (r.depth + p.depth));
        });
    energy -= 0.5 * face.normal.dot(side.normal) * squares;
  }
  return energy;
}

PressureSums<3> sums_below(const Face& face, int owner, const PressureRoom<3>& room) {
  PressureSums<3> sums;
  for (const OverlapFace& side : room.faces) {
    const double faces_down = -face.normal.dot(side.normal);
    for_each_triangle(face, side, room.corners,
                      [&](const Corner& p, const Corner& q, const Corner& r, double area) {
                        if (side.block != owner) {
                          const double sum = p.depth + q.depth + r.depth;
                          const Vector<3> moment =
                              sum * (p.at + q.at + r.at) + p.depth * p.at + q.depth * q.at + r.depth * r.at;
                          sums.add_pressure(side.normal, area / 3 * sum, area / 12 * moment);
                        }
                        const auto foot = [&](const Corner& corner) {
                          return Vector<3>(corner.at + corner.depth * face.normal);
                        };
                        if (faces_down > 0) sums.add_base(foot(p), foot(q), foot(r), faces_down * area);
                      });
  }
  return sums;
}

}  // namespace

Pressure<3> pressure_between(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b,
                             const PotentialPair<3>& near, PressureRoom<3>& room) {
  const Placed blocks[] = {{a, Vector<3>::Zero(), 0}, {b, to_b, 1}};
  Array<std::int32_t>* const near_faces[] = {&room.near_a, &room.near_b};
  const Start start = start_of(a, near);
  const Placed &first_owner = blocks[start.block], &first_other = blocks[1 - start.block];
  const Face first(first_owner, start.face);
  double reach = 0;
  for (int v = 0; v < first_other.outline.vertex_count(); ++v)
    reach = std::max(reach, first.depth(first_other.vertex(v)));
  Pressure<3> pressure;
  if (!(reach > 0)) return pressure;
  find_faces(first_owner, *near_faces[start.block],
             [&](const Vector<3>& p) { return first.depth(p) < reach; });
  find_faces(first_other, *near_faces[1 - start.block],
             [&](const Vector<3>& p) { return first.depth(p) > 0; });
  room.faces.clear();
  room.corners.clear();
  add_faces(blocks[0], room.near_a, blocks[1], room.near_b, room);
  add_faces(blocks[1], room.near_b, blocks[0], room.near_a, room);
  if (room.faces.empty()) return pressure;

  const auto place_of = [](const Vector<3>& corner) { return corner; };
  const LeastFace least = least_face(
      blocks,
      [&](const Face& face, double limit) { return greatest_depth(face, room.corners, limit, place_of); },
      [&](const Face& face) { return energy_below(face, room); });
  if (!least.is_found()) return pressure;
  const Placed &owner = blocks[least.block], &pressed = blocks[1 - least.block];
  const Face face(owner, least.face);
  const PressureSums<3> sums = sums_below(face, least.block, room);
  if (!(sums.base > 0)) return pressure;
  PotentialPair<3> pair = least.block == 0 ? PotentialPair<3>{PotentialPair<3>::face_vertex, least.face, 0}
                                           : PotentialPair<3>{PotentialPair<3>::vertex_face, 0, least.face};
  refresh(a, b, to_b, pair);
  return sums.pressure(pair, face.normal, least.energy, owner, pressed);
}

}  // namespace halfspace
