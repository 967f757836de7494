#pragma once

#include <algorithm>

#include "geometry/tolerances.h"
#include "narrow_phase/space/manifold_faces.h"
#include "narrow_phase/space/pair.h"
#include "narrow_phase/space/potential_pairs.h"

namespace halfspace {

/// An edge of each block, each relative to its own block's centroid.
struct MeetingEdges {
  SeenEdge a;
  SeenEdge b;
  Parallelogram parallelogram{a, b.along};

  template <class Block>
  MeetingEdges(const Block& block_a, const Block& block_b, const PotentialPair<3>& pair)
      : a(block_a, pair.a), b(block_b, pair.b) {}

  /// False for nearly parallel edges, which have no plane.
  bool are_potential_pair() const {
    return !are_all_but_parallel(parallelogram.square, a.along.squaredNorm(), b.along.squaredNorm()) &&
           is_edge_pair(a, b, parallelogram.normal());
  }

  /// Are they certainly a potential pair, with no face at either edge nearly parallel to their plane? By the
  /// four signs of edge and face normal (docs/theory.md), with a margin: at the edge of a, the sine of the
  /// angle between face and plane is left . along_b |along_a| / area. False for nearly parallel edges, which
  /// have no plane.
  bool cross_steeply(double region_angle) const {
    const double a_left = a.left.dot(b.along), a_right = a.right.dot(b.along);
    const double b_left = b.left.dot(a.along), b_right = b.right.dot(a.along);
    const double sense = a_left < 0 ? -1 : 1;
    const double min_of_a = std::min(sense * a_left, -sense * a_right);
    const double min_of_b = std::min(sense * b_left, -sense * b_right);
    const double a_square = a.along.squaredNorm(), b_square = b.along.squaredNorm();
    const double area_square = parallelogram.square;
    const double steep = proof_margin *
                         std::max(region_angle * region_angle, strictly_parallel * strictly_parallel) *
                         area_square;
    return min_of_a > 0 && min_of_b > 0 && min_of_a * min_of_a * a_square > steep &&
           min_of_b * min_of_b * b_square > steep && !are_all_but_parallel(area_square, a_square, b_square);
  }
};

/// The nearest points of the lines of two edges, as fractions of the edges' lengths.
struct NearestPoints {
  Vector<3> between;  // from the start of one edge to that of the other
  double share_of_a;
  double share_of_b;

  NearestPoints(const MeetingEdges& edges, const Vector<3>& to_b)
      : between((edges.b.start - edges.a.start) + to_b),
        share_of_a(cross_product(between, edges.b.along).dot(edges.parallelogram.across) /
                   edges.parallelogram.square),
        share_of_b(cross_product(between, edges.a.along).dot(edges.parallelogram.across) /
                   edges.parallelogram.square) {}

  bool are_on_edges() const {
    return share_of_a >= 0 && share_of_a <= 1 && share_of_b >= 0 && share_of_b <= 1;
  }
};

/// Describes the contact at the midpoint of the nearest points of two edges.
[[gnu::always_inline]] inline void describe_edge_edge(const MeetingEdges& edges, const NearestPoints& nearest,
                                                      const Vector<3>& to_b, Contact<3>& contact) {
  const Vector<3> on_a = edges.a.start + std::clamp(nearest.share_of_a, 0.0, 1.0) * edges.a.along;
  const Vector<3> on_b = (edges.b.start + to_b) + std::clamp(nearest.share_of_b, 0.0, 1.0) * edges.b.along;
  const Vector<3> normal = edges.parallelogram.normal();
  contact.normal = normal;
  contact.gap = normal.dot(nearest.between);
  describe_point(ContactType::edge_edge, 0.5 * (on_a + on_b), contact);
}

/// The faces at two edges. Their vertices are only starts of a search.
struct FacesAtEdges {
  PotentialPair<3> pair[4];

  FacesAtEdges(const SeenOutline& a, const SeenOutline& b, const PotentialPair<3>& edges) {
    using Pair = PotentialPair<3>;
    const Topology &of_a = *a.topology, &of_b = *b.topology;
    pair[0] = {Pair::face_vertex, of_a.edge_left[edges.a], of_b.edge_start[edges.b]};
    pair[1] = {Pair::face_vertex, of_a.edge_right[edges.a], of_b.edge_start[edges.b]};
    pair[2] = {Pair::vertex_face, of_a.edge_start[edges.a], of_b.edge_left[edges.b]};
    pair[3] = {Pair::vertex_face, of_a.edge_start[edges.a], of_b.edge_right[edges.b]};
  }

  /// The potential pair of smallest depth, with its vertex updated.
  PotentialPair<3> shallowest(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b) {
    int best = 0;
    double best_gap = -HUGE_VAL;
    for (int i = 0; i < 4; ++i) {
      const double gap = refresh(a, b, to_b, pair[i]);
      if (gap <= best_gap) continue;
      best = i;
      best_gap = gap;
    }
    return pair[best];
  }
};

}  // namespace halfspace
