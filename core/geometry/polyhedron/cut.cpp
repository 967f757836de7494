#include "geometry/polyhedron/cut.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/polyhedron/check.h"
#include "geometry/polyhedron/simplify.h"
#include "geometry/polyhedron/topology.h"
#include "geometry/tolerances.h"
#include "geometry/unit_vector.h"

// A plane cuts a polyhedron into two parts:
//
//   compute the heights of all vertices over the plane, 0 to rounding
//   keep each face's vertices on the part's side; where an edge crosses, both parts get one new vertex
//   make the new face along the vertices on the plane, from loop to loop

namespace halfspace {
namespace {

using Flags = Array<std::uint8_t>;

/// The heights of the vertices over the cutting plane; 0 within rounding.
struct Section {
  Section(const Polyhedron& whole, const Vector<3>& point, const Vector<3>& normal, Memory* memory)
      : unit(unit_vector(normal)), heights(whole.vertices.size(), memory) {
    for (std::size_t i = 0; i < heights.size(); ++i) {
      const Vector<3> from_point = whole.vertices[i] - point;
      heights[i] = unit.dot(from_point);
      reach = std::max(reach, from_point.cwiseAbs().maxCoeff() + whole.vertices[i].cwiseAbs().maxCoeff());
    }
    for (double& h : heights) {
      if (std::abs(h) <= coplanarity_tolerance(reach)) h = 0;
    }
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    lowest = std::int32_t(low - heights.begin());
    highest = std::int32_t(high - heights.begin());
  }

  bool crosses() const { return depth_behind() > 0 && depth_ahead() > 0; }
  double depth_behind() const { return -heights[std::size_t(lowest)]; }
  double depth_ahead() const { return heights[std::size_t(highest)]; }

  Vector<3> unit;
  Array<double> heights;
  double reach = 0;
  std::int32_t lowest = 0;  // vertex
  std::int32_t highest = 0;
};

/// One part of a cut: its vertices inside, and those on the plane with an edge to one inside. So a face
/// without a vertex inside does not belong to the part, and only the new face lies in the plane.
class Part {
 public:
  /// side: -1 behind the plane, 1 ahead of it.
  Part(const Polyhedron& whole, const Topology& topology, const Section& section, int side, Memory* memory)
      : whole_(whole),
        topology_(topology),
        section_(section),
        side_(side),
        inside_(whole.vertices.size(), memory),
        place_of_vertex_(whole.vertices.size(), -1, memory),
        place_of_edge_(std::size_t(topology.edge_count), -1, memory),
        next_on_rim_(memory),
        part_(memory) {}

  /// Empty, with the reason, when nothing valid remains after rounding.
  Polyhedron make(Fault& fault) {
    if (!tell_inside_from_outside()) return nothing(fault, Fault::not_one_surface);
    for (std::int32_t f = 0; f < topology_.face_count; ++f) keep_inside_of_face(f);
    if (!close()) return nothing(fault, Fault::not_one_surface);
    // Edges at a small angle may have crossings that coincide to rounding.
    weld_short_edges(part_, 4 * machine_epsilon * section_.reach);
    const PolyhedronFault report = check_polyhedron(part_);
    if (report.fault != Fault::none) return nothing(fault, report.fault);
    return std::move(part_);
  }

 private:
  Polyhedron nothing(Fault& fault, Fault reason) {
    fault = reason;
    return Polyhedron(part_.memory());
  }

  double height(std::int32_t v) const { return side_ * section_.heights[std::size_t(v)]; }
  bool is_inside(std::int32_t v) const { return inside_[std::size_t(v)]; }

  /// Makes inside and outside connected, as convexity requires: then the plane crosses a ring of faces, once
  /// each. A vertex on the plane is outside if an edge connects it to one strictly outside. Otherwise
  /// rounding has moved it there and it is inside, as the ring would else pass a neighbour twice, unless all
  /// its neighbours are outside. False when rounding splits the inside.
  bool tell_inside_from_outside() {
    const std::int32_t farthest_inside = side_ > 0 ? section_.highest : section_.lowest;
    const std::int32_t farthest_outside = side_ > 0 ? section_.lowest : section_.highest;
    const auto is_outside = [&](std::int32_t v) { return height(v) <= 0; };
    const auto is_strictly_outside = [&](std::int32_t v) { return height(v) < 0; };
    const Flags outside = reached_from(farthest_outside, is_outside, is_strictly_outside);
    const auto is_left = [&](std::int32_t v) { return !outside[std::size_t(v)]; };
    inside_ = reached_from(farthest_inside, is_left, is_left);
    for (std::int32_t v = 0; v < whole_.vertex_count(); ++v)
      if (height(v) > 0 && !is_inside(v)) return false;
    return true;
  }

  /// Flags the wanted vertices that are connected to `vertex` through passable vertices only.
  template <class Wanted, class Passable>
  Flags reached_from(std::int32_t vertex, Wanted is_wanted, Passable is_passable) const {
    Flags reached(inside_.size(), false, part_.memory());
    Array<std::int32_t> waiting(1, vertex, part_.memory());
    reached[std::size_t(vertex)] = true;
    while (!waiting.empty()) {
      const std::int32_t v = waiting.back();
      waiting.pop_back();
      for (std::int32_t k = topology_.first_of_vertex[v]; k < topology_.first_of_vertex[v + 1]; ++k) {
        const std::int32_t w = topology_.vertex_neighbour[k];
        if (reached[std::size_t(w)] || !is_wanted(w)) continue;
        reached[std::size_t(w)] = true;
        if (is_passable(w)) waiting.push_back(w);
      }
    }
    return reached;
  }

  std::int32_t append(const Vector<3>& vertex) {
    part_.vertices.push_back(vertex);
    next_on_rim_.push_back(-1);
    return part_.vertex_count() - 1;
  }

  std::int32_t kept(std::int32_t v) {
    std::int32_t& place = place_of_vertex_[std::size_t(v)];
    if (place < 0) place = append(whole_.vertices[std::size_t(v)]);
    return place;
  }

  /// The vertex where the plane crosses an edge. Computed from the end behind the plane to the end ahead, so
  /// that both parts, and both faces of the edge, get the same bits.
  std::int32_t crossing(std::int32_t edge, std::int32_t outer) {
    if (height(outer) == 0) return kept(outer);
    std::int32_t& place = place_of_edge_[std::size_t(edge)];
    if (place < 0) {
      std::int32_t behind = topology_.edge_start[edge];
      std::int32_t ahead = topology_.edge_end[edge];
      if (section_.heights[std::size_t(behind)] > 0) std::swap(behind, ahead);
      const double below = section_.heights[std::size_t(behind)];
      const double above = section_.heights[std::size_t(ahead)];
      const Vector<3>& from = whole_.vertices[std::size_t(behind)];
      const Vector<3>& to = whole_.vertices[std::size_t(ahead)];
      place = append(from + below / (below - above) * (to - from));
    }
    return place;
  }

  void keep_inside_of_face(std::int32_t face) {
    const std::int32_t* const vertices = topology_.face_vertex + topology_.first_of_face[face];
    const std::int32_t* const edges = topology_.face_edge + topology_.first_of_face[face];
    const std::int32_t count = topology_.first_of_face[face + 1] - topology_.first_of_face[face];
    const auto next = [&](std::int32_t i) { return i + 1 == count ? 0 : i + 1; };

    std::int32_t entry = -1;  // the outside corner before the first inside
    bool has_inside = false;
    for (std::int32_t i = 0; i < count; ++i) {
      has_inside = has_inside || is_inside(vertices[i]);
      if (!is_inside(vertices[i]) && is_inside(vertices[next(i)])) entry = i;
    }
    if (!has_inside) return;
    if (entry < 0) {
      for (std::int32_t i = 0; i < count; ++i) part_.append_corner(kept(vertices[i]));
    } else {
      const std::int32_t enters = crossing(edges[entry], vertices[entry]);
      part_.append_corner(enters);
      std::int32_t i = next(entry);
      for (; is_inside(vertices[next(i)]); i = next(i)) part_.append_corner(kept(vertices[i]));
      part_.append_corner(kept(vertices[i]));
      const std::int32_t leaves = crossing(edges[i], vertices[next(i)]);
      if (leaves != enters) {
        part_.append_corner(leaves);
        next_on_rim_[std::size_t(enters)] = leaves;
      }
    }
    part_.end_face();
    part_.normals.push_back(whole_.normals[std::size_t(face)]);
  }

  /// Makes the new face along the rim; false if the rim is not one ring.
  bool close() {
    const auto is_rim = [](std::int32_t next) { return next >= 0; };
    const auto on_rim = std::count_if(next_on_rim_.begin(), next_on_rim_.end(), is_rim);
    if (on_rim < 3) return false;
    const auto first =
        std::int32_t(std::find_if(next_on_rim_.begin(), next_on_rim_.end(), is_rim) - next_on_rim_.begin());
    std::int32_t v = first;
    for (auto left = on_rim; left > 0; --left) {
      part_.append_corner(v);
      v = next_on_rim_[std::size_t(v)];
      if (v < 0 || (v == first) != (left == 1)) return false;
    }
    part_.end_face();
    part_.normals.push_back(double(-side_) * section_.unit);
    return true;
  }

  const Polyhedron& whole_;
  const Topology& topology_;
  const Section& section_;
  int side_;
  Flags inside_;
  Array<std::int32_t> place_of_vertex_;  // index in the part, or -1
  Array<std::int32_t> place_of_edge_;    // index of the edge's crossing in the part, or -1
  Array<std::int32_t> next_on_rim_;      // counter-clockwise around the new face; -1 for vertices off it
  Polyhedron part_;
};

}  // namespace

PolyhedronParts cut_polyhedron(const Polyhedron& whole, const Vector<3>& point, const Vector<3>& normal,
                               Memory* memory) {
  const Section section(whole, point, normal, memory);
  PolyhedronParts parts{Polyhedron(memory), Polyhedron(memory)};
  if (section.crosses()) {
    const TopologyArrays topology(whole, memory);
    parts.behind = Part(whole, topology.view(), section, -1, memory).make(parts.too_thin);
    parts.ahead = Part(whole, topology.view(), section, 1, memory).make(parts.too_thin);
    if (parts.too_thin == Fault::none) return parts;
  }
  const bool is_ahead = section.depth_ahead() > section.depth_behind();
  (is_ahead ? parts.ahead : parts.behind) = Polyhedron(whole, memory);
  (is_ahead ? parts.behind : parts.ahead) = Polyhedron(memory);
  return parts;
}

}  // namespace halfspace
