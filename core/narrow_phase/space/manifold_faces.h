#pragma once

#include "narrow_phase/contact.h"
#include "narrow_phase/space/seen_outline.h"

namespace halfspace {

/// A face and a vertex, relative to the centroid of the face's owner.
template <class Block>
struct FaceVertex {
  const Block& owner;
  const Block& other;
  Vector<3> to_other;
  int face;
  int vertex;
  Vector<3> normal = owner.normal(face);
  Vector<3> position = other.vertex(vertex);  // of the vertex, relative to its own block's centroid
  double gap = (normal.dot(position) + normal.dot(to_other)) - owner.offset[face];
  Vector<3> foot = (position + to_other) - gap * normal;  // of the vertex, on the face's plane
};

/// A contact at a point; its gap is set already.
[[gnu::always_inline]] inline void describe_point(ContactType type, const Vector<3>& point,
                                                  Contact<3>& contact) {
  contact.type = type;
  contact.area = contact.length = 0;
  contact.point_count = 1;
  contact.center = point;
  contact.points[0] = point;
  contact.center_gap = contact.gaps[0] = contact.gap;
}

/// Describes the region of a face of a with a nearly parallel face, or else edge, of b at a vertex. False if
/// there is none.
bool describe_face_region(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                          const PotentialPair<3>& pair, const DetectOptions& options, Contact<3>& contact);

/// Describes a face of a and a vertex of b. Returns the pair, or the neighbouring one if the foot of the
/// vertex is outside the face; then the contact is at the edge or vertex of the face that was passed.
PotentialPair<3> describe_face_vertex(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b,
                                      const PotentialPair<3>& pair, const DetectOptions& options,
                                      Contact<3>& contact);

}  // namespace halfspace
