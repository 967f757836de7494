#include "manifold.h"

#include <algorithm>

namespace halfspace::box2d {
namespace {

/// A point of the incident edge, at the fraction `share` from its start.
struct EdgePoint {
  double share;
  b2ContactFeature feature;  // with the reference face as A
};

b2ContactFeature vertex_on_face(int face, int vertex) {
  return {uint8(face), uint8(vertex), b2ContactFeature::e_face, b2ContactFeature::e_vertex};
}
b2ContactFeature end_of_face_on_edge(int end, int edge) {
  return {uint8(end), uint8(edge), b2ContactFeature::e_vertex, b2ContactFeature::e_face};
}
b2ContactFeature swapped(const b2ContactFeature& f) { return {f.indexB, f.indexA, f.typeB, f.typeA}; }

}  // namespace

void write_manifold(const SeenFromFace& seen, const Face& face, int deepest, double radii,
                    b2Manifold& manifold) {
  manifold.pointCount = 0;
  const Polygon &owner = seen.owner, &other = seen.other;
  const Vector normal = owner.normal(face.edge);
  const Vector tangent = {-normal.y, normal.x};
  const int first = face.edge, second = owner.next(first);
  const double low = dot(tangent, owner.vertex(first)) - radii;
  const double high = dot(tangent, owner.vertex(second)) + radii;

  const int edge = incident_edge(seen, deepest);
  const int ends[2] = {edge, other.next(edge)};
  double along[2], gap[2];
  for (int i = 0; i < 2; ++i) {
    const Vector end = seen.at.turn * other.vertex(ends[i]) + seen.at.shift;
    along[i] = dot(tangent, end);
    gap[i] = dot(normal, end) - owner.offset(face.edge);
  }
  if (std::max(along[0], along[1]) < low || std::min(along[0], along[1]) > high) return;

  // An end outside the strip is clipped to its boundary, where the end of the face meets the edge.
  EdgePoint points[2];
  for (int i = 0; i < 2; ++i) {
    const double within = std::clamp(along[i], low, high);
    if (within == along[i]) {
      points[i] = {double(i), vertex_on_face(face.edge, ends[i])};
    } else {
      points[i] = {(within - along[0]) / (along[1] - along[0]),
                   end_of_face_on_edge(within == low ? first : second, edge)};
    }
  }

  manifold.type = face.owner == 0 ? b2Manifold::e_faceA : b2Manifold::e_faceB;
  manifold.localNormal = rounded(normal);
  manifold.localPoint = rounded(0.5 * (owner.vertex(first) + owner.vertex(second)) + owner.centroid());
  const auto between = [](const auto& from, const auto& to, double share) {
    return (1 - share) * from + share * to;
  };
  for (const EdgePoint& point : points) {
    if (between(gap[0], gap[1], point.share) > radii) continue;
    b2ManifoldPoint& out = manifold.points[manifold.pointCount++];
    out.localPoint =
        rounded(between(other.vertex(ends[0]), other.vertex(ends[1]), point.share) + other.centroid());
    out.id.cf = face.owner == 0 ? point.feature : swapped(point.feature);
  }
}

}  // namespace halfspace::box2d
