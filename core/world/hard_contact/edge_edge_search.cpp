#include <algorithm>
#include <cmath>

#include "geometry/tolerances.h"
#include "world/hard_contact/point_contact_search.h"

// Edges that meet in space. Two edges touch where they are nearest, along the normal of both, if it lies
// between those of the faces on either side of each (Wang et al. 2021, section 2.4.3).

namespace halfspace {

/// An edge where it is now, and where it will be at the end of the predicted motion.
struct MovingEdge {
  struct Place {
    std::array<Vector<3>, 2> end;
    std::array<Vector<3>, 2> beside;  // a corner of the face on either side
    Vector<3> outwards;               // somewhere between the normals of both faces

    Vector<3> along() const { return end[1] - end[0]; }
    Vector<3> at(double share) const { return end[0] + share * along(); }
    /// From the edge into a face.
    Vector<3> inwards(std::size_t face) const {
      const Vector<3> way = beside[face] - end[0];
      return way - way.dot(along()) / along().squaredNorm() * along();
    }
    /// Faces that meet at a flat or hollow angle make no edge that others meet: their corners do.
    bool is_sharp() const;
  };

  std::array<MaterialPoint<3>, 2> end;
  Place now;
  Place predicted;
};

namespace {

/// The places along two edges, from 0 to 1, where they are nearest to each other.
struct NearestPlaces {
  double on_a = 0;
  double on_b = 0;

  bool is_between_ends() const {
    return on_a >= end_reach && on_a <= 1 - end_reach && on_b >= end_reach && on_b <= 1 - end_reach;
  }
};

NearestPlaces nearest(const MovingEdge::Place& a, const MovingEdge::Place& b) {
  const Vector<3> across = cross_product(a.along(), b.along()), way = b.end[0] - a.end[0];
  const double squared = across.squaredNorm();
  return {cross_product(way, b.along()).dot(across) / squared,
          cross_product(way, a.along()).dot(across) / squared};
}

/// The normal of two edges, outwards from b.
Vector<3> normal_of(const MovingEdge::Place& a, const MovingEdge::Place& b) {
  const Vector<3> normal = cross_product(a.along(), b.along()).normalized();
  return normal.dot(b.outwards) < 0 ? Vector<3>(-normal) : normal;
}

bool are_parallel(const MovingEdge::Place& a, const MovingEdge::Place& b) {
  return !(cross_product(a.along(), b.along()).norm() >
           strictly_parallel * a.along().norm() * b.along().norm());
}

/// Does the plane between two edges have the faces of both behind it, each on its side? Faces that lie flush
/// are in that plane.
bool is_between(const MovingEdge::Place& a, const MovingEdge::Place& b) {
  const Vector<3> normal = normal_of(a, b);
  const auto is_behind = [](const Vector<3>& outwards, const Vector<3>& inwards) {
    return outwards.dot(inwards) <= strictly_parallel * inwards.norm();
  };
  return is_behind(normal, b.inwards(0)) && is_behind(normal, b.inwards(1)) &&
         is_behind(-normal, a.inwards(0)) && is_behind(-normal, a.inwards(1));
}

}  // namespace

bool MovingEdge::Place::is_sharp() const {
  const Vector<3> one = inwards(0).normalized(), other = inwards(1).normalized();
  return cross_product(one, other).norm() > strictly_parallel && outwards.dot(one + other) < 0;
}

template <>
int PointContactSearch<3>::edge_count(std::size_t slot) const {
  if (blocks_.is_of_mesh(slot)) return first_edge_[slot + 1] - first_edge_[slot];
  return blocks_.own_outline(std::int32_t(slot)).edge_count();
}

template <>
EdgeBound PointContactSearch<3>::bound_of_edge(std::int32_t block, int which) const {
  const std::size_t slot = std::size_t(block);
  Vector<3> from, to;
  if (blocks_.is_of_mesh(slot)) {
    const SurfaceEdge& of_mesh = edges_[std::size_t(first_edge_[slot] + which)];
    from = node_now(slot, of_mesh.node[0]);
    to = node_now(slot, of_mesh.node[1]);
  } else {
    const Topology& topology = *blocks_.own_outline(block).topology;
    from = corner_now(slot, topology.edge_start[which]);
    to = corner_now(slot, topology.edge_end[which]);
  }
  return {0.5 * (from + to), 0.5 * (to - from).norm()};
}

template <>
MovingEdge PointContactSearch<3>::edge(std::int32_t block, int which) const {
  const std::size_t slot = std::size_t(block);
  MovingEdge edge;
  if (blocks_.is_of_mesh(slot)) {
    const SurfaceEdge& of_mesh = edges_[std::size_t(first_edge_[slot] + which)];
    for (std::size_t i = 0; i < 2; ++i) {
      edge.end[i].block = block;
      edge.end[i].node.fill(of_mesh.node[i]);
      edge.end[i].weight = Vector<3>::Unit(0);
      edge.now.end[i] = node_now(slot, of_mesh.node[i]);
      edge.now.beside[i] = node_now(slot, of_mesh.beside[i]);
      edge.predicted.end[i] =
          edge.now.end[i] + integrator_.predicted_displacement_of_node(std::size_t(of_mesh.node[i]));
      edge.predicted.beside[i] =
          edge.now.beside[i] + integrator_.predicted_displacement_of_node(std::size_t(of_mesh.beside[i]));
    }
    edge.now.outwards = edge.predicted.outwards =
        outwards_[std::size_t(of_mesh.node[0])] + outwards_[std::size_t(of_mesh.node[1])];
    return edge;
  }
  const Outline<3> own = blocks_.own_outline(block);
  const Topology& topology = *own.topology;
  const int corner[] = {topology.edge_start[which], topology.edge_end[which]};
  for (std::size_t i = 0; i < 2; ++i) {
    edge.end[i] = corner_of(block, corner[i]);
    edge.now.end[i] = corner_now(slot, corner[i]);
    edge.predicted.end[i] = predicted_corner(slot, corner[i]);
  }
  const int face[] = {topology.edge_left[which], topology.edge_right[which]};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::int32_t* of_face = topology.face_vertex + topology.first_of_face[face[i]];
    int third = 0;
    while (of_face[third] == corner[0] || of_face[third] == corner[1]) ++third;
    edge.now.beside[i] = corner_now(slot, of_face[third]);
    edge.predicted.beside[i] = predicted_corner(slot, of_face[third]);
  }
  const auto out_of = [](const MovingEdge::Place& place, const Vector<3>& centroid) {
    return Vector<3>(0.5 * (place.end[0] + place.end[1]) - centroid);
  };
  edge.now.outwards = out_of(edge.now, pose_now(slot).position);
  edge.predicted.outwards = out_of(edge.predicted, predicted_pose(slot).position);
  return edge;
}

/// Each edge between two faces at the surface is that of the first of the cells that share it.
template <>
void PointContactSearch<3>::rebuild_surface_edges() {
  sides_.clear();
  for (const SurfaceCell<3>& cell : blocks_.meshes().surface()) {
    for (std::size_t opposite = 0; opposite < 4; ++opposite) {
      if (!(cell.outer_faces >> opposite & 1)) continue;
      for (std::size_t beside = 0; beside < 4; ++beside) {
        if (beside == opposite) continue;
        SideOfEdge side{{-1, -1}, cell.block, cell.node[beside]};
        for (std::size_t i = 0; i < 4; ++i) {
          if (i != opposite && i != beside) side.node[side.node[0] < 0 ? 0 : 1] = cell.node[i];
        }
        std::sort(side.node.begin(), side.node.end());
        sides_.push_back(side);
      }
    }
  }
  std::sort(sides_.begin(), sides_.end(), [](const SideOfEdge& one, const SideOfEdge& other) {
    return std::tie(one.node, one.block, one.beside) < std::tie(other.node, other.block, other.beside);
  });
  edges_.clear();
  for (std::size_t i = 0; i + 1 < sides_.size(); ++i) {
    const SideOfEdge &one = sides_[i], &other = sides_[i + 1];
    if (one.node != other.node) continue;
    edges_.push_back({one.block, one.node, {one.beside, other.beside}});
    ++i;
  }
  std::sort(edges_.begin(), edges_.end(), [](const SurfaceEdge& one, const SurfaceEdge& other) {
    return std::tie(one.block, one.node) < std::tie(other.block, other.node);
  });
  first_edge_.assign(blocks_.slot_count() + 1, 0);
  for (const SurfaceEdge& edge : edges_) ++first_edge_[std::size_t(edge.block) + 1];
  for (std::size_t i = 0; i + 1 < first_edge_.size(); ++i) first_edge_[i + 1] += first_edge_[i];
}

/// Edges turn within a motion: they meet where the plane between them keeps both apart at its start or at its
/// end.
template <>
void PointContactSearch<3>::find_edge_edge(std::int32_t a, std::int32_t b,
                                           Array<ContactConstraint<3>>& found) const {
  const double max_behind = other_side * blocks_.radius[std::size_t(b)];
  // Two edges that are farther apart cannot meet in this motion.
  const double reach = margin_ + integrator_.longest_motion() + max_behind;
  const EdgeBound about_b{blocks_.position[std::size_t(b)], blocks_.radius[std::size_t(b)]};
  for (int i = 0; i < edge_count(std::size_t(a)); ++i) {
    const EdgeBound about_edge = bound_of_edge(a, i);
    if (!about_edge.is_near(about_b, reach)) continue;
    const MovingEdge of_a = edge(a, i);
    if (!of_a.now.is_sharp()) continue;
    for (int k = 0; k < edge_count(std::size_t(b)); ++k) {
      if (!about_edge.is_near(bound_of_edge(b, k), reach)) continue;
      const MovingEdge of_b = edge(b, k);
      if (!of_b.now.is_sharp() || are_parallel(of_a.now, of_b.now)) continue;
      if (!is_between(of_a.now, of_b.now) && !is_between(of_a.predicted, of_b.predicted)) continue;
      // A corner that slides along a face falls a little behind it, until it is held: its edge is none that
      // meets another there.
      const NearestPlaces at_end = nearest(of_a.predicted, of_b.predicted);
      if (!nearest(of_a.now, of_b.now).is_between_ends() || !at_end.is_between_ends()) continue;
      const Vector<3> normal = normal_of(of_a.now, of_b.now);
      const double before = normal.dot(of_a.now.end[0] - of_b.now.end[0]);
      const double after = normal.dot(of_a.predicted.at(at_end.on_a) - of_b.predicted.at(at_end.on_b));
      if (after > margin_ || before < -max_behind) continue;
      ContactConstraint<3> at;
      at.a = a;
      at.b = b;
      at.meeting = Meeting::edges;
      at.feature_a = i;
      at.feature_b = k;
      if (before > 0) at.impact_fraction = after < 0 ? before / (before - after) : 1;
      found.push_back(at);
    }
  }
}

/// The points where both edges are nearest to each other.
template <>
void PointContactSearch<3>::place_edges(ContactConstraint<3>& at) const {
  const MovingEdge of_a = edge(at.a, at.feature_a), of_b = edge(at.b, at.feature_b);
  const NearestPlaces near = nearest(of_a.now, of_b.now);
  at.normal = normal_of(of_a.now, of_b.now);
  at.gap = at.normal.dot(of_a.now.end[0] - of_b.now.end[0]);
  const auto point_on = [](const MovingEdge& edge, double share) {
    MaterialPoint<3> point = edge.end[0];
    point.node[1] = edge.end[1].node[0];
    point.weight = (point.weight[0] * Vector<3>(1 - share, share, 0)).eval();
    point.arm = (1 - share) * edge.end[0].arm + share * edge.end[1].arm;
    return point;
  };
  at.of_a = point_on(of_a, near.on_a);
  at.of_b = point_on(of_b, near.on_b);
}

template <>
double PointContactSearch<3>::predicted_gap_of_edges(const ContactConstraint<3>& at) const {
  const MovingEdge of_a = edge(at.a, at.feature_a), of_b = edge(at.b, at.feature_b);
  const Vector<3> normal = normal_of(of_a.predicted, of_b.predicted);
  const double gap = normal.dot(of_a.predicted.end[0] - of_b.predicted.end[0]);
  return normal.dot(at.normal) > 0 ? gap : -gap;
}

}  // namespace halfspace
