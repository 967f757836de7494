#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/outline.h"
#include "narrow_phase/frames.h"

namespace halfspace {

/// A vertex of one polygon and the point of an edge of the other that is closest to it, relative to the
/// centroid of a, in the orientation of a.
struct VertexAndEdge {
  double distance = HUGE_VAL;
  Vector<2> on_a;
  Vector<2> on_b;
  Vector<2> normal;  // from a to b
};

/// Tests all vertices with all edges of separated polygons, for polygons too narrow and too close for GJK.
inline VertexAndEdge closest_vertex_and_edge(const Outline<2>& a, const Outline<2>& b,
                                             const Frames<2>& frames) {
  const Rotation<2> b_in_a = frames.b_in_a();
  VertexAndEdge best;
  const auto look_at = [&](int owner, int edge, int vertex) {
    const Outline<2>& own = owner == 0 ? a : b;
    const Vector<2> seen = owner == 0 ? Vector<2>(b_in_a * b.vertex(vertex) + frames.to_b())
                                      : Vector<2>(b_in_a.inverse() * (a.vertex(vertex) - frames.to_b()));
    const Vector<2> start = own.vertex(edge), along = own.vertex(own.next(edge)) - start;
    const double part = along.dot(seen - start) / along.squaredNorm();
    const Vector<2> on_edge = start + std::clamp(part, 0.0, 1.0) * along;
    const bool is_inside = part > 0 && part < 1;
    const double distance =
        is_inside ? own.normal(edge).dot(seen) - own.offset[edge] : (seen - on_edge).norm();
    if (!(distance > 0 && distance < best.distance)) return;
    const Vector<2> outwards = is_inside ? own.normal(edge) : Vector<2>((seen - on_edge) / distance);
    best = owner == 0 ? VertexAndEdge{distance, on_edge, seen, outwards}
                      : VertexAndEdge{distance, a.vertex(vertex), b_in_a * on_edge + frames.to_b(),
                                      -(b_in_a * outwards)};
  };
  for (int edge = 0; edge < a.count; ++edge) {
    for (int vertex = 0; vertex < b.count; ++vertex) look_at(0, edge, vertex);
  }
  for (int edge = 0; edge < b.count; ++edge) {
    for (int vertex = 0; vertex < a.count; ++vertex) look_at(1, edge, vertex);
  }
  return best;
}

}  // namespace halfspace
