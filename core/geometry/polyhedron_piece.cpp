#include "geometry/polyhedron_piece.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace halfspace {

void PolyhedronPiece::begin(const PolyhedronView& whole) {
  const std::size_t edges = std::size_t(whole.first_of_face[whole.face_count]) / 2;
  make_room(std::size_t(whole.vertex_count), edges, std::size_t(whole.face_count));
  vertices_.begin(0);
  corner_end_ = corner_.data();
  face_count_ = 0;
}

void PolyhedronPiece::make_room(std::size_t vertices, std::size_t edges, std::size_t faces) {
  const std::size_t most_corners = 5 * edges + 1, most_faces = faces + edges;
  if (corner_.size() < most_corners) corner_.resize(most_corners);
  if (first_of_face_.size() < most_faces + 1) first_of_face_.resize(most_faces + 1);
  vertices_.reserve(vertices + edges);
}

void PolyhedronPiece::end_face() {
  std::int32_t* const first = corner_.data() + first_of_face_[std::size_t(face_count_)];
  if (corner_end_ - first < 3) {
    corner_end_ = first;
  } else {
    first_of_face_[std::size_t(++face_count_)] = std::int32_t(corner_end_ - corner_.data());
  }
}

/// In place of a part that nobody wants.
struct PolyhedronPiece::Cutter::NoPiece {
  struct NoVertices {
    std::int32_t add(double, double, double, bool = true) { return 0; }
    void end() {}
  };

  void begin(const PolyhedronView&) {}
  void add_corner(std::int32_t, bool = true) {}
  void end_face() {}
  void end_old_faces() {}

  NoVertices vertices_;
};

void PolyhedronPiece::Cutter::part(const PolyhedronView& whole, const Sounding& sounding,
                                   PolyhedronPiece& inside, PolyhedronPiece& outside) {
  part_at_plane(whole, sounding, inside, outside);
}

void PolyhedronPiece::Cutter::keep_inside(const PolyhedronView& whole, const Sounding& sounding,
                                          PolyhedronPiece& inside) {
  NoPiece outside;
  part_at_plane(whole, sounding, inside, outside);
}

template <class Outside>
void PolyhedronPiece::Cutter::part_at_plane(const PolyhedronView& whole, const Sounding& sounding,
                                            PolyhedronPiece& inside, Outside& outside) {
  inside.begin(whole);
  outside.begin(whole);
  crossings_.clear();
  place_vertices(whole, sounding, inside, outside);
  for (int face = 0; face <= whole.face_count; ++face) {
    if (face == whole.old_face_count) {
      inside.end_old_faces();
      outside.end_old_faces();
    }
    if (face < whole.face_count && !take_face(whole, face, inside, outside))
      part_face(whole, face, sounding, inside, outside);
  }
  close(inside, outside);
  inside.vertices_.end();
  outside.vertices_.end();
}

template <class Outside>
void PolyhedronPiece::Cutter::place_vertices(const PolyhedronView& whole, const Sounding& sounding,
                                             PolyhedronPiece& inside, Outside& outside) {
  if (place_.size() < std::size_t(whole.vertex_count)) place_.resize(std::size_t(whole.vertex_count));
  for (int v = 0; v < whole.vertex_count; ++v) {
    const bool is_inside = sounding.is_inside(v);
    const std::int32_t in = inside.vertices_.add(whole.x[v], whole.y[v], whole.z[v], is_inside);
    const std::int32_t out = outside.vertices_.add(whole.x[v], whole.y[v], whole.z[v], !is_inside);
    place_[std::size_t(v)] = is_inside ? in : ~out;
  }
}

/// When all of it is on one side, as most faces are.
template <class Outside>
bool PolyhedronPiece::Cutter::take_face(const PolyhedronView& whole, int face, PolyhedronPiece& inside,
                                        Outside& outside) {
  const std::int32_t *first = whole.corner + whole.first_of_face[face],
                     *end = whole.corner + whole.first_of_face[face + 1];
  const bool first_is_inside = is_inside(*first);
  for (const std::int32_t* corner = first + 1; corner != end; ++corner)
    if (is_inside(*corner) != first_is_inside) return false;
  if (first_is_inside) {
    for (const std::int32_t* corner = first; corner != end; ++corner) inside.add_corner(place(*corner));
    inside.end_face();
  } else {
    for (const std::int32_t* corner = first; corner != end; ++corner) outside.add_corner(~place(*corner));
    outside.end_face();
  }
  return true;
}

/// One step of Sutherland and Hodgman (1974), for both sides. The new faces run from where the outline of
/// this one comes back to where it left, and the other way; rounding may make it leave more than once.
template <class Outside>
void PolyhedronPiece::Cutter::part_face(const PolyhedronView& whole, int face, const Sounding& sounding,
                                        PolyhedronPiece& inside, Outside& outside) {
  std::int32_t left_at = -1, first_left_at = -1, back_at = -1, first_back_at = -1;
  const auto follow_inside = [&](std::int32_t back, std::int32_t left) {
    crossings_[std::size_t(back)].next_inside = left;
  };
  const auto follow_outside = [&](std::int32_t left, std::int32_t back) {
    crossings_[std::size_t(left)].next_outside = back;
  };
  const std::int32_t end = whole.first_of_face[face + 1];
  std::int32_t before = whole.corner[end - 1];
  for (std::int32_t k = whole.first_of_face[face]; k < end; ++k) {
    const std::int32_t here = whole.corner[k];
    if (is_inside(before) && !is_inside(here)) {
      left_at = cross(whole, before, here, sounding, inside, outside);
      if (back_at < 0) {
        first_left_at = left_at;
      } else {
        follow_outside(left_at, back_at);
      }
    } else if (!is_inside(before) && is_inside(here)) {
      back_at = cross(whole, before, here, sounding, inside, outside);
      if (left_at < 0) {
        first_back_at = back_at;
      } else {
        follow_inside(back_at, left_at);
      }
    }
    inside.add_corner(place(here), is_inside(here));
    outside.add_corner(~place(here), !is_inside(here));
    before = here;
  }
  if (first_left_at >= 0) follow_outside(first_left_at, back_at);
  if (first_back_at >= 0) follow_inside(first_back_at, left_at);
  inside.end_face();
  outside.end_face();
}

/// The faces on either side of an edge get the same vertex.
template <class Outside>
std::int32_t PolyhedronPiece::Cutter::cross(const PolyhedronView& whole, std::int32_t from, std::int32_t to,
                                            const Sounding& sounding, PolyhedronPiece& inside,
                                            Outside& outside) {
  std::int32_t index = 0;
  for (Crossing& crossing : crossings_) {
    if (crossing.awaited_from == from && crossing.awaited_to == to) {
      crossing.awaited_from = -1;
      inside.add_corner(crossing.inside);
      outside.add_corner(crossing.outside);
      return index;
    }
    ++index;
  }
  const std::int32_t inner = is_inside(from) ? from : to, outer = is_inside(from) ? to : from;
  add_between(whole, inner, outer, sounding.share_inside(inner, outer), [&](double x, double y, double z) {
    const std::int32_t in = inside.vertices_.add(x, y, z), out = outside.vertices_.add(x, y, z);
    inside.add_corner(in);
    outside.add_corner(out);
    crossings_.push_back({to, from, in, out, -1, -1});
  });
  return index;
}

/// Should rounding have torn the new face apart, its pieces become faces each.
template <class Outside>
void PolyhedronPiece::Cutter::close(PolyhedronPiece& inside, Outside& outside) {
  const auto add_loops = [&](auto& part, std::int32_t Crossing::*vertex, std::int32_t Crossing::*next) {
    for (Crossing& start : crossings_) {
      if (start.*next < 0) continue;
      for (Crossing* at = &start; at->*next >= 0;) {
        part.add_corner(at->*vertex);
        at = &crossings_[std::size_t(std::exchange(at->*next, -1))];
      }
      part.end_face();
    }
  };
  add_loops(inside, &Crossing::inside, &Crossing::next_inside);
  if constexpr (!std::is_same_v<Outside, NoPiece>)
    add_loops(outside, &Crossing::outside, &Crossing::next_outside);
}

/// As tetrahedra from one vertex to triangles of the faces that it is not a corner of. None has a negative
/// volume but by rounding; left out, they keep the centroid inside, however flat the piece.
VolumeAndMoment measure(const PolyhedronView& piece) {
  if (piece.vertex_count == 0) return {};
  const double *x = piece.x, *y = piece.y, *z = piece.z;
  const double x0 = x[0], y0 = y[0], z0 = z[0];
  double sum = 0, sum_x = 0, sum_y = 0, sum_z = 0;
  for (int face = 0; face < piece.face_count; ++face) {
    const std::int32_t *corner = piece.corner + piece.first_of_face[face],
                       *end = piece.corner + piece.first_of_face[face + 1];
    const std::int32_t* at_first_vertex = corner;
    while (at_first_vertex != end && *at_first_vertex != 0) ++at_first_vertex;
    if (at_first_vertex != end) continue;
    const std::int32_t p = *corner++;
    const double px = x[p] - x0, py = y[p] - y0, pz = z[p] - z0;
    const std::int32_t q = *corner++;
    double qx = x[q] - x0, qy = y[q] - y0, qz = z[q] - z0;
    for (; corner != end; ++corner) {
      const std::int32_t r = *corner;
      const double rx = x[r] - x0, ry = y[r] - y0, rz = z[r] - z0;
      const double volume =
          std::max(px * (qy * rz - qz * ry) + py * (qz * rx - qx * rz) + pz * (qx * ry - qy * rx), 0.0);
      sum += volume;
      sum_x += volume * (px + qx + rx);
      sum_y += volume * (py + qy + ry);
      sum_z += volume * (pz + qz + rz);
      qx = rx;
      qy = ry;
      qz = rz;
    }
  }
  sum /= 6;
  return {sum, {sum_x / 24 + sum * x0, sum_y / 24 + sum * y0, sum_z / 24 + sum * z0}};
}

}  // namespace halfspace
